// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Two groups compared.
struct RankComparison {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;   ///< of mean ranks, first less second
  double probability = 0.0;  ///< of so great a difference by chance, all pairs accounted for
};

/// Whether groups come from one distribution, by ranks.
struct KruskalWallis {
  double h = 0.0;  ///< corrected for ties
  std::size_t degrees_of_freedom = 0;
  double probability = 0.0;        ///< by chi²
  std::vector<double> mean_ranks;  ///< by group; equal values share their mean rank
  /// Every pair by Tukey and Kramer on mean ranks: the difference over its error is compared with the
  /// studentised range of so many groups.
  std::vector<RankComparison> comparisons;
};

/// @throws InvalidInput if there are fewer than two groups, one is empty, a value is not finite, or all are
///   equal
KruskalWallis testRanks(const std::vector<std::vector<double>>& groups);

/// Probability that the range of `count` standard normal values is above q: the studentised range with
/// infinitely many degrees of freedom.
double probabilityOfRangeAbove(double q, std::size_t count);

}  // namespace lamina
