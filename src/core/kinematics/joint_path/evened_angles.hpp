// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Angles along a run, evened out by means over neighbours, twice. The ends are kept, and no angle deviates
/// from the given one by more than `most_deviation`. Linear time.
/// @param angles          [rad]; neighbours are less than half a turn apart, modulo whole turns
/// @param most_deviation  [rad]
/// @return the angles without jumps by whole turns
std::vector<double> evenedOut(const std::vector<double>& angles, double most_deviation);

}  // namespace lamina
