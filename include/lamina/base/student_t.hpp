// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Mean and spread of independent measurements.
struct Sample {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation, not negative
  std::size_t count = 0;   ///< at least 2
};

/// Student's comparison of two means.
struct StudentTest {
  double t = 0.0;                      ///< positive if the first mean is greater
  std::size_t degrees_of_freedom = 0;  ///< both counts less 2
  double probability = 0.0;            ///< that means so far apart (to this side) come about by chance
};

/// Compares means with their standard errors added as they are, not pooled: that is what the printed values
/// of t fit [Sobreviela2014, tables 6.1 and 6.2]. The probability is of one side.
/// @throws InvalidInput if a sample has fewer than two values, or neither has any spread
StudentTest compareMeans(const Sample& a, const Sample& b);

/// Probability that a value of Student's distribution is above t.
double probabilityAbove(double t, std::size_t degrees_of_freedom);

/// The value that one of Student's distribution does not exceed with that probability.
/// @param confidence  between 0 and 1, both excluded
double criticalT(double confidence, std::size_t degrees_of_freedom);

}  // namespace lamina
