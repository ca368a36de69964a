// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adaptive_heights/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSameHeight = 1e-9;  // mm
constexpr std::size_t kMostLayersOfPart = 10000000;

/// With the quantum, the least multiple that is not lower.
double leastHeight(const AdaptiveSettings& settings) {
  if (settings.quantum_mm == 0.0) return settings.least_mm;
  const double least_mm =
      std::ceil(settings.least_mm / settings.quantum_mm - kSameHeight) * settings.quantum_mm;
  if (least_mm > settings.greatest_mm + kSameHeight)
    throw InvalidConfig("adaptive.quantum_mm is " + numberText(settings.quantum_mm) +
                        " mm; expected a multiple of it between adaptive.least_mm, " +
                        numberText(settings.least_mm) + " mm, and adaptive.greatest_mm, " +
                        numberText(settings.greatest_mm) + " mm");
  return least_mm;
}

HeightStretch mirroredStretch(const HeightStretch& stretch) {
  return {-stretch.high_mm, -stretch.low_mm, stretch.limit_at_high_mm, stretch.limit_at_low_mm};
}

}  // namespace

StretchCutter::StretchCutter(const SlopeProfile& profile, const AdaptiveSettings& settings)
    : up_(profile, settings),
      down_(up_.mirrored()),
      least_mm_(leastHeight(settings)),
      quantum_mm_(settings.quantum_mm) {}

double StretchCutter::heightAt(HeightLimits& limits, double bottom_mm, const HeightStretch& stretch) const {
  const double growth = limits.growth();
  const double left = stretch.high_mm - bottom_mm;
  double height = limits.above(bottom_mm);
  height = std::min(height, stretch.limit_at_low_mm + growth * (bottom_mm - stretch.low_mm));
  if (left > stretch.limit_at_high_mm)
    height = std::min(height, (stretch.limit_at_high_mm + growth * left) / (1.0 + growth));
  if (quantum_mm_ > 0.0) height = std::floor(height / quantum_mm_ + 1e-6) * quantum_mm_;
  return std::max(height, least_mm_);
}

std::vector<double> StretchCutter::ends(HeightLimits& limits, const HeightStretch& stretch) const {
  std::vector<double> ends = {stretch.low_mm};
  while (ends.back() < stretch.high_mm - kSameHeight) {
    ends.push_back(ends.back() + heightAt(limits, ends.back(), stretch));
    if (ends.size() > kMostLayersOfPart)
      throw InvalidConfig("adaptive.least_mm is " + numberText(least_mm_) +
                          " mm; the part would have more than 10 million layers");
  }
  return ends;
}

std::vector<double> StretchCutter::highest(const HeightStretch& stretch) { return ends(up_, stretch); }

std::optional<std::vector<double>> StretchCutter::cut(const HeightStretch& stretch) {
  const std::vector<double> upwards = ends(up_, stretch);
  const std::size_t count = upwards.size() - 1;
  const double length = stretch.high_mm - stretch.low_mm;
  const double least_length = static_cast<double>(count) * least_mm_;
  if (least_length > length + kSameHeight) return std::nullopt;
  // As low as a place may be for the layers above it to reach the end.
  std::vector<double> downwards = ends(down_, mirroredStretch(stretch));
  while (downwards.size() <= count) downwards.push_back(downwards.back() - least_mm_);

  const double excess = upwards.back() - stretch.low_mm - least_length;
  const double share = excess > kSameHeight ? (length - least_length) / excess : 0.0;
  std::vector<double> places = {stretch.low_mm};
  double wanted = stretch.low_mm;
  for (std::size_t i = 1; i < count; ++i) {
    wanted += least_mm_ + share * (upwards[i] - upwards[i - 1] - least_mm_);
    double place = wanted;
    if (quantum_mm_ > 0.0)
      place = stretch.low_mm + std::round((wanted - stretch.low_mm) / quantum_mm_) * quantum_mm_;
    place = std::max(place, -downwards[count - i]);
    place = std::min(place, places.back() + heightAt(up_, places.back(), stretch));
    if (place - places.back() < least_mm_ - kSameHeight) return std::nullopt;
    places.push_back(place);
  }
  if (stretch.high_mm - places.back() < least_mm_ - kSameHeight) return std::nullopt;
  places.push_back(stretch.high_mm);
  return places;
}

}  // namespace lamina
