// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/triangle_fans.hpp"
#include "parameterization/landmark_mds.hpp"

namespace lamina {

/// Stress of a parameterization: the sum, over the sides of triangles and over the geodesics from vertices to
/// landmarks, of (length in the plane / length on the surface - 1)². A side counts once for each of its
/// triangles; all landmarks of a vertex together count as much as one side.
double stressOf(const std::vector<Point2>& parameterization, const TriangleFans& fans,
                const Landmarks& landmarks);

/// Reduces the stress of a parameterization by majorisation (SMACOF): one vertex after the other is moved to
/// the mean of the positions that its sides and landmarks ask for [Gansner2004].
std::vector<Point2> lessenStress(std::vector<Point2> parameterization, const TriangleFans& fans,
                                 const Landmarks& landmarks);

}  // namespace lamina
