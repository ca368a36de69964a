// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Position of the vertex of the parabola through three equally spaced values, in spacings from the middle
/// one; 0 if the values lie on a line.
double vertexOfParabola(double before, double middle, double after);

/// Mean, standard deviation and slope of a sequence of values.
struct LineOfValues {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the sample; 0 for a single value
  double slope = 0.0;      ///< slope over the positions of the values; 0 for fewer than three values
};
LineOfValues lineOfValues(const std::vector<double>& places, const std::vector<double>& values);

}  // namespace lamina
