// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lift/lifted_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

/// More parts of a triangle than this do not follow a height that runs out to nothing any better.
constexpr int kMostParts = 100;

int partsFor(double from_mm, double to_mm, double tolerance) {
  const double change = std::abs(to_mm - from_mm);
  const double allowed = tolerance * std::min(from_mm, to_mm);
  if (change > kMostParts * allowed) return kMostParts;
  return change > allowed ? static_cast<int>(std::ceil(change / allowed)) : 1;
}

class Thinning {
 public:
  Thinning(const LiftedLine& line, const LiftSettings& settings)
      : line_(line),
        settings_(settings),
        chord_(2.0 * std::sin(0.5 * settings.normal_tolerance_deg * M_PI / 180.0)) {}

  std::vector<std::size_t> needed() const {
    std::vector<std::size_t> kept = {0};
    std::vector<std::size_t> ends = {line_.points.size() - 1};  // still to reach, the nearest last
    while (!ends.empty()) {
      const std::size_t middle = split(kept.back(), ends.back());
      if (middle != kept.back()) {
        ends.push_back(middle);
        continue;
      }
      kept.push_back(ends.back());
      ends.pop_back();
    }
    return kept;
  }

 private:
  /// The point between two at which their straight connection is farthest from what is allowed; the first
  /// of the two if it is allowed.
  std::size_t split(std::size_t first, std::size_t last) const {
    std::size_t worst = first;
    double greatest = 1.0;
    double low = line_.points[last].height_mm;
    double high = low;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double excess = excessOf(i, first, last);
      if (excess > greatest) {
        greatest = excess;
        worst = i;
      }
      low = std::min(low, line_.points[i].height_mm);
      high = std::max(high, line_.points[i].height_mm);
    }
    low = std::min(low, line_.points[first].height_mm);
    high = std::max(high, line_.points[first].height_mm);
    const bool varies = high - low > settings_.height_tolerance * 0.5 * (high + low) * (1.0 + 1e-9);
    return worst == first && varies ? (first + last) / 2 : worst;
  }

  /// Deviation of a point in tolerances.
  double excessOf(std::size_t i, std::size_t first, std::size_t last) const {
    const SurfacePoint& a = line_.points[first];
    const SurfacePoint& b = line_.points[last];
    const SurfacePoint& point = line_.points[i];
    const Point3 along = b.tip - a.tip;
    const double squared = along.squaredNorm();
    const double part = squared > 0.0 ? std::clamp((point.tip - a.tip).dot(along) / squared, 0.0, 1.0) : 0.0;
    const double distance = (a.tip + part * along - point.tip).norm() / settings_.position_tolerance_mm;
    if (settings_.tool_axis == ToolAxis::Down) return distance;
    const Point3 normal = (a.normal + part * (b.normal - a.normal)).normalized();
    return std::max(distance, (normal - point.normal).norm() / chord_);
  }

  const LiftedLine& line_;
  const LiftSettings& settings_;
  double chord_;
};

}  // namespace

std::optional<LiftedLine> liftedLine(const ChartLookup& charts, const Point2& from, const Point2& to,
                                     double height_tolerance) {
  const std::optional<std::vector<ChartStretch>> stretches = charts.stretches(from, to);
  if (!stretches) return std::nullopt;
  const double length = (to - from).norm();
  LiftedLine line;
  line.points.push_back(charts.lifted(charts.at(from)));
  line.plan_mm.push_back(0.0);
  for (const ChartStretch& stretch : *stretches) {
    const bool is_last = &stretch == &stretches->back();
    const auto placeAt = [&](double t) { return charts.within(stretch.in, from + t * (to - from)); };
    const SurfacePoint end = charts.lifted(is_last ? charts.at(to) : placeAt(stretch.to));
    const int parts = partsFor(line.points.back().height_mm, end.height_mm, height_tolerance);
    for (int k = 1; k <= parts; ++k) {
      const double t = stretch.from + (stretch.to - stretch.from) * k / parts;
      line.points.push_back(k == parts ? end : charts.lifted(placeAt(t)));
      line.plan_mm.push_back(t * length);
      line.area_ratio.push_back(charts.areaRatio(stretch.in));
    }
  }
  return line;
}

std::vector<std::size_t> neededPoints(const LiftedLine& line, const LiftSettings& settings) {
  return Thinning(line, settings).needed();
}

}  // namespace lamina
