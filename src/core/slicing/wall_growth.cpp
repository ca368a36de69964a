// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/wall_growth.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "slicing/curves_between.hpp"
#include "slicing/growth.hpp"
#include "slicing/top_completion.hpp"

namespace lamina {
namespace {

AdaptedCurve lowest(const WallStrand& strand) {
  const WallContour& contour = strand.levels.front();
  return {true, contour.points, contour.axis, std::vector<double>(contour.points.size(), 0.0)};
}

AdaptedCurve nextCurve(const Growth& growth, std::size_t level, std::size_t points,
                       const PlacedCurve& beneath, double height_mm) {
  constexpr std::size_t kBlock = 128;  // points that are worth a task of their own
  std::vector<GrownPoint> grown(points);
  NoProgress unwatched;
  parallelFor((points + kBlock - 1) / kBlock,
              [&](std::size_t block) {
                for (std::size_t i = block * kBlock; i < std::min(points, (block + 1) * kBlock); ++i)
                  grown[i] = growth.towards(level, i, beneath, height_mm);
              },
              unwatched, "adapt");
  return curveThrough(grown, true, beneath);
}

void addLayers(std::vector<std::vector<AdaptedCurve>>& layers, std::vector<AdaptedCurve> curves) {
  for (AdaptedCurve& curve : curves) layers.push_back({std::move(curve)});
}

}  // namespace

WallGrowth growWall(const WallStrand& strand, const std::vector<GrowthStep>& steps,
                    const std::vector<GrowthStep>& completing, Progress& progress) {
  const Growth growth(strand);
  auto beneath = std::make_unique<PlacedCurve>(lowest(strand));
  WallGrowth wall;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    throwIfCancelled(progress, "adapt");
    AdaptedCurve curve =
        nextCurve(growth, k + 1, strand.levels[k + 1].points.size(), *beneath, steps[k].height_mm);
    addLayers(wall.layers, curvesBetween(*beneath, curve, steps[k].parts));
    beneath = std::make_unique<PlacedCurve>(std::move(curve));
    progress.report("adapt", static_cast<double>(k + 1) / static_cast<double>(steps.size()));
  }
  std::vector<std::vector<AdaptedCurve>> top = completedTop(strand, growth, std::move(beneath), completing);
  wall.completing = top.size();
  for (std::vector<AdaptedCurve>& layer : top) wall.layers.push_back(std::move(layer));
  return wall;
}

}  // namespace lamina
