// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "verification/overhang/stretch_chain.hpp"
#include "verification/overhang/support.hpp"

namespace lamina {
namespace {

constexpr double kFlattestToolAxis = 0.1;  // cosine of 84 deg: beyond, a ray runs along the layer

Point3 toolAxisAt(const Path& path, std::size_t waypoint, const Eigen::Quaterniond& layers_from_part) {
  return layers_from_part * (path.orientation.at(waypoint) * Point3::UnitZ());
}

/// The most that any tool axis goes along the layers, per depth.
double greatestSideways(const Toolpath& toolpath) {
  const Eigen::Quaterniond layers_from_part = toolpath.part_from_layers.conjugate();
  double greatest = 0.0;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (const Path& path : toolpath.layers[l].paths) {
      if (!lays(path)) continue;
      for (std::size_t i = 0; i < path.orientation.values().size(); ++i) {
        const Point3 tool_axis = toolAxisAt(path, i, layers_from_part);
        if (!(tool_axis.z() <= -kFlattestToolAxis))
          throw InvalidInput("layer " + std::to_string(l) + ": the tool axis is inclined by " +
                             std::to_string(std::acos(std::clamp(-tool_axis.z(), -1.0, 1.0)) * 180.0 / M_PI) +
                             " deg to the layers' normal; overhangs are found up to 84 deg");
        greatest = std::max(greatest, tool_axis.head<2>().norm() / -tool_axis.z());
      }
    }
  return greatest;
}

double lengthDeposited(const Path& path, std::size_t waypoint) {
  if (path.deposit == Deposit::Drops) return path.bead.at(waypoint).width_mm;
  return (path.points[waypoint] - cameFrom(path, waypoint)).norm();
}

/// Into how many equal pieces a bead is cut; the middle of each is looked at.
std::size_t piecesOf(const Path& path, double length_mm, double step_mm) {
  if (path.deposit == Deposit::Drops) return 1;
  return static_cast<std::size_t>(std::ceil(length_mm / step_mm));
}

/// Looks at all pieces of a toolpath.
class Survey {
 public:
  Survey(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part, const OverhangSettings& settings)
      : toolpath_(toolpath),
        step_mm_(settings.step_mm),
        layers_from_part_(toolpath.part_from_layers.conjugate()),
        deposited_(depositedBeads(toolpath)),
        support_(deposited_.beads, bed_from_part * toolpath.part_from_layers, settings,
                 greatestSideways(toolpath)) {}

  /// Whether each piece of the layer is carried, in their order.
  std::vector<bool> lookAt(std::size_t layer) const {
    std::vector<bool> is_carried;
    std::size_t bead = deposited_.first_of_layer[layer];
    for (const Path& path : toolpath_.layers[layer].paths)
      forEachDeposited(path, [&](std::size_t waypoint) {
        const double length = lengthDeposited(path, waypoint);
        const std::size_t pieces = piecesOf(path, length, step_mm_);
        LayingPlace place;
        place.section = path.bead.at(waypoint);
        place.tool_axis = toolAxisAt(path, waypoint, layers_from_part_);
        place.bead = bead;
        const Point3& start = deposited_.beads[bead].start;
        const Point3 along = deposited_.beads[bead].end - start;
        place.along = path.deposit == Deposit::Drops ? Point3(Point3::Zero()) : Point3(along.normalized());
        for (std::size_t i = 0; i < pieces; ++i) {
          place.middle = start + (static_cast<double>(i) + 0.5) / static_cast<double>(pieces) * along;
          is_carried.push_back(support_.carries(place));
        }
        ++bead;
      });
    return is_carried;
  }

  /// Joins what was seen of a layer to what came before.
  void join(std::size_t layer, const std::vector<bool>& is_carried, StretchChain& chain) const {
    std::size_t next = 0;
    const std::vector<Path>& paths = toolpath_.layers[layer].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const Path& path = paths[p];
      if (!lays(path)) chain.stop();
      forEachDeposited(path, [&](std::size_t waypoint) {
        if (path.deposit == Deposit::Drops) chain.stop();
        DepositedPiece piece;
        piece.at = {layer, p, waypoint};
        piece.role = path.role;
        piece.section = path.bead.at(waypoint);
        const double length = lengthDeposited(path, waypoint);
        const std::size_t pieces = piecesOf(path, length, step_mm_);
        piece.length_mm = length / static_cast<double>(pieces);
        const Point3& start = cameFrom(path, waypoint);
        const Point3 along = path.points[waypoint] - start;
        for (std::size_t i = 0; i < pieces; ++i) {
          piece.start = start + static_cast<double>(i) / static_cast<double>(pieces) * along;
          piece.end = start + static_cast<double>(i + 1) / static_cast<double>(pieces) * along;
          piece.is_carried = is_carried[next++];
          chain.lay(piece);
        }
      });
    }
  }

 private:
  const Toolpath& toolpath_;
  double step_mm_;
  Eigen::Quaterniond layers_from_part_;
  DepositedBeads deposited_;
  Support support_;
};

}  // namespace

OverhangReport findOverhangs(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                             const OverhangSettings& settings, Progress& progress) {
  const Survey survey(toolpath, bed_from_part, settings);
  std::vector<std::vector<bool>> is_carried(toolpath.layers.size());
  parallelFor(
      is_carried.size(), [&](std::size_t l) { is_carried[l] = survey.lookAt(l); }, progress, "overhang");
  StretchChain chain(toolpath.layers.size());
  for (std::size_t l = 0; l < is_carried.size(); ++l) survey.join(l, is_carried[l], chain);
  return chain.finish();
}

}  // namespace lamina
