// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lamina {

/// A categorical factor: its level at each observation.
struct Factor {
  std::string name;
  std::vector<std::string> levels;
};

/// How much of the response a factor, or the interaction of two factors, explains.
struct VarianceSource {
  std::string name;  ///< "layer", "layer x infill"
  double sum_of_squares = 0.0;
  std::size_t degrees_of_freedom = 0;
  double f = 0.0;
  double probability = 0.0;  ///< of so great an f by chance
};

struct AnalysisOfVariance {
  std::vector<VarianceSource> sources;  ///< factors, then pairs
  double residual_sum_of_squares = 0.0;
  std::size_t residual_degrees_of_freedom = 0;
};

/// Analysis of variance of fixed factors with all two-way interactions. Sums of squares are of type III, with
/// contrasts that sum to zero: each source against the model of all the others. Where the cells are of equal
/// size, all types are the same.
/// @throws InvalidInput if there is no factor, one has fewer than two levels or another number of
/// observations
///   than the response, a value is not finite, a pair of levels was never observed (their interaction cannot
///   be estimated), or nothing is left to estimate the error by
AnalysisOfVariance analyseVariance(const std::vector<double>& response, const std::vector<Factor>& factors);

}  // namespace lamina
