// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// How one alternative of a front is chosen.
enum class DecisionMethod {
  Linmap,  ///< the least distance from the ideal
  Topsis,  ///< the greatest distance from the worst, as a share of both distances
};

/// The alternative that is chosen, and how the others compare.
struct Decision {
  std::size_t chosen = 0;       ///< the first one if several are equally good
  std::vector<double> indices;  ///< of each alternative. Linmap: the least is best; Topsis: the greatest
};

/// Chooses an alternative [Guacheta2021, eq. 4.12 to 4.14]. Each cost is divided by its greatest magnitude
/// over all alternatives; the distance of two alternatives is sqrt(sum over costs of weight * difference^2).
///
/// Linmap: the ideal of a cost is 0 if no value is negative; otherwise (a response to be maximised, with its
/// sign changed) it is the least value. Topsis: the ideal is the least value of each cost, the worst the
/// greatest; if both coincide, all indices are 1. A cost that is 0 everywhere has no influence.
///
/// @param costs  for each alternative; less is better
/// @param weights  one for each cost, none negative, not all 0
/// @throws InvalidInput if there is no alternative, one has another number of costs than there are weights,
///   or a number is not finite; InvalidConfig if a weight is negative or all are 0
Decision decide(const std::vector<std::vector<double>>& costs, const std::vector<double>& weights,
                DecisionMethod method);

}  // namespace lamina
