// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/beads/void_class.hpp"
#include "lamina/voids/beads/void_points.hpp"
#include "lamina/voids/drops/drop_layer.hpp"
#include "voids/drops/disc_picture.hpp"

namespace lamina {
namespace {

constexpr double kTie = 1e-9;   // of a diameter: rounding
constexpr double kStep = 1e-6;  // of a step: drops exactly a step apart hang together

PointGrid gridOf(const std::vector<VoidPoint>& points, double cell) {
  Box2 box;
  for (const VoidPoint& point : points) box.include(point.position);
  PointGrid grid(box, cell);
  for (const VoidPoint& point : points) grid.insert(point.position);
  return grid;
}

/// Farthest from the middle; the points are sorted, so that the first of equals is the one wanted.
std::uint32_t lineEnd(const std::vector<VoidPoint>& points, double tie) {
  Point2 middle = Point2::Zero();
  for (const VoidPoint& point : points) middle += point.position / static_cast<double>(points.size());
  std::uint32_t end = 0;
  double farthest = -1.0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i].position - middle).norm();
    if (distance <= farthest + tie) continue;
    farthest = distance;
    end = i;
  }
  return end;
}

/// Groups of points that hang together by steps no longer than `step_mm`, each by x and then y as they came,
/// the groups in the order of their first points.
std::vector<std::vector<VoidPoint>> clusters(const std::vector<VoidPoint>& points, double step_mm) {
  const PointGrid grid = gridOf(points, step_mm);
  std::vector<std::size_t> group(points.size(), points.size());
  std::size_t count = 0;
  for (std::uint32_t first = 0; first < points.size(); ++first) {
    if (group[first] != points.size()) continue;
    std::vector<std::uint32_t> reached = {first};
    group[first] = count;
    while (!reached.empty()) {
      const std::uint32_t from = reached.back();
      reached.pop_back();
      grid.visitNear(points[from].position, (1.0 + kStep) * step_mm, [&](std::uint32_t i, double) {
        if (group[i] != points.size()) return;
        group[i] = count;
        reached.push_back(i);
      });
    }
    ++count;
  }
  std::vector<std::vector<VoidPoint>> found(count);
  for (std::size_t i = 0; i < points.size(); ++i) found[group[i]].push_back(points[i]);
  return found;
}

/// The points as a line: from the one farthest from their middle always on to the nearest. Of those equally
/// far the one of smaller x, then y, comes first.
std::vector<VoidPoint> guideLine(const std::vector<VoidPoint>& points, double diameter_mm) {
  if (points.empty()) return {};
  PointGrid left = gridOf(points, diameter_mm);
  std::vector<VoidPoint> line;
  std::optional<std::uint32_t> next = lineEnd(points, kTie * diameter_mm);
  while (next) {
    line.push_back(points[*next]);
    left.remove(*next);
    next = left.nearest(line.back().position, kTie * diameter_mm);
  }
  return line;
}

/// Reports the class of voids by the drops around them [Sobreviela2014, chapter 3].
class VoidKinds {
 public:
  VoidKinds(const DropLayer& layer, const std::vector<DropContour>& contours);

  /// With infill on one side and a contour on the other R1, or D1 if it is dense; with infill alone
  /// `Between`. With contours alone C1 if it is one that has no other inside, C2 if they follow an outline
  /// and a hole, C4 within two diameters of a corner of a contour below 60 degrees, otherwise C3.
  VoidClass kindOf(const std::vector<VoidPoint>& points) const;

 private:
  bool isInCorner(const std::vector<VoidPoint>& points) const;
  VoidClass kindOfContours(const std::vector<std::size_t>& contours,
                           const std::vector<VoidPoint>& points) const;

  const DropLayer& layer_;
  const std::vector<DropContour>& contours_;
  PointGrid drops_;
  PointGrid corners_;  ///< of contours, sharper than 60 degrees
  std::vector<DropRole> role_of_drop_;
  std::vector<std::size_t> contour_of_drop_;
};

constexpr std::size_t kNoContour = std::numeric_limits<std::size_t>::max();
constexpr double kCriticalCorner = toRadians(60.0);
constexpr double kBounding = 0.02;  // diameters: drops as far as the nearest bound a void

double cornerAngle(const Polygon& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Point2 back = outline[(i + n - 1) % n] - outline[i];
  const Point2 on = outline[(i + 1) % n] - outline[i];
  return std::abs(turn(back, on));
}

VoidKinds::VoidKinds(const DropLayer& layer, const std::vector<DropContour>& contours)
    : layer_(layer),
      contours_(contours),
      drops_(boundingBox({layer.drops}), layer.diameter_mm),
      corners_(boundingBox({layer.drops}), layer.diameter_mm),
      role_of_drop_(layer.drops.size(), DropRole::Infill),
      contour_of_drop_(layer.drops.size(), kNoContour) {
  for (const Point2& drop : layer.drops) drops_.insert(drop);
  for (const DropChain& chain : layer.chains)
    for (std::size_t i = chain.begin; i < chain.end; ++i) role_of_drop_[i] = chain.role;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const DropChain& chain = layer.chains[contours[c].chain];
    for (std::size_t i = chain.begin; i < chain.end; ++i) contour_of_drop_[i] = c;
    for (std::size_t i = 0; i < contours[c].outline.size(); ++i)
      if (cornerAngle(contours[c].outline, i) < kCriticalCorner) corners_.insert(contours[c].outline[i]);
  }
}

bool VoidKinds::isInCorner(const std::vector<VoidPoint>& points) const {
  return std::any_of(points.begin(), points.end(), [this](const VoidPoint& point) {
    return corners_.hasNearer(point.position, 2.0 * layer_.diameter_mm);
  });
}

