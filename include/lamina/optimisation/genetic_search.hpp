// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "lamina/base/progress.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// A genetic search [Vega2023, section 6.3].
struct GeneticSettings {
  int individuals = 100;
  int generations = 100;
  double mutation_probability = 0.6;  ///< that a child is changed in one variable
  double mutation_step = 0.5;         ///< greatest change, as a share of the variable's range
};

/// Adds the keys genetic.*.
void describe(SettingsSchema& schema, GeneticSettings& settings);

/// How good a point is. What violates less is better, whatever its cost; of equal violation, what costs less.
struct Merit {
  double violation = 0.0;  ///< 0 if all constraints hold
  double cost = 0.0;
};

/// Whether a is better than b. A merit that is not a number is worse than any that is.
bool isBetter(const Merit& a, const Merit& b);

using MeritOf = std::function<Merit(const DesignPoint&)>;

struct Fittest {
  DesignPoint point;
  Merit merit;
};

/// Seeks the point of best merit with random individuals first; then, generation after generation: parents
/// are the better of two drawn at random; their children take each value from one parent or, with even
/// chance, from the other, and the second child takes what the first did not; a child is changed with the
/// mutation probability in one random variable by a uniform share of its range (a choice without order
/// becomes any other one); values are brought to the nearest allowed; the best so far replaces the worst.
/// @param merit_of  called from one thread at a time
/// @throws Cancelled
Fittest searchGenetically(const DesignSpace& space, const MeritOf& merit_of, const GeneticSettings& settings,
                          std::uint64_t seed, Progress& progress);

/// Better points along single variables: each step doubles while it helps and halves while it does not, from
/// the mutation step down to a millionth of the range. Discrete variables move to neighbouring values.
Fittest refined(const DesignSpace& space, const MeritOf& merit_of, Fittest start);

}  // namespace lamina
