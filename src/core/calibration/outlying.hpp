// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace lamina {

/// Distances of all touches from the fit to some of them [mm], in their order.
/// @throws InvalidInput if the fitted touches do not determine the fit
using DistancesFromFit = std::function<std::vector<double>(const std::vector<std::size_t>& fitted)>;

/// Indices of touches that contradict the others, ascending. Each lies farther from the fit to the others
/// than 7.3 times their standard deviation in one coordinate. A fit of six unknowns to all touches would hide
/// an outlier by adapting to it. At least four touches stay; of fewer than five, none is named.
std::vector<std::size_t> outlyingTouches(std::size_t count, const DistancesFromFit& distances);

/// The values at the given indices, in the order of the indices.
template <typename Value>
std::vector<Value> pickedFrom(const std::vector<Value>& values, const std::vector<std::size_t>& places) {
  std::vector<Value> chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places) chosen.push_back(values[place]);
  return chosen;
}

/// Standard deviation of one coordinate, by the distances from a fit of `unknowns` unknowns [mm]; 0 if the
/// touches have no more coordinates than there are unknowns.
double coordinateDeviation(const std::vector<double>& distances, double unknowns = 6.0);

/// Root mean square of the distances; 0 if there are none.
double meanDistance(const std::vector<double>& distances);

}  // namespace lamina
