// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Comparison of two groups by ranks.
struct RankComparison {
  std::size_t first = 0;     ///< index of the first group
  std::size_t second = 0;    ///< index of the second group
  double difference = 0.0;   ///< mean rank of the first group less that of the second
  double probability = 0.0;  ///< p-value, corrected for the comparison of all pairs
};

/// Result of a Kruskal-Wallis test.
struct KruskalWallis {
  double h = 0.0;  ///< H statistic, corrected for ties
  std::size_t degrees_of_freedom = 0;
  double probability = 0.0;        ///< p-value, by the chi² distribution
  std::vector<double> mean_ranks;  ///< mean rank of each group; equal values share their mean rank
  /// Comparisons of all pairs by the Tukey-Kramer method on mean ranks: the difference over its standard
  /// error is compared with the studentised range of the number of groups.
  std::vector<RankComparison> comparisons;
};

/// Kruskal-Wallis test of whether groups of values come from one distribution.
/// @throws InvalidInput if there are fewer than two groups, one is empty, a value is not finite, or all are
///   equal
KruskalWallis testRanks(const std::vector<std::vector<double>>& groups);

/// Probability that the range of `count` standard normal values exceeds q: the studentised range distribution
/// with infinitely many degrees of freedom.
double probabilityOfRangeAbove(double q, std::size_t count);

}  // namespace lamina
