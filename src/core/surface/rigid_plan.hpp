// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh.hpp"

namespace lamina {

/// The plan near a guess in which the triangles keep their shape as well as they can: least sum over the
/// sides of (difference from the turned side)² times the cotangent of the angle across it ("as rigid as
/// possible", Liu et al. 2008). Cotangents are kept positive, so that each step lessens the sum. A guess that
/// is exact stays.
///
/// @param surface  [mm] connected by edges
/// @param guess    of each vertex [mm]
std::vector<Point2> relaxRigidly(const Mesh& surface, std::vector<Point2> guess);

}  // namespace lamina
