// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outlying.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFewest = 4;      // touches that a fit keeps
constexpr double kFarOff = 7.3;         // standard deviations of a coordinate: 3 of a predicted place
constexpr double kUnquestioned = 1e-3;  // mm: below that nothing is outlying

/// A touch as the fit to the others sees it.
struct LeftOut {
  std::size_t at = 0;
  double distance_mm = 0.0;
  double deviation_mm = 0.0;  ///< of the others
};

std::optional<LeftOut> withoutTouch(std::size_t at, const std::vector<std::size_t>& kept,
                                    const DistancesFromFit& distances) {
  std::vector<std::size_t> others;
  others.reserve(kept.size());
  std::copy_if(kept.begin(), kept.end(), std::back_inserter(others),
               [&](std::size_t index) { return index != at; });
  try {
    const std::vector<double> all = distances(others);
    return LeftOut{at, all[at], coordinateDeviation(pickedFrom(all, others))};
  } catch (const InvalidInput&) {
    return std::nullopt;  // without it nothing is determined: nothing contradicts it either
  }
}

/// That without which the others agree best.
std::optional<LeftOut> mostOutlying(const std::vector<std::size_t>& kept, const DistancesFromFit& distances) {
  std::optional<LeftOut> most;
  for (const std::size_t at : kept) {
    const std::optional<LeftOut> left = withoutTouch(at, kept, distances);
    if (left && (!most || left->deviation_mm < most->deviation_mm)) most = left;
  }
  return most;
}

}  // namespace

double meanDistance(const std::vector<double>& distances) {
  if (distances.empty()) return 0.0;
  const double squared = std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0);
  return std::sqrt(squared / static_cast<double>(distances.size()));
}

double coordinateDeviation(const std::vector<double>& distances, double unknowns) {
  const double spare = 3.0 * static_cast<double>(distances.size()) - unknowns;
  if (spare <= 0.0) return 0.0;
  return std::sqrt(std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0) / spare);
}

std::vector<std::size_t> outlyingTouches(std::size_t count, const DistancesFromFit& distances) {
  std::vector<std::size_t> kept(count);
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  std::vector<std::size_t> outlying;
  while (kept.size() > kFewest) {
    const std::optional<LeftOut> most = mostOutlying(kept, distances);
    if (!most || most->distance_mm <= std::max(kFarOff * most->deviation_mm, kUnquestioned)) break;
    outlying.push_back(most->at);
    kept.erase(std::find(kept.begin(), kept.end(), most->at));
  }
  std::sort(outlying.begin(), outlying.end());
  return outlying;
}

}  // namespace lamina
