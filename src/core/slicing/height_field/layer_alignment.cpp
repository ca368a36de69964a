// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/layer_alignment.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr int kSteps = 16;  // of half a layer either way
constexpr int kRefinements = 50;

}  // namespace

double distanceToTops(const std::vector<SurfacePlace>& places, double scale, const SlicingSettings& slicing) {
  if (places.empty()) return 0.0;
  double sum = 0.0;
  for (const SurfacePlace& place : places) {
    const double factor = scale * place.factor;
    const double above = (place.height_mm / factor - slicing.first_layer_height_mm) / slicing.layer_height_mm;
    sum += factor * slicing.layer_height_mm * std::abs(above - std::max(0.0, std::round(above)));
  }
  return sum / static_cast<double>(places.size());
}

double alignedScale(const std::vector<SurfacePlace>& places, const ScaleRange& allowed,
                    const SlicingSettings& slicing) {
  double highest = 0.0;
  for (const SurfacePlace& place : places) highest = std::max(highest, place.height_mm / place.factor);
  if (!(highest > 0.0) || allowed.greatest <= allowed.least) return 1.0;
  const auto distance = [&](double scale) { return distanceToTops(places, scale, slicing); };
  const double step = 0.5 * slicing.layer_height_mm / kSteps / highest;
  double best = 1.0;
  double least = distance(1.0);
  for (int k = -kSteps; k <= kSteps; ++k) {
    const double scale = std::clamp(1.0 + step * k, allowed.least, allowed.greatest);
    const double at_scale = distance(scale);
    if (at_scale >= least) continue;
    least = at_scale;
    best = scale;
  }
  double low = std::max(allowed.least, best - step);
  double high = std::min(allowed.greatest, best + step);
  for (int i = 0; i < kRefinements; ++i) {
    const double third = (high - low) / 3.0;
    if (distance(low + third) <= distance(high - third))
      high -= third;
    else
      low += third;
  }
  const double refined = 0.5 * (low + high);
  return distance(refined) < least ? refined : best;
}

}  // namespace lamina
