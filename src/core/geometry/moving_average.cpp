// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/moving_average.hpp"

#include <algorithm>

namespace lamina {

std::vector<Point3> movingAverages(const std::vector<Point3>& points, Course course, std::size_t reach) {
  const std::size_t count = points.size();
  if (count == 0) return {};
  std::vector<Point3> sums(count + 1, Point3::Zero());
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + points[i];
  const auto sumBefore = [&](std::size_t end) {
    const std::size_t whole_rounds = end / count;
    return Point3(static_cast<double>(whole_rounds) * sums[count] + sums[end % count]);
  };
  // Whole rounds before the start, so that no index is negative.
  const std::size_t rounds = (reach / count + 1) * count;
  std::vector<Point3> means(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (course == Course::Closed) {
      const Point3 sum = sumBefore(rounds + i + reach + 1) - sumBefore(rounds + i - reach);
      means[i] = sum / static_cast<double>(2 * reach + 1);
      continue;
    }
    const std::size_t half = std::min({reach, i, count - 1 - i});
    means[i] = (sums[i + half + 1] - sums[i - half]) / static_cast<double>(2 * half + 1);
  }
  return means;
}

}  // namespace lamina
