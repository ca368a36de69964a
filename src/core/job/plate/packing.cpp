// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

using Reach = Packing::Reach;

constexpr int kCount = Packing::kDirections;
constexpr int kPerEighth = kCount / 8;
constexpr double kTouching = 1e-9;  // mm

// Quarter turns of the directions, as indices.
constexpr std::size_t kRight = 0;
constexpr std::size_t kUp = kCount / 4;
constexpr std::size_t kLeft = kCount / 2;
constexpr std::size_t kDown = 3 * kCount / 4;

Point2 direction(int index) {
  const double angle = 2.0 * M_PI * index / kCount;
  return {std::cos(angle), std::sin(angle)};
}

Reach reachOf(const Polygon& hull) {
  Reach reach;
  for (int k = 0; k < kCount; ++k) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Point2& corner : hull) farthest = std::max(farthest, direction(k).dot(corner));
    reach[static_cast<std::size_t>(k)] = farthest;
  }
  return reach;
}

Reach turned(const Reach& reach, int eighths) {
  Reach result;
  for (int k = 0; k < kCount; ++k)
    result[static_cast<std::size_t>(k)] =
        reach[static_cast<std::size_t>((k + kCount - eighths * kPerEighth) % kCount)];
  return result;
}

/// Of the box, from where the reach is counted.
Point2 middleOf(const Reach& reach) {
  return {0.5 * (reach[kRight] - reach[kLeft]), 0.5 * (reach[kUp] - reach[kDown])};
}

/// The x that lie within all edges at that y, open at both ends; low above high if there are none.
std::pair<double, double> within(const Reach& reach, double y) {
  double low = -std::numeric_limits<double>::infinity();
  double high = -low;
  for (int k = 0; k < kCount; ++k) {
    const Point2 normal = direction(k);
    const double rest = reach[static_cast<std::size_t>(k)] - normal.y() * y;
    if (std::abs(normal.x()) < 1e-12) {
      if (rest <= kTouching) return {1.0, -1.0};
    } else if (normal.x() > 0.0) {
      high = std::min(high, rest / normal.x());
    } else {
      low = std::max(low, rest / normal.x());
    }
  }
  return {low, high};
}

}  // namespace

void Packing::addFixed(const Polygon& hull, const Point2& at) { standing_.push_back({reachOf(hull), at}); }

/// Where the origin of a footprint must not be, seen from that of one that stands.
Packing::Reach Packing::keptClear(const Standing& standing, const Reach& reach) const {
  Reach sum;
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = standing.reach[k] + reach[(k + kCount / 2) % kCount] + spacing_mm_;
  return sum;
}

/// Heights at which the free places change their kind: corners of what must be kept clear.
std::vector<double> Packing::levels(const Reach& reach, double low, double high) const {
  std::vector<double> found = {low};
  for (const Standing& standing : standing_) {
    const Reach clear = keptClear(standing, reach);
    for (int k = 0; k < kCount; ++k) {
      const auto here = static_cast<std::size_t>(k);
      const Point2 a = direction(k);
      const Point2 b = direction(k + 1);
      const double turn = a.x() * b.y() - a.y() * b.x();
      const double y = standing.at.y() + (a.x() * clear[(here + 1) % kCount] - b.x() * clear[here]) / turn;
      if (y > low && y <= high) found.push_back(y);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<double> Packing::leftmost(const Reach& reach, double y, double low, double high) const {
  std::vector<std::pair<double, double>> taken;
  for (const Standing& standing : standing_) {
    const auto [from, to] = within(keptClear(standing, reach), y - standing.at.y());
    if (from < to) taken.emplace_back(standing.at.x() + from, standing.at.x() + to);
  }
  std::sort(taken.begin(), taken.end());
  double x = low;
  for (const auto& [from, to] : taken)
    if (from < x - kTouching && x < to - kTouching) x = to;
  return x <= high ? std::optional(x) : std::nullopt;
}

std::optional<Point2> Packing::lowestLeft(const Reach& reach) const {
  const Point2 low = bed_.low + Point2(reach[kLeft], reach[kDown]);
  const Point2 high = bed_.high - Point2(reach[kRight], reach[kUp]);
  if (low.x() > high.x() || low.y() > high.y()) return std::nullopt;
  for (const double y : levels(reach, low.y(), high.y()))
    if (const std::optional<double> x = leftmost(reach, y, low.x(), high.x())) return Point2(*x, y);
  return std::nullopt;
}

std::optional<PlatePlace> Packing::placed(const Polygon& hull) {
  const Reach upright = reachOf(hull);
  std::optional<PlatePlace> best;
  Standing standing;
  double least_top = std::numeric_limits<double>::infinity();
  for (int eighths = 0; eighths < 8; ++eighths) {
    const Reach reach = turned(upright, eighths);
    const std::optional<Point2> at = lowestLeft(reach);
    if (!at || at->y() + reach[kUp] >= least_top - kTouching) continue;
    least_top = at->y() + reach[kUp];
    best = PlatePlace{*at + middleOf(reach), eighths};
    standing = {reach, *at};
  }
  if (best) standing_.push_back(standing);
  return best;
}

}  // namespace lamina
