// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_filling.hpp"

#include <algorithm>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "voids/drops/disc_picture.hpp"
#include "voids/drops/drop_void_kind.hpp"
#include "voids/drops/void_line.hpp"

namespace lamina {
namespace {

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
    tell();
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

  void tell() {
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
    throw InvalidInput("diameter of drops is " + std::to_string(layer.diameter_mm) + " mm; must be positive");
  return LayerFilling(layer, settings).fill();
}

std::vector<Point2> newDrops(const std::vector<DropVoid>& voids) {
  std::vector<Point2> drops;
  for (const DropVoid& filled : voids) drops.insert(drops.end(), filled.drops.begin(), filled.drops.end());
  return drops;
}

}  // namespace lamina
