// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/evened_angles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lamina {

namespace {

/// On either side. A step by one sample is spread over some 30 waypoints: few to a run that needs a step at
/// all, and enough that a joint does not feel it.
constexpr std::size_t kReach = 8;

std::vector<double> unwrapped(std::vector<double> angles) {
  for (std::size_t i = 1; i < angles.size(); ++i)
    angles[i] = angles[i - 1] + std::remainder(angles[i] - angles[i - 1], 2.0 * M_PI);
  return angles;
}

/// Means over as many neighbours on either side as there are, kReach at most: the ends keep their values.
std::vector<double> movingMean(const std::vector<double>& values) {
  std::vector<double> sums(values.size() + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  std::vector<double> means(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t reach = std::min({kReach, i, values.size() - 1 - i});
    means[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
  }
  return means;
}

}  // namespace

std::vector<double> evenedOut(const std::vector<double>& angles, double most_deviation) {
  const std::vector<double> from = unwrapped(angles);
  std::vector<double> even = movingMean(movingMean(from));
  for (std::size_t i = 0; i < even.size(); ++i)
    even[i] = std::clamp(even[i], from[i] - most_deviation, from[i] + most_deviation);
  return even;
}

}  // namespace lamina
