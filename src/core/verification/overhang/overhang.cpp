// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/verification/overhang/overhang_settings.hpp"
#include "toolpath/deposited_segment.hpp"
#include "verification/overhang/bead_grid.hpp"
#include "verification/overhang/deposited_beads.hpp"

namespace lamina {
namespace {

/// A place of a bead that is being deposited [frame of the layers].
struct LayingPlace {
  Point3 middle = Point3::Zero();       ///< of the section [mm]
  Point3 along = Point3::UnitX();       ///< of unit length; zero for a drop
  Point3 tool_axis = -Point3::UnitZ();  ///< of unit length, z negative
  Bead section;
  std::size_t bead = 0;  ///< index; those before it are deposited already
};

/// What carries beads: the bed, and the beads deposited before (`findOverhangs`).
class Support {
 public:
  /// @param beads     must outlive the support
  /// @param sideways  the most that any tool axis goes along the layers, per depth
  Support(const std::vector<DepositedBead>& beads, const Eigen::Isometry3d& bed_from_layers,
          const OverhangSettings& settings, double sideways);

  bool carries(const LayingPlace& place) const;

 private:
  bool bedCarries(const LayingPlace& place) const;
  bool beadsCarry(const LayingPlace& place) const;
  double besideMiddle(const Bead& section) const { return (0.5 - settings_.overlap) * section.width_mm; }

  const std::vector<DepositedBead>& beads_;
  OverhangSettings settings_;
  Point3 up_;         ///< away from the bed
  double bed_level_;  ///< along `up_` [mm]
  Bead largest_;      ///< greatest width and height of all sections
  BeadGrid grid_;
};

constexpr double kRounding = 0.005;  // mm: the decimals of a program
constexpr double kBelow = 0.25;      // of the height: a middle line less far along the tool axis lies beside

Bead largestSection(const std::vector<DepositedBead>& beads) {
  Bead largest;
  for (const DepositedBead& bead : beads) {
    largest.width_mm = std::max(largest.width_mm, bead.section.width_mm);
    largest.height_mm = std::max(largest.height_mm, bead.section.height_mm);
  }
  return largest;
}

/// How far from a place half way down its ray a bead may be that carries it.
double greatestMargin(const Bead& largest, const OverhangSettings& settings, double sideways) {
  const double half_depth = 0.5 * ((settings.reach + 0.5) * largest.height_mm + kRounding);
  return (0.5 - settings.overlap) * largest.width_mm + kRounding + sideways * half_depth;
}

/// Where on the bead, 0 to 1, the plane of the layers sees it nearest to the place.
double nearestOn(const DepositedBead& bead, const Point2& place) {
  const Point2 along = (bead.end - bead.start).head<2>();
  const double squared = along.squaredNorm();
  if (squared == 0.0) return 0.0;
  return std::clamp((place - bead.start.head<2>()).dot(along) / squared, 0.0, 1.0);
}

/// Where a ray along the tool axis is when it has gone so deep.
Point2 atDepth(const LayingPlace& place, double depth) {
  return place.middle.head<2>() - depth / place.tool_axis.z() * place.tool_axis.head<2>();
}

Support::Support(const std::vector<DepositedBead>& beads, const Eigen::Isometry3d& bed_from_layers,
                 const OverhangSettings& settings, double sideways)
    : beads_(beads),
      settings_(settings),
      up_(bed_from_layers.linear().transpose() * Point3::UnitZ()),
      bed_level_(-bed_from_layers.translation().z()),
      largest_(largestSection(beads)),
      grid_(beads, greatestMargin(largest_, settings, sideways)) {}

bool Support::carries(const LayingPlace& place) const { return bedCarries(place) || beadsCarry(place); }

bool Support::bedCarries(const LayingPlace& place) const {
  // The side of the bead that is nearer to the bed.
  const Point3 across = place.along.cross(Point3::UnitZ());
  const double beside = besideMiddle(place.section) * std::abs(up_.dot(across));
  const double height = up_.dot(place.middle) - bed_level_ - beside - kRounding;
  const double length = settings_.reach * place.section.height_mm / -place.tool_axis.z();
  return height <= std::max(0.0, -up_.dot(place.tool_axis) * length);
}

bool Support::beadsCarry(const LayingPlace& place) const {
  const double least_depth = kBelow * place.section.height_mm;
  const double reach = settings_.reach * place.section.height_mm + kRounding;
  const double beside = besideMiddle(place.section) + kRounding;
  const auto isMet = [&](std::size_t index) {
    if (index >= place.bead) return false;
    const DepositedBead& bead = beads_[index];
    const double half_height = 0.5 * bead.section.height_mm;
    const auto depthAt = [&](double t) {
      return place.middle.z() - (bead.start.z() + t * (bead.end.z() - bead.start.z()));
    };
    // The tool axis leads sideways by how deep it goes, which depends on where it meets a bead that rises.
    const double guess = nearestOn(bead, atDepth(place, depthAt(0.5)));
    const double t = nearestOn(bead, atDepth(place, depthAt(guess)));
    const double depth = depthAt(t);
    if (depth < least_depth || depth - half_height > reach) return false;
    const Point2 met = atDepth(place, depth);
    const Point2 on_bead = (bead.start + t * (bead.end - bead.start)).head<2>();
    const double near = 0.5 * bead.section.width_mm + beside;
    return (met - on_bead).squaredNorm() <= near * near;
  };
  const double deepest = reach + 0.5 * largest_.height_mm;
  return grid_.visitNear(atDepth(place, 0.5 * deepest), place.middle.z() - deepest,
                         place.middle.z() - least_depth, isMet);
}

/// A piece of a bead that is carried or not as a whole.
struct DepositedPiece {
  WaypointIndex at;
  PathRole role = PathRole::Infill;
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, part frame]
  Point3 end = Point3::Zero();
  Bead section;
  double length_mm = 0.0;
  bool is_carried = false;
};

/// Joins pieces in the order in which they are deposited to runs and stretches.
class StretchChain {
 public:
  /// @param layers  of the toolpath
  explicit StretchChain(std::size_t layers) { report_.layers.resize(layers); }

