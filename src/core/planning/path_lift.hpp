// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/chart_lift.hpp"
#include "lamina/surface/chart_lookup.hpp"

namespace lamina {

/// A run that deposits, from the plan onto its layer, as `liftOnto` says.
/// @throws InvalidInput if it leaves its chart or all its tips coincide
Path liftedPath(const ChartLookup& charts, const Path& planned, const LiftSettings& settings);

}  // namespace lamina
