// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_smoothing.hpp"

#include <algorithm>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kVanished = 1e-9;  // length of an average of unit vectors

Point3 averaged(const Point3& sum, std::size_t count, const Point3& jet) {
  const Point3 mean = sum / static_cast<double>(count);
  return mean.norm() < kVanished ? jet : mean.normalized();
}

/// Sums of the first i jets, for i from 0.
std::vector<Point3> runningSums(const std::vector<Point3>& jets) {
  std::vector<Point3> sums(jets.size() + 1, Point3::Zero());
  for (std::size_t i = 0; i < jets.size(); ++i) sums[i + 1] = sums[i] + jets[i];
  return sums;
}

std::vector<Point3> smoothedOpen(const std::vector<Point3>& jets, std::size_t half) {
  const std::vector<Point3> sums = runningSums(jets);
  std::vector<Point3> result(jets.size());
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const std::size_t reach = std::min({half, i, jets.size() - 1 - i});
    result[i] = averaged(sums[i + reach + 1] - sums[i - reach], 2 * reach + 1, jets[i]);
  }
  return result;
}

std::vector<Point3> smoothedClosed(const std::vector<Point3>& jets, std::size_t half) {
  const std::size_t count = jets.size();
  const std::vector<Point3> sums = runningSums(jets);
  const auto sumBefore = [&](std::size_t end) {
    const std::size_t rounds_before = end / count;
    return Point3(static_cast<double>(rounds_before) * sums[count] + sums[end % count]);
  };
  // Whole rounds before the start, so that no index is negative.
  const std::size_t rounds = (half / count + 1) * count;
  std::vector<Point3> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 sum = sumBefore(rounds + i + half + 1) - sumBefore(rounds + i - half);
    result[i] = averaged(sum, 2 * half + 1, jets[i]);
  }
  return result;
}

}  // namespace

std::vector<Point3> smoothedJets(const std::vector<Point3>& jets, bool is_closed, int window) {
  if (window < 1 || window % 2 == 0)
    throw InvalidConfig("orientation.smoothing_window is " + std::to_string(window) +
                        "; must be odd and at least 1");
  if (window == 1 || jets.size() < 2) return jets;
  const auto half = static_cast<std::size_t>(window / 2);
  return is_closed ? smoothedClosed(jets, half) : smoothedOpen(jets, half);
}

}  // namespace lamina
