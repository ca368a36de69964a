// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// How the points of an experiment are arranged.
enum class DesignKind {
  FullFactorial,        ///< every combination of levels
  FractionalFactorial,  ///< two levels; the values of some variables follow from those of the others
  LatinHypercube,       ///< each variable's range is sampled evenly
};

/// Settings of an experiment, as a user states them.
struct ExperimentDesignSettings {
  DesignKind kind = DesignKind::LatinHypercube;
  std::string levels = "2";  ///< FullFactorial: numbers of levels, one for all variables or one for each
  std::string generators;    ///< FractionalFactorial: see `fractionalFactorial`
  int samples = 0;           ///< LatinHypercube: number of points; 0 for ten times the number of variables
};

/// Adds the keys surrogate.design, .levels, .generators and .samples.
void describe(SettingsSchema& schema, ExperimentDesignSettings& settings);

/// The points of an experiment; all different, and the same for the same seed.
/// @throws InvalidConfig naming key and value if `levels` is malformed; as the functions below
std::vector<DesignPoint> designExperiment(const DesignSpace& space, const ExperimentDesignSettings& settings,
                                          std::uint64_t seed);

/// Every combination of levels, the last variable changing fastest. Levels of Continuous and Integer
/// variables are evenly spaced and include the bounds; an Integer variable has no more of them than whole
/// numbers. Other variables take all their values.
/// @param level_counts  one for each variable, at least 2; of no effect for Levels and Categorical
/// @throws InvalidConfig if a count is below 2, or there would be more than a million points
std::vector<DesignPoint> fullFactorial(const DesignSpace& space, const std::vector<int>& level_counts);

/// A Latin hypercube of `count` points. Each Continuous variable has one value in the middle of each of
/// `count` equal parts of its range; each other variable takes its values equally often, but for the
/// remainder. Among these designs, exchanges of values seek one whose nearest points are far apart: they
/// minimise the sum of all distances to the power of -15 [Morris1995]. Points that would coincide are
/// replaced by random ones.
/// @throws InvalidConfig if there are fewer than 2 points, or more than the space has
std::vector<DesignPoint> latinHypercube(const DesignSpace& space, std::size_t count, std::uint64_t seed);

}  // namespace lamina
