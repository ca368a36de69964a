// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/parameterization/chart_lookup.hpp"
#include "lamina/planning/lift/chart_lift.hpp"

namespace lamina {

/// A run on its layer, if there is room for it.
struct LiftedRun {
  std::optional<Path> path;
  double left_out_mm3 = 0.0;
};

/// A run that deposits, from the plan onto its layer, as `liftOnto` says.
/// @throws InvalidInput if it leaves its chart
LiftedRun liftedRun(const ChartLookup& charts, const Path& planned, const LiftSettings& settings);

}  // namespace lamina
