// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/starts_in_air.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lamina/base/parallel.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Supports begin on what the part does not show.
bool laysBeadsOfPart(const Path& path) { return isPartOfPart(path) && path.deposit == Deposit::Bead; }

/// Whether the first path of a layer goes on where the layer before ended.
bool continues(const ToolpathLayer& layer, const ToolpathLayer* before) {
  return before != nullptr && !before->paths.empty() && laysBeadsOfPart(before->paths.back()) &&
         before->paths.back().lastPoint() == layer.paths.front().firstPoint();
}

std::vector<Point2> startsIn(const ToolpathLayer& layer, bool continues, const SupportTest& support_test) {
  std::vector<Point2> starts;
  bool is_laying = continues;
  for (const Path& path : layer.paths) {
    const bool is_start = laysBeadsOfPart(path) && !is_laying;
    const Point2 start = path.firstPoint().head<2>();
    if (is_start && !support_test.carries(start)) starts.push_back(start);
    is_laying = laysBeadsOfPart(path);
  }
  return starts;
}

}  // namespace

SupportTest supportTestOf(const CarriedLayers& carried, std::size_t index) {
  const std::vector<Layer>& layers = carried.layers;
  return {layers[index],
          {index > 0 ? &layers[index - 1] : nullptr,
           carried.supports.empty() ? nullptr : &carried.supports[index]},
          carried.bed,
          {carried.bead_width_mm, layers[index].bounds.height()}};
}

StartsInAir startsInAir(const CarriedLayers& carried, const std::vector<ToolpathLayer>& toolpath) {
  StartsInAir starts(carried.layers.size());
  const auto find = [&](std::size_t i) {
    if (toolpath[i].paths.empty()) return;
    starts[i] = startsIn(toolpath[i], continues(toolpath[i], i > 0 ? &toolpath[i - 1] : nullptr),
                         supportTestOf(carried, i));
  };
  NoProgress nobody;
  parallelFor(carried.layers.size(), find, nobody, "plan");
  return starts;
}

std::size_t countOf(const StartsInAir& starts) {
  return std::accumulate(starts.begin(), starts.end(), std::size_t{0},
                         [](std::size_t sum, const std::vector<Point2>& each) { return sum + each.size(); });
}

double gapBelowPart(const CarriedLayers& carried, const std::vector<ToolpathLayer>& toolpath) {
  const auto laysAny = [](const ToolpathLayer& layer) {
    return std::any_of(layer.paths.begin(), layer.paths.end(), isPartOfPart);
  };
  const auto first = std::find_if(toolpath.begin(), toolpath.end(), laysAny);
  if (first == toolpath.end()) return 0.0;
  const SupportTest support_test = supportTestOf(carried, static_cast<std::size_t>(first - toolpath.begin()));
  double gap_mm = std::numeric_limits<double>::infinity();
  for (const Path& path : first->paths)
    for (const Point3& point : path.points) {
      if (!isPartOfPart(path)) continue;
      if (support_test.isOnSupport(point.head<2>())) return 0.0;
      gap_mm = std::min(gap_mm, support_test.gapToBed(point.head<2>()));
    }
  return std::max(gap_mm, 0.0);
}

}  // namespace lamina
