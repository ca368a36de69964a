// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/point_order.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kOrderRounding = 1e-6;  // mm: feet nearer than this stand at one place

/// The feet without the jumps at the start of a closed curve, in whole roundings.
std::vector<double> unrolled(const std::vector<double>& feet_mm, double round_mm) {
  std::vector<double> feet;
  feet.reserve(feet_mm.size());
  double position = 0.0;
  for (std::size_t i = 0; i < feet_mm.size(); ++i) {
    const double way = i > 0 ? feet_mm[i] - feet_mm[i - 1] : 0.0;
    position += round_mm > 0.0 ? std::remainder(way, round_mm) : way;
    feet.push_back(std::round(position / kOrderRounding));
  }
  return feet;
}

}  // namespace

std::vector<std::size_t> pointsInOrder(const std::vector<double>& feet_mm, double round_mm) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const std::vector<double> feet = unrolled(feet_mm, round_mm);
  // The longest ascending subsequence: for each length the point of the lowest foot that ends one.
  std::vector<std::size_t> ends;
  std::vector<std::size_t> before(feet.size(), kNone);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const auto place = std::upper_bound(ends.begin(), ends.end(), i,
                                        [&feet](std::size_t a, std::size_t b) { return feet[a] < feet[b]; });
    if (place != ends.begin()) before[i] = *(place - 1);
    if (place == ends.end())
      ends.push_back(i);
    else
      *place = i;
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = ends.empty() ? kNone : ends.back(); i != kNone; i = before[i]) kept.push_back(i);
  std::reverse(kept.begin(), kept.end());
  return kept;
}

}  // namespace lamina
