// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "lamina/base/progress.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// Settings of a genetic search [Vega2023, section 6.3].
struct GeneticSettings {
  int individuals = 100;
  int generations = 100;
  double mutation_probability = 0.6;  ///< probability that a child is changed in one variable
  double mutation_step = 0.5;         ///< greatest change, as a share of the variable's range
};

/// Adds the keys genetic.*.
void describe(SettingsSchema& schema, GeneticSettings& settings);

/// How good a point is. The point with less violation is better, whatever its cost; of two points with equal
/// violation, the one with less cost is better.
struct Merit {
  double violation = 0.0;  ///< 0 if all constraints hold
  double cost = 0.0;
};

/// Whether a is better than b. A merit that is not a number is worse than any that is.
bool isBetter(const Merit& a, const Merit& b);

/// Computes the merit of a point.
using MeritOf = std::function<Merit(const DesignPoint&)>;

/// The best point of a search.
struct Fittest {
  DesignPoint point;
  Merit merit;
};

/// Seeks the point of best merit. The first generation is random. In each further generation a parent is the
/// better of two individuals drawn at random. Of two children, the first takes each value from either parent
/// with even chance, the second from the other one. A child is mutated with the mutation probability: one
/// random variable changes by a uniform share of its range, a Categorical one to any other choice. Values are
/// then moved to the nearest allowed ones. The best individual so far replaces the worst.
/// @param merit_of  called from one thread at a time
/// @throws Cancelled
Fittest searchGenetically(const DesignSpace& space, const MeritOf& merit_of, const GeneticSettings& settings,
                          std::uint64_t seed, Progress& progress);

/// Improves a point along one variable at a time. The step of each variable is at first an eighth of its
/// range; it doubles while it helps, up to half the range, and halves while it does not, down to a millionth.
/// Integer variables and Levels move to neighbouring values, Categorical ones do not change. Ends after some
/// 2000 trials at the latest.
Fittest refined(const DesignSpace& space, const MeritOf& merit_of, Fittest start);

}  // namespace lamina
