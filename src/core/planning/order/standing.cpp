// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/standing.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "base/decimals.hpp"
#include "geometry/spatial/edge_bands.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/order/support_test.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kGreatestGap = 1.0;  // bead widths, between what carries and the first bead on it
constexpr int kShownDigits = 3;

double greatestGap(const CarriedLayers& carried) { return kGreatestGap * carried.bead_width_mm; }

bool isLevel(const BedPlane& bed) { return bed.up.head<2>().isZero(); }

/// Islands of a layer, moved to near the origin.
struct PrintedIslands {
  Point2 away = Point2::Zero();
  Regions islands;             ///< that get beads
  std::vector<Point2> starts;  ///< of a run of each
  Regions bare;                ///< without beads, as the sharp edge that an overhang begins with
};

PrintedIslands printedIslands(const PlannedStack& stack, std::size_t index) {
  const Layer& layer = stack.carried.layers[index];
  PrintedIslands printed;
  printed.away = distanceFromOrigin(layer);
  const std::vector<Path>& paths = stack.toolpath[index].paths;
  for (Region& island : unite(moved(layer, -printed.away).section.contours)) {
    const EdgeBands edges(Regions{island});
    const auto run = std::find_if(paths.begin(), paths.end(), [&](const Path& path) {
      return isPartOfPart(path) && edges.enclose(path.firstPoint().head<2>() - printed.away);
    });
    if (run == paths.end()) {
      printed.bare.push_back(std::move(island));
      continue;
    }
    printed.starts.push_back(run->firstPoint().head<2>());
    printed.islands.push_back(std::move(island));
  }
  return printed;
}

/// Supports up to a layer, and what is as near to them as a bead is wide.
Regions nearSupports(const CarriedLayers& carried, std::size_t index, const Point2& away) {
  if (carried.supports.empty() || carried.supports[index].empty()) return {};
  return offset(moved(carried.supports[index], -away), greatestGap(carried));
}

/// The layer before and supports, and what is as near to them as a bead is wide. A bare island on a support
/// lets that carry what lies on it.
Regions nearCarrying(const CarriedLayers& carried, std::size_t index, const PrintedIslands* below,
                     const Point2& away) {
  std::vector<Polygon> carrying = outlines(nearSupports(carried, index, away));
  if (below != nullptr) {
    Regions solid = below->islands;
    const Regions held = nearSupports(carried, index - 1, below->away);
    for (const Region& bare : below->bare)
      if (!intersection({bare}, held).empty()) solid.push_back(bare);
    if (!solid.empty())
      for (Polygon& outline : outlines(offset(moved(solid, below->away - away), greatestGap(carried))))
        carrying.push_back(std::move(outline));
  }
  return unite(carrying);
}

/// Where runs of islands begin that nothing carries, one of each.
std::vector<Point2> floatingIn(const CarriedLayers& carried, std::size_t index, const PrintedIslands& own,
                               const PrintedIslands* below) {
  const Regions near = nearCarrying(carried, index, below, own.away);
  const SupportTest support_test = supportTestOf(carried, index);
  const auto isNearBed = [&](const Point2& corner) {
    return support_test.gapToBed(corner + own.away) <= greatestGap(carried);
  };
  std::vector<Point2> found;
  for (std::size_t i = 0; i < own.islands.size(); ++i) {
    const Region& island = own.islands[i];
    if (!intersection({island}, near).empty()) continue;
    if (std::none_of(island.outer.begin(), island.outer.end(), isNearBed)) found.push_back(own.starts[i]);
  }
  return found;
}

std::string advice(const CarriedLayers& carried) {
  const std::string supports = carried.supports.empty()
                                   ? "supports.use true holds it up"
                                   : "supports that reach it (supports.least_width_mm) hold it up";
  return supports +
         ", a part turned so that it stands on an edge or a face along slicing.plane begins on the bed, and "
         "anchoring.strategy 'where_possible' lays it in the air";
}

void requireFirstLayer(double gap_mm, const CarriedLayers& carried) {
  const double greatest_mm = greatestGap(carried);
  if (gap_mm <= greatest_mm) return;
  throw InvalidInput("the first layer of the part lies " + significantText(gap_mm, kShownDigits) +
                     " mm above the bed, and nothing is below it; expected at most " +
                     significantText(greatest_mm, kShownDigits) +
                     " mm, the width of a bead: " + advice(carried));
}

std::string placeText(const Point3& place) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f) mm", place.x(), place.y(), place.z());
  return text;
}

}  // namespace

FloatingIslands floatingIslands(const PlannedStack& stack) {
  const CarriedLayers& carried = stack.carried;
  if (isLevel(carried.bed)) return {};
  NoProgress nobody;
  std::vector<PrintedIslands> printed(carried.layers.size());
  parallelFor(
      printed.size(), [&](std::size_t i) { printed[i] = printedIslands(stack, i); }, nobody, "plan");
  std::vector<std::vector<Point2>> found(printed.size());
  const auto look = [&](std::size_t i) {
    const PrintedIslands* below = i > 0 ? &printed[i - 1] : nullptr;
    if (stack.starts[i].empty() && (below == nullptr || below->bare.empty())) return;
    found[i] = floatingIn(carried, i, printed[i], below);
  };
  parallelFor(found.size(), look, nobody, "plan");
  FloatingIslands floating;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (floating.count == 0 && !found[i].empty()) {
      floating.first_layer = i;
      floating.first_mm = {found[i].front().x(), found[i].front().y(), carried.layers[i].bounds.top_mm};
    }
    floating.count += found[i].size();
  }
  return floating;
}

void requireStanding(const PlannedStack& stack, const Eigen::Isometry3d& part_from_layers) {
  requireFirstLayer(gapBelowPart(stack.carried, stack.toolpath), stack.carried);
  const FloatingIslands floating = floatingIslands(stack);
  if (floating.count == 0) return;
  throw InvalidInput("islands of layers that begin in mid-air: " + std::to_string(floating.count) +
                     ", the first in layer " + std::to_string(floating.first_layer) + " at " +
                     placeText(part_from_layers * floating.first_mm) +
                     " of the part; expected bed, layer before or support within " +
                     significantText(greatestGap(stack.carried), kShownDigits) +
                     " mm of each, the width of a bead: " + advice(stack.carried));
}

}  // namespace lamina
