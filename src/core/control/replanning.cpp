// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/replanning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "control/run_stretches.hpp"

namespace lamina {
namespace {

constexpr double kLeastScale = 0.7;
constexpr double kGreatestScale = 1.3;
constexpr double kWholeLayer = 0.75;  // layers off, from which one is added or left out
constexpr double kWideRegion = 3.0;   // bead widths

double totalOf(const std::vector<double>& heights) {
  return std::accumulate(heights.begin(), heights.end(), 0.0);
}

bool fits(double height, double planned, const LayerWindow& window) {
  return height >= std::max(kLeastScale * planned, window.least_mm) &&
         height <= std::min(kGreatestScale * planned, window.greatest_mm);
}

bool allFit(const std::vector<double>& planned, double scale, const LayerWindow& window) {
  return std::all_of(planned.begin(), planned.end(),
                     [&](double height) { return fits(scale * height, height, window); });
}

double flowOf(const PartUnderWay& part, const LayerWindow& window) {
  return std::clamp(1.0 / part.growth, 1.0 / window.greatest_flow, window.greatest_flow);
}

RegionStep stepOf(double error, double layer, bool is_wide) {
  if (error > kWholeLayer * layer) return is_wide ? RegionStep::AddLayer : RegionStep::FillBeads;
  if (error < -kWholeLayer * layer && is_wide) return RegionStep::SkipLayer;
  return RegionStep::None;
}

int sideOf(double error, double layer) {
  if (error > kWholeLayer * layer) return 1;
  return error < -kWholeLayer * layer ? -1 : 0;
}

}  // namespace

double expectedTopError(const PartUnderWay& part, const LayerAuthority& authority) {
  const double planned = totalOf(part.heights_left_mm);
  const double wanted = planned + part.error_mm;
  const double least = part.growth * (1.0 + authority.least) * planned;
  const double greatest = part.growth * (1.0 + authority.greatest) * planned;
  return wanted - std::clamp(wanted, least, greatest);
}

bool needsReplanning(const PartUnderWay& part, double layer_mm, const LayerAuthority& authority) {
  return std::abs(part.error_mm) > layer_mm || std::abs(expectedTopError(part, authority)) > 0.5 * layer_mm;
}

std::optional<NewHeights> scaledHeights(const PartUnderWay& part, const LayerWindow& window) {
  const std::vector<double>& left = part.heights_left_mm;
  const double planned = totalOf(left);
  const double wanted = planned + part.error_mm;
  if (left.empty() || !(wanted > 0.0) || !(part.growth > 0.0)) return std::nullopt;
  NewHeights heights;
  heights.flow = flowOf(part, window);
  const double scale = wanted / planned;
  if (allFit(left, scale, window)) {
    for (const double height : left) heights.heights_mm.push_back(scale * height);
    return heights;
  }
  const double mean = planned / static_cast<double>(left.size());
  const auto nearest = static_cast<long>(std::max(1.0, std::round(wanted / mean)));
  for (const long count : {nearest, nearest + 1, nearest - 1}) {
    if (count < 1 || !fits(wanted / static_cast<double>(count), mean, window)) continue;
    heights.heights_mm.assign(static_cast<std::size_t>(count), wanted / static_cast<double>(count));
    return heights;
  }
  return std::nullopt;
}

std::optional<NewHeights> addedHeights(const PartUnderWay& part, const LayerWindow& window) {
  const double planned = totalOf(part.heights_left_mm);
  if (part.heights_left_mm.empty() || !(part.growth > 0.0)) return std::nullopt;
  const double mean = planned / static_cast<double>(part.heights_left_mm.size());
  const double count = std::round((planned + part.error_mm) / mean);
  if (!(count >= 1.0) || !fits(mean, mean, window)) return std::nullopt;
  NewHeights heights;
  heights.flow = flowOf(part, window);
  heights.heights_mm.assign(static_cast<std::size_t>(count), mean);
  return heights;
}

std::optional<NewHeights> newHeights(const PartUnderWay& part, Replanning replan, const LayerWindow& window) {
  if (replan == Replanning::Scale) return scaledHeights(part, window);
  return replan == Replanning::Add ? addedHeights(part, window) : std::nullopt;
}

std::vector<RegionDecision> regionDecisions(const LayerCells& cells, const std::vector<double>& error_mm) {
  std::vector<RegionDecision> decisions;
  const auto side = [&](std::size_t i) { return sideOf(error_mm[i], cells.height_mm[i]); };
  for (std::size_t r = 0; r < cells.runs.size(); ++r) {
    const CellRun& run = cells.runs[r];
    for (const CellStretch& stretch :
         stretchesOf(run, [&](std::size_t a, std::size_t b) { return side(a) == side(b); })) {
      const double length = static_cast<double>(stretch.count) * run.cellLength();
      const bool is_wide = length >= kWideRegion * cells.width_mm[stretch.first];
      const RegionStep step = stepOf(error_mm[stretch.first], cells.height_mm[stretch.first], is_wide);
      if (step != RegionStep::None) decisions.push_back({step, r, stretch.first, stretch.count});
    }
  }
  return decisions;
}

}  // namespace lamina