VoidClass VoidKinds::kindOf(const std::vector<VoidPoint>& points) const {
  bool has_infill = false;
  std::vector<std::size_t> contours;
  for (const VoidPoint& point : points)
    drops_.visitNear(point.position, point.clearance_mm + kBounding * layer_.diameter_mm,
                     [&](std::uint32_t i, double) {
                       has_infill |= role_of_drop_[i] == DropRole::Infill;
                       if (contour_of_drop_[i] != kNoContour) contours.push_back(contour_of_drop_[i]);
                     });
  std::sort(contours.begin(), contours.end());
  contours.erase(std::unique(contours.begin(), contours.end()), contours.end());
  if (contours.empty()) return VoidClass::Between;
  if (has_infill) return layer_.is_dense ? VoidClass::DenseBorder : VoidClass::RasterBorder;
  return kindOfContours(contours, points);
}

VoidClass VoidKinds::kindOfContours(const std::vector<std::size_t>& contours,
                                    const std::vector<VoidPoint>& points) const {
  if (contours.size() == 1 && contours_[contours.front()].is_innermost) return VoidClass::Core;
  const auto is_hole = [this](std::size_t c) { return contours_[c].is_hole; };
  const auto holes = std::count_if(contours.begin(), contours.end(), is_hole);
  if (holes > 0 && static_cast<std::size_t>(holes) < contours.size()) return VoidClass::Meeting;
  return isInCorner(points) ? VoidClass::Corner : VoidClass::ShapeChange;
}

constexpr double kRounding = 1e-6;  // of a diameter

class LayerFilling {
 public:
  LayerFilling(const DropLayer& layer, const DropVoidSettings& settings)
      : layer_(layer),
        settings_(settings),
        contours_(contoursOf(layer)),
        borders_(borders(contours_)),
        search_{layer.diameter_mm, leastDistance(settings, layer.diameter_mm)},
        all_(layer.drops),
        deposited_(boundingBox({layer.drops}), layer.diameter_mm),
        marked_(boundingBox({layer.drops}), layer.diameter_mm) {}

  std::vector<DropVoid> fill() && {
    if (borders_.empty()) return {};
    bool is_going_on = true;
    while (is_going_on) {
      is_going_on = pass() > 0 && settings_.passes == VoidPasses::UntilFull;
      marked_by_passes_ = marked_.points().size();
    }
    report();
    return std::move(voids_);
  }

 private:
  /// @return how many drops it deposited
  std::size_t pass() {
    const std::vector<VoidPoint> found = inside(borders_, findVoidPoints(settings_.detector, all_, search_));
    const std::size_t before = deposited_.points().size();
    for (const std::vector<VoidPoint>& cluster : clusters(found, layer_.diameter_mm)) fillCluster(cluster);
    all_.insert(all_.end(), deposited_.points().begin() + static_cast<std::ptrdiff_t>(before),
                deposited_.points().end());
    return deposited_.points().size() - before;
  }

  void fillCluster(const std::vector<VoidPoint>& cluster) {
    const std::size_t index = voidOf(cluster);
    DropVoid& filled = voids_[index];
    for (const VoidPoint& point : guideLine(cluster, layer_.diameter_mm)) {
      filled.points.push_back(point);
      filled.greatest_clearance_mm = std::max(filled.greatest_clearance_mm, point.clearance_mm);
      marked_.insert(point.position);
      void_of_mark_.push_back(index);
      if (deposited_.hasNearer(point.position, search_.least_distance_mm - kRounding * layer_.diameter_mm))
        continue;
      deposited_.insert(point.position);
      filled.drops.push_back(point.position);
    }
  }

  /// What a later pass finds beside a void belongs to it.
  std::size_t voidOf(const std::vector<VoidPoint>& cluster) {
    for (const VoidPoint& point : cluster) {
      std::size_t found = voids_.size();
      marked_.visitNear(point.position, layer_.diameter_mm, [&](std::uint32_t i, double) {
        if (i < marked_by_passes_) found = std::min(found, void_of_mark_[i]);
      });
      if (found < voids_.size()) return found;
    }
    voids_.emplace_back();
    return voids_.size() - 1;
  }

  void report() {
    const VoidKinds kinds(layer_, contours_);
    const DiscPicture discs(layer_.drops, deposited_.points(), layer_.diameter_mm, borders_);
    for (DropVoid& filled : voids_) {
      filled.kind = kinds.kindOf(filled.points);
      const UncoveredArea area = discs.around(filled.points);
      filled.uncovered_before_mm2 = area.before_mm2;
      filled.uncovered_after_mm2 = area.after_mm2;
    }
  }

  const DropLayer& layer_;
  const DropVoidSettings& settings_;
  std::vector<DropContour> contours_;
  std::vector<Polygon> borders_;
  VoidSearch search_;
  std::vector<Point2> all_;  ///< prior drops and new ones
  PointGrid deposited_;      ///< new drops
  PointGrid marked_;         ///< points of voids
  std::vector<std::size_t> void_of_mark_;
  std::vector<DropVoid> voids_;
  std::size_t marked_by_passes_ = 0;  ///< points that passes before this one marked
};

}  // namespace

std::vector<DropVoid> fillDropVoids(const DropLayer& layer, const DropVoidSettings& settings) {
  if (!(layer.diameter_mm > 0.0))
    throw InvalidInput("diameter of drops is " + numberText(layer.diameter_mm) + " mm; must be positive");
  return LayerFilling(layer, settings).fill();
}

std::vector<Point2> newDrops(const std::vector<DropVoid>& voids) {
  std::vector<Point2> drops;
  for (const DropVoid& filled : voids) drops.insert(drops.end(), filled.drops.begin(), filled.drops.end());
  return drops;
}

}  // namespace lamina
