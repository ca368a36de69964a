// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/nsga2.hpp"

namespace lamina {

/// A member of the population from which new points are made.
struct Parent {
  const DesignPoint* point = nullptr;
  std::size_t rank = 0;  ///< rank of its front; 0 is the best
  double crowding = 0.0;
};

/// Number of points that `vary` makes.
std::size_t offspringOf(const Nsga2Settings& settings);

/// Makes new points in the space, by the variation that the settings ask for.
std::vector<DesignPoint> vary(const DesignSpace& space, const Nsga2Settings& settings,
                              const std::vector<Parent>& population, Random& random);

/// Corners of the space, at most `most`; opposite ones follow each other, beginning with all lows and all
/// highs. The box spanned by two opposite corners is the whole space, so that blends of points are not
/// confined to a smaller one. Categorical variables get random values.
std::vector<DesignPoint> cornersOf(const DesignSpace& space, std::size_t most, Random& random);

}  // namespace lamina
