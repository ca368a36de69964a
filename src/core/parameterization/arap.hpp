// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "parameterization/arap_energy.hpp"

namespace lamina {

/// The parameterization near a guess in which the triangles keep their shape as well as they can, by
/// alternating between the best turn of each triangle and the best parameterization for these turns. A guess
/// that is exact stays.
/// @param guess  of each vertex [mm]; the surface must be connected by edges
std::vector<Point2> relaxArap(const ArapEnergy& energy, std::vector<Point2> guess);

/// Nearly the same in a fraction of the time, from a guess that is smooth and does not overlap itself: the
/// best parameterization for the turns is sought by steps on a coarse grid, and steps of single vertices.
std::vector<Point2> relaxCoarsely(const ArapEnergy& energy, std::vector<Point2> guess);

}  // namespace lamina
