// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Place of the extremum of the parabola through three equally spaced values, in spacings from the middle
/// one; 0 where they lie on a line.
double vertexOfParabola(double before, double middle, double after);

/// Mean, deviation and slope of values.
struct LineOfValues {
  double mean = 0.0;
  double deviation = 0.0;  ///< of a sample; 0 of a single value
  double slope = 0.0;      ///< over the places; 0 of fewer than three values
};
LineOfValues lineOfValues(const std::vector<double>& places, const std::vector<double>& values);

}  // namespace lamina
