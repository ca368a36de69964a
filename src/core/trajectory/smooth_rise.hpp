// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Smooth step: rises from 0 to 1 as u goes from 0 to 1, with zero slope at both ends.
constexpr double smoothRise(double u) { return u * u * (3.0 - 2.0 * u); }
/// Derivative of `smoothRise`.
constexpr double smoothRiseRate(double u) { return 6.0 * u * (1.0 - u); }
/// Integral of `smoothRise` from 0 to u.
constexpr double smoothRiseSum(double u) { return u * u * u * (1.0 - 0.5 * u); }

}  // namespace lamina
