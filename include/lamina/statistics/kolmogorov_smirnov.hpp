// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Result of a Kolmogorov-Smirnov test.
struct KolmogorovSmirnov {
  double distance = 0.0;     ///< greatest difference between the two distribution functions
  double probability = 0.0;  ///< p-value: probability of at least this distance by chance
  std::size_t count = 0;     ///< size of the sample
};

/// Two-sided one-sample Kolmogorov-Smirnov test against the normal distribution N(mean, deviation²). The
/// probability is exact [Marsaglia2003]; in the far tail it is that of their formula, accurate to 7 digits.
/// If mean and deviation come from the sample itself, as in [Vega2023], the true probability is smaller
/// (Lilliefors).
/// @throws InvalidInput if there is no value, one is not finite, or the deviation is not positive
KolmogorovSmirnov testNormality(const std::vector<double>& values, double mean, double deviation);

}  // namespace lamina
