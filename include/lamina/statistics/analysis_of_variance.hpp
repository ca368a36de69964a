// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lamina {

/// A categorical factor.
struct Factor {
  std::string name;
  std::vector<std::string> levels;  ///< level at each observation
};

/// A source of variance: a factor, or the interaction of two factors.
struct VarianceSource {
  std::string name;  ///< such as "layer" or "layer x infill"
  double sum_of_squares = 0.0;
  std::size_t degrees_of_freedom = 0;
  double f = 0.0;            ///< F statistic
  double probability = 0.0;  ///< p-value: probability of at least this F by chance
};

/// Result of an analysis of variance.
struct AnalysisOfVariance {
  std::vector<VarianceSource> sources;  ///< factors, then interactions
  double residual_sum_of_squares = 0.0;
  std::size_t residual_degrees_of_freedom = 0;
};

/// Analysis of variance (ANOVA) of fixed factors with all two-way interactions. Sums of squares are of type
/// III, with contrasts that sum to zero: each source is compared with the model of all other sources. If all
/// cells have equal numbers of observations, all types of sums are equal.
/// @param response  one value per observation
/// @throws InvalidInput if there is no factor, a factor has fewer than two levels or another number of
///   observations than the response, a value is not finite, a pair of levels was never observed (so that
///   their interaction cannot be estimated), or no degree of freedom is left for the error
AnalysisOfVariance analyseVariance(const std::vector<double>& response, const std::vector<Factor>& factors);

}  // namespace lamina
