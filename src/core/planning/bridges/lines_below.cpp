// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/lines_below.hpp"

#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kEquallyOften = 1e-9;

/// Where the ways across all lines add up, each turned to the side of the first one: across that sum a way
/// meets the lines most often among all ways that run between the same two directions of lines.
Point2 sumOfLines(const std::vector<double>& lines_deg, double way_deg) {
  Point2 sum = Point2::Zero();
  for (const double line_deg : lines_deg) {
    const double side = std::sin((way_deg - line_deg) * kDegree) < 0.0 ? -1.0 : 1.0;
    sum += side * Point2(std::cos(line_deg * kDegree), std::sin(line_deg * kDegree));
  }
  return sum;
}

}  // namespace

std::vector<double> linesOf(const InfillStrategy& strategy, const InfillSettings& settings,
                            std::size_t layer) {
  if (strategy.fixed_lines_deg.empty())
    return {settings.angle_deg + settings.alternation_deg * static_cast<double>(layer)};
  std::vector<double> lines_deg;
  for (const double turn_deg : strategy.fixed_lines_deg) lines_deg.push_back(settings.angle_deg + turn_deg);
  return lines_deg;
}

double acrossLines(const std::vector<double>& lines_deg) {
  if (lines_deg.size() == 1) return lines_deg.front() + 90.0;
  constexpr double kBeside = 1e-3;  // deg: just beyond the direction of a line
  double best_deg = lines_deg.front() + 90.0;
  double most = 0.0;
  for (const double line_deg : lines_deg) {
    const Point2 sum = sumOfLines(lines_deg, line_deg + kBeside);
    if (sum.norm() <= most + kEquallyOften) continue;
    most = sum.norm();
    best_deg = std::atan2(sum.y(), sum.x()) / kDegree + 90.0;
  }
  return best_deg;
}

}  // namespace lamina
