// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/path_cuts.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr std::size_t kIndexGap = 3;    // points between peaks that may be near each other
constexpr double kNearby = 1.5;         // widths: neighbours are looked at too
constexpr std::size_t kNeighbours = 2;  // on each side
constexpr double kClosing = 0.5;        // widths between the ends of a closed path

using Indices = std::vector<std::size_t>;

/// Indices of the points above both neighbours in this axis, times the sign; of a level peak the first.
Indices peaks(const std::vector<Point2>& points, int axis, double sign) {
  Indices found;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double here = sign * points[i][axis];
    if (!(here > sign * points[i - 1][axis])) continue;
    std::size_t after = i + 1;
    while (after < points.size() && points[after][axis] == points[i][axis]) ++after;
    if (after < points.size() && sign * points[after][axis] < here) found.push_back(i);
  }
  return found;
}

bool anyNear(const std::vector<Point2>& points, std::size_t one, std::size_t other, double width_mm) {
  const auto first = [](std::size_t i) { return i - std::min(i, kNeighbours); };
  const auto last = [&points](std::size_t i) { return std::min(i + kNeighbours, points.size() - 1); };
  for (std::size_t a = first(one); a <= last(one); ++a)
    for (std::size_t b = first(other); b <= last(other); ++b)
      if ((points[a] - points[b]).norm() < width_mm) return true;
  return false;
}

/// Whether a stretch towards a maximum comes too near one towards a minimum.
bool meetsItself(const std::vector<Point2>& points, const Indices& maxima, const Indices& minima,
                 double width_mm) {
  for (const std::size_t high : maxima)
    for (const std::size_t low : minima) {
      if (std::max(high, low) - std::min(high, low) <= kIndexGap) continue;
      const double distance_mm = (points[high] - points[low]).norm();
      if (distance_mm < width_mm) return true;
      if (distance_mm < kNearby * width_mm && anyNear(points, high, low, width_mm)) return true;
    }
  return false;
}

}  // namespace

std::vector<std::size_t> pathCuts(const std::vector<Point2>& points, double width_mm) {
  Indices cuts;
  if (points.size() > 2) {
    const Indices high[2] = {peaks(points, 0, 1.0), peaks(points, 1, 1.0)};
    const Indices low[2] = {peaks(points, 0, -1.0), peaks(points, 1, -1.0)};
    const auto meets = [&](int axis) { return meetsItself(points, high[axis], low[axis], width_mm); };
    const int cut_axis = meets(1) ? 0 : meets(0) ? 1 : -1;
    if (cut_axis != -1) {
      cuts = high[cut_axis];
      cuts.insert(cuts.end(), low[cut_axis].begin(), low[cut_axis].end());
    }
    if ((points.front() - points.back()).norm() < kClosing * width_mm) cuts.push_back(points.size() - 2);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace lamina
