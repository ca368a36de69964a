// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/parameterization/chart_lookup.hpp"
#include "lamina/planning/lift/chart_lift.hpp"

namespace lamina {

/// A straight line of the plan as it lies on a layer.
struct LiftedLine {
  std::vector<SurfacePoint> points;  ///< the ends, and where it crosses sides of triangles
  std::vector<double> plan_mm;       ///< length in the plan up to each point
  std::vector<double> area_ratio;    ///< in space over in the plan, from each point to the next
};

/// The line on the charts; in triangles where the height varies by more than the tolerance it has further
/// points. Nothing if it leaves its chart.
std::optional<LiftedLine> liftedLine(const ChartLookup& charts, const Point2& from, const Point2& to,
                                     double height_tolerance);

/// Indices of the points without which the line would leave the tolerances; the ends are among them.
std::vector<std::size_t> neededPoints(const LiftedLine& line, const LiftSettings& settings);

}  // namespace lamina
