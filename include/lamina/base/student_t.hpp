// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Mean and standard deviation of independent measurements.
struct Sample {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation, not negative
  std::size_t count = 0;   ///< at least 2
};

/// The result of comparing two means by Student's t.
struct StudentTest {
  double t = 0.0;                      ///< positive if the first mean is greater
  std::size_t degrees_of_freedom = 0;  ///< sum of both counts, less 2
  /// Probability that the means differ by this much or more, in this direction, by chance.
  double probability = 0.0;
};

/// Compares two means; the probability is one-sided. The standard error of the difference is the sum of both
/// standard errors, not the pooled error, since the printed values of t fit this sum [Sobreviela2014, tables
/// 6.1 and 6.2].
/// @throws InvalidInput if a sample has fewer than two values, or both standard deviations are 0
StudentTest compareMeans(const Sample& a, const Sample& b);

/// Probability that a value of Student's distribution is above t.
/// @throws InvalidInput if there are no degrees of freedom
double probabilityAbove(double t, std::size_t degrees_of_freedom);

/// The value that a variable of Student's distribution does not exceed with a probability of `confidence`.
/// @param confidence  between 0 and 1, both excluded
/// @throws InvalidInput if it is not, or there are no degrees of freedom
double criticalT(double confidence, std::size_t degrees_of_freedom);

}  // namespace lamina
