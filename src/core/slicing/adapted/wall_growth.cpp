// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/wall_growth.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "slicing/adapted/curves_between.hpp"
#include "slicing/adapted/growth.hpp"
#include "slicing/adapted/layer_gap.hpp"
#include "slicing/adapted/top_completion.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-6;  // of a step

AdaptedCurve lowest(const WallStrand& strand) {
  const WallContour& contour = strand.levels.front();
  return {true, contour.points, contour.axis, std::vector<double>(contour.points.size(), 0.0)};
}

AdaptedCurve nextCurve(const Growth& growth, std::size_t level, std::size_t points, const PlacedCurve& below,
                       double height_mm) {
  constexpr std::size_t kBlock = 128;  // points that are worth a task of their own
  std::vector<GrownPoint> grown(points);
  NoProgress unwatched;
  parallelFor((points + kBlock - 1) / kBlock,
              [&](std::size_t block) {
                for (std::size_t i = block * kBlock; i < std::min(points, (block + 1) * kBlock); ++i)
                  grown[i] = growth.towards(level, i, below, height_mm);
              },
              unwatched, "adapt");
  return curveThrough(grown, true, below);
}

double highest(const AdaptedCurve& curve) {
  double z = curve.points.front().z();
  for (const Point3& point : curve.points) z = std::max(z, point.z());
  return z;
}

void addLayers(std::vector<AdaptedLayer>& layers, std::vector<AdaptedCurve> curves) {
  for (AdaptedCurve& curve : curves) layers.push_back({{std::move(curve)}, {}});
}

}  // namespace

std::vector<AdaptedLayer> growWall(const Mesh& mesh, const WallStrand& strand, const GrowthSteps& steps,
                                   Progress& progress) {
  const Growth growth(strand);
  const std::size_t top = strand.levels.size() - 1;
  auto below = std::make_unique<PlacedCurve>(lowest(strand));
  std::vector<AdaptedLayer> layers;
  GrowthStep step = steps.first;
  for (;; step = steps.other) {
    throwIfCancelled(progress, "adapt");
    const std::size_t level = growth.firstAbove(highest(below->curve) + step.height_mm * (1.0 - kRounding));
    if (level > top || (level == top && !layers.empty())) break;
    AdaptedCurve curve = nextCurve(growth, level, strand.levels[level].points.size(), *below, step.height_mm);
    requireNoGap(curve, *below, {step.height_mm, steps.spacing_mm}, layers.size(), mesh);
    addLayers(layers, curvesBetween(*below, curve, step.parts));
    below = std::make_unique<PlacedCurve>(std::move(curve));
    progress.report("adapt", static_cast<double>(level) / static_cast<double>(top));
  }
  std::vector<GrowthStep> completing{steps.other};
  if (steps.other.parts > 1)
    completing.push_back({steps.other.height_mm / static_cast<double>(steps.other.parts), 1});
  std::vector<AdaptedLayer> rest = completedTop(mesh, strand, growth, std::move(below), completing);
  std::move(rest.begin(), rest.end(), std::back_inserter(layers));
  return layers;
}

}  // namespace lamina
