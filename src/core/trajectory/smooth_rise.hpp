// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// From 0 to 1 as u goes from 0 to 1, level at both ends.
constexpr double smoothRise(double u) { return u * u * (3.0 - 2.0 * u); }
/// Its derivative.
constexpr double smoothRiseRate(double u) { return 6.0 * u * (1.0 - u); }
/// Its integral from 0.
constexpr double smoothRiseSum(double u) { return u * u * u * (1.0 - 0.5 * u); }

}  // namespace lamina
