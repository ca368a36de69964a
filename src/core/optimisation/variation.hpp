// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/nsga2.hpp"

namespace lamina {

/// One of a population that new points are made of.
struct Parent {
  const DesignPoint* point = nullptr;
  std::size_t rank = 0;  ///< of its front; 0 is the best
  double crowding = 0.0;
};

/// Number of points `vary` makes.
std::size_t offspringOf(const Nsga2Settings& settings);

/// New points within the space, by the variation the settings ask for.
std::vector<DesignPoint> vary(const DesignSpace& space, const Nsga2Settings& settings,
                              const std::vector<Parent>& population, Random& random);

/// Corners of the space, at most that many, opposite ones one after the other: lows and highs first. A box
/// that two opposite corners span is the whole space, which blends of other points cannot leave. Categorical
/// variables take random choices.
std::vector<DesignPoint> cornersOf(const DesignSpace& space, std::size_t most, Random& random);

}  // namespace lamina
