// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/bead_section.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr std::size_t kLeastPoints = 5;
constexpr double kCrownReach = 1.0 / 6.0;  // of the width, to each side
constexpr double kLeastReach = 0.3;        // of the width, to each side
constexpr double kHighest = -0.5;          // layers below the crown: what is higher is no bead

/// Mean depth of the points on the crown; none without any.
std::optional<double> crownDepth(const std::vector<ContourPoint>& contour, const Bead& bead) {
  double sum = 0.0;
  double count = 0.0;
  for (const ContourPoint& point : contour) {
    if (std::abs(point.across_mm) > kCrownReach * bead.width_mm) continue;
    sum += point.below_mm;
    count += 1.0;
  }
  return count > 0.0 ? std::optional<double>(sum / count) : std::nullopt;
}

}  // namespace

double plannedDepth(double across_mm, const Bead& bead) {
  const double round = 0.5 * std::min(bead.height_mm, bead.width_mm);
  const double beyond = std::clamp(std::abs(across_mm) - (0.5 * bead.width_mm - round), 0.0, round);
  return round - std::sqrt(round * round - beyond * beyond);
}

std::optional<double> sectionDeficit(const std::vector<ContourPoint>& contour, const Bead& bead) {
  const double area = crossSection(bead);
  const auto crown = crownDepth(contour, bead);
  if (contour.size() < kLeastPoints || !crown || !(area > 0.0)) return std::nullopt;
  const auto [least, greatest] = std::minmax_element(
      contour.begin(), contour.end(),
      [](const ContourPoint& a, const ContourPoint& b) { return a.across_mm < b.across_mm; });
  const double reach = kLeastReach * bead.width_mm;
  if (least->across_mm > -reach || greatest->across_mm < reach) return std::nullopt;
  double lack_mm = 0.0;
  for (const ContourPoint& point : contour) {
    const double depth = std::clamp(point.below_mm - *crown, kHighest * bead.height_mm, bead.height_mm);
    lack_mm += depth - plannedDepth(point.across_mm, bead);
  }
  const double spacing = (greatest->across_mm - least->across_mm) / static_cast<double>(contour.size() - 1);
  return lack_mm * spacing / area;
}

}  // namespace lamina
