// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/deposited_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/toolpath/layer_frame.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {
namespace {

constexpr double kWidthsPerPiece = 10.0;
constexpr double kLeastTop = 0.25;  // of the width: what a bead as high as wide has of a top

/// Lays the beads of a toolpath as boxes.
class BoxLayer {
 public:
  BoxLayer(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part, double tolerance_mm)
      : bed_from_part_(bed_from_part),
        layer_normal_(bed_from_part.linear() * layerNormal(toolpath)),
        has_plane_layers_(hasPlaneLayers(toolpath)),
        tolerance_mm_(tolerance_mm) {}

  void lay(const Path& path, const WaypointIndex& at, std::vector<DepositedBox>& boxes) const {
    const std::size_t pieces = piecesDepositedAt(path, at.waypoint, tolerance_mm_);
    if (pieces == 0) return;
    const Point3 end = bed_from_part_ * path.points[at.waypoint];
    const bool is_drop = path.deposit == Deposit::Drops;
    const std::size_t before = at.waypoint == 0 ? path.points.size() - 1 : at.waypoint - 1;
    const Point3 along =
        is_drop ? Point3(Point3::Zero()) : Point3(end - bed_from_part_ * path.points[before]);
    const Bead& bead = path.bead.at(at.waypoint);
    const Eigen::Matrix3d axes = beadAxes(along, normalAt(path, at.waypoint));
    const double width = std::max(topWidth(bead) - 2.0 * tolerance_mm_, tolerance_mm_);
    const double length = is_drop ? width : along.norm() / static_cast<double>(pieces);
    DepositedBox box;
    box.rotation = Eigen::Quaterniond(axes).cast<float>();
    box.size = Point3(length, width, bead.height_mm - tolerance_mm_).cast<float>();
    box.deposited = at;
    const Point3 up = axes.col(2);
    for (std::size_t i = 0; i < pieces; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(pieces);
      // The tolerance lowers its top.
      box.middle = sectionMiddle(end + (share - 1.0) * along, bead.height_mm + tolerance_mm_, up);
      boxes.push_back(box);
    }
  }

 private:
  /// Layers that are not plane lean against each other: there the rounded flanks of a bead count for nothing,
  /// since a nozzle comes near their tops, not their middles.
  double topWidth(const Bead& bead) const {
    if (has_plane_layers_) return bead.width_mm;
    return std::max(bead.width_mm - bead.height_mm, kLeastTop * bead.width_mm);
  }

  /// Layers that are not plane are deposited against the tool axis.
  Point3 normalAt(const Path& path, std::size_t waypoint) const {
    if (has_plane_layers_) return layer_normal_;
    return bed_from_part_.linear() * upAt(path, waypoint);
  }

  Eigen::Isometry3d bed_from_part_;
  Point3 layer_normal_;
  bool has_plane_layers_;
  double tolerance_mm_;
};

}  // namespace

Eigen::Isometry3d DepositedBox::pose() const {
  return Eigen::Translation3d(middle) * rotation.cast<double>().normalized();
}

std::size_t piecesDepositedAt(const Path& path, std::size_t waypoint, double tolerance_mm) {
  const Bead& bead = path.bead.at(waypoint);
  if (path.role == PathRole::Travel || !(bead.width_mm > 2.0 * tolerance_mm) ||
      !(bead.height_mm > tolerance_mm))
    return 0;
  if (path.deposit == Deposit::Drops) return 1;
  if (waypoint == 0 && !path.is_closed) return 0;
  const Point3& start = path.points[waypoint == 0 ? path.points.size() - 1 : waypoint - 1];
  const double length = (path.points[waypoint] - start).norm();
  return static_cast<std::size_t>(std::ceil(length / (kWidthsPerPiece * bead.width_mm)));
}

DepositedBoxes depositedBoxes(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                              double tolerance_mm) {
  const BoxLayer layer(toolpath, bed_from_part, tolerance_mm);
  DepositedBoxes deposited;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    deposited.before_layer.push_back(deposited.boxes.size());
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      // The return of a closed path to its first waypoint comes last.
      const std::size_t count = paths[p].points.size();
      for (std::size_t w = paths[p].is_closed ? 1 : 0; w < count; ++w)
        layer.lay(paths[p], {l, p, w}, deposited.boxes);
      if (paths[p].is_closed) layer.lay(paths[p], {l, p, 0}, deposited.boxes);
    }
  }
  return deposited;
}

}  // namespace lamina
