// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "variation.hpp"

namespace lamina {

/// As many new points as there are parents: winners of binary tournaments (by front, then by crowding) in
/// pairs, crossed and mutated by pagmo's operators. Integers, levels and choices take the operators for
/// integers, by their indices.
std::vector<DesignPoint> varyBySbx(const DesignSpace& space, const Nsga2Settings& settings,
                                   const std::vector<Parent>& population, Random& random);

}  // namespace lamina