  /// A piece that does not start where the one before ended begins another run.
  void lay(const DepositedPiece& piece);
  /// Nothing is deposited for a while.
  void stop();
  /// All that was deposited; the chain is empty afterwards.
  OverhangReport finish();

 private:
  void close(StretchKind kind);
  StretchKind kindIfCarriedAgain() const;

  OverhangReport report_;
  std::optional<Point3> end_;                  ///< of the run under way
  WaypointIndex last_;                         ///< of the stretch's last piece
  std::optional<UnsupportedStretch> stretch_;  ///< under way
};

constexpr double kJoined = 1e-6;  // mm: as paths join

void StretchChain::lay(const DepositedPiece& piece) {
  if (end_ && (piece.start - *end_).norm() > kJoined) stop();
  LayerOverhang& layer = report_.layers[piece.at.layer];
  layer.deposited_mm += piece.length_mm;
  const bool begins_run = !end_;
  end_ = piece.end;
  if (begins_run) ++report_.runs;
  if (piece.is_carried) return close(kindIfCarriedAgain());
  if (begins_run) ++layer.starts_in_air;
  if (!stretch_) {
    stretch_.emplace();
    stretch_->at = piece.at;
    stretch_->role = piece.role;
    stretch_->begins_run = begins_run;
    stretch_->width_mm = piece.section.width_mm;
    stretch_->points = {piece.start};
  }
  stretch_->length_mm += piece.length_mm;
  if (stretch_->points.size() > 1 && piece.at == last_)
    stretch_->points.back() = piece.end;
  else if (piece.end != piece.start)
    stretch_->points.push_back(piece.end);
  last_ = piece.at;
}

void StretchChain::stop() {
  close(StretchKind::Overhang);
  end_.reset();
}

OverhangReport StretchChain::finish() {
  stop();
  return std::exchange(report_, OverhangReport());
}

StretchKind StretchChain::kindIfCarriedAgain() const {
  if (!stretch_ || stretch_->begins_run) return StretchKind::Overhang;
  const std::vector<Point3>& points = stretch_->points;
  const bool is_straight = std::all_of(points.begin(), points.end(), [&](const Point3& point) {
    return distanceToSegment(point, points.front(), points.back()) <= 0.5 * stretch_->width_mm;
  });
  return is_straight ? StretchKind::Bridge : StretchKind::Overhang;
}

void StretchChain::close(StretchKind kind) {
  if (!stretch_) return;
  stretch_->kind = kind;
  LayerOverhang& layer = report_.layers[stretch_->at.layer];
  (kind == StretchKind::Bridge ? layer.bridge_mm : layer.overhang_mm) += stretch_->length_mm;
  report_.stretches.push_back(std::move(*stretch_));
  stretch_.reset();
}

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
                             numberText(toDegrees(std::acos(std::clamp(-tool_axis.z(), -1.0, 1.0)))) +
                             " deg to the layers' normal; overhangs are found up to 84 deg");
        greatest = std::max(greatest, tool_axis.head<2>().norm() / -tool_axis.z());
      }
    }
  return greatest;
}

double lengthDeposited(const Path& path, const DepositedSegment& segment) {
  return path.deposit == Deposit::Drops ? segment.bead.width_mm : segment.length();
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
      forEachBead(path, [&](const DepositedSegment& segment) {
        const double length = lengthDeposited(path, segment);
        const std::size_t pieces = piecesOf(path, length, step_mm_);
        LayingPlace place;
        place.section = segment.bead;
        place.tool_axis = toolAxisAt(path, segment.waypoint, layers_from_part_);
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
      forEachBead(path, [&](const DepositedSegment& segment) {
        if (path.deposit == Deposit::Drops) chain.stop();
        DepositedPiece piece;
        piece.at = {layer, p, segment.waypoint};
        piece.role = path.role;
        piece.section = segment.bead;
        const double length = lengthDeposited(path, segment);
        const std::size_t pieces = piecesOf(path, length, step_mm_);
        piece.length_mm = length / static_cast<double>(pieces);
        const Point3& start = segment.start;
        const Point3 along = segment.end - start;
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
