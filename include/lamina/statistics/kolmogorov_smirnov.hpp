// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// How far a sample is from a normal distribution.
struct KolmogorovSmirnov {
  double distance = 0.0;     ///< greatest difference of the two distribution functions
  double probability = 0.0;  ///< that a sample of the distribution lies so far from it or farther
  std::size_t count = 0;
};

/// One-sample test of Kolmogorov and Smirnov against N(mean, deviation²), two-sided. The probability is exact
/// [Marsaglia2003]; in the far tail, their formula good to 7 digits. Where mean and
/// deviation come from the sample itself, as in [Vega2023], the true probability is smaller (Lilliefors).
/// @throws InvalidInput if there is no value, one is not finite, or the deviation is not positive
KolmogorovSmirnov testNormality(const std::vector<double>& values, double mean, double deviation);

}  // namespace lamina
