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
  FractionalFactorial,  ///< two levels; some variables follow from the others
  LatinHypercube,       ///< each variable's range is sampled evenly
};

/// An experiment as a person asks for it.
struct ExperimentDesignSettings {
  DesignKind kind = DesignKind::LatinHypercube;
  std::string levels = "2";  ///< FullFactorial, of continuous and integer variables
  std::string generators;    ///< FractionalFactorial
  int samples = 0;           ///< LatinHypercube; 0 for ten a variable
};

/// Adds the keys surrogate.design, .levels, .generators and .samples.
void describe(SettingsSchema& schema, ExperimentDesignSettings& settings);

/// The points the settings ask for; all different, the same for the same seed.
/// @throws InvalidConfig naming key and value as the functions below do
std::vector<DesignPoint> designExperiment(const DesignSpace& space, const ExperimentDesignSettings& settings,
                                          std::uint64_t seed);

/// Every combination of levels, the last variable changing fastest. Levels of Continuous and Integer
/// variables are evenly spaced and include the bounds; an Integer variable has no more of them than whole
/// numbers. Other variables take all their values.
/// @param level_counts  one for each variable, at least 2; of no effect for Levels and Categorical
/// @throws InvalidConfig if a count is below 2, or there would be more than a million points
std::vector<DesignPoint> fullFactorial(const DesignSpace& space, const std::vector<int>& level_counts);

/// Points spread such that each Continuous variable has one in the middle of each of `count` equal parts of
/// its range, and each other variable takes its values equally often (but for the remainder). Of all such
/// designs one is sought by exchanges whose nearest points are far apart ([Morris1995]: the sum
/// of distances to the power of -15). Points that would coincide are exchanged for random ones.
/// @throws InvalidConfig if there are fewer than 2 points, or more than the space has different ones
std::vector<DesignPoint> latinHypercube(const DesignSpace& space, std::size_t count, std::uint64_t seed);

}  // namespace lamina
