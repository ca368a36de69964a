// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Angles along a run, evened out: means over neighbours, twice, which keep the ends and stay within a
/// distance of the angles they come from. Linear time.
/// @param angles          [rad]; neighbours are less than half a turn apart, but for whole turns
/// @param most_deviation  [rad]
/// @return without leaps by whole turns
std::vector<double> evenedOut(const std::vector<double>& angles, double most_deviation);

}  // namespace lamina
