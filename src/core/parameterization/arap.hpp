// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "parameterization/arap_energy.hpp"

namespace lamina {

/// The parameterization in which triangles keep their shape as well as possible, found from a guess. The best
/// rotation of each triangle and the best parameterization for these rotations are computed in turn. An exact
/// guess is returned unchanged.
/// @param guess  position of each vertex [mm]; the surface must be connected by edges
std::vector<Point2> relaxArap(const ArapEnergy& energy, std::vector<Point2> guess);

/// Approximates `relaxArap` in a fraction of the time, from a guess that is smooth and does not overlap
/// itself. The best parameterization for the rotations is sought by steps on a coarse grid and steps of
/// single vertices.
std::vector<Point2> relaxCoarsely(const ArapEnergy& energy, std::vector<Point2> guess);

}  // namespace lamina
