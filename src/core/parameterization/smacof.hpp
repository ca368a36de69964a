// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/triangle_fans.hpp"
#include "parameterization/landmark_mds.hpp"

namespace lamina {

/// Sum over the sides of triangles and over the ways from vertices to landmarks of (length in the parameter
/// plane / length on the surface - 1)². Sides count as often as they have triangles, landmarks together as
/// one side.
double stressOf(const std::vector<Point2>& parameterization, const TriangleFans& fans,
                const Landmarks& landmarks);

/// Lessens the stress of a parameterization by majorisation (SMACOF): one vertex after the other moves to the
/// mean of the places that its sides and landmarks would have it at [Gansner2004].
std::vector<Point2> lessenStress(std::vector<Point2> parameterization, const TriangleFans& fans,
                                 const Landmarks& landmarks);

}  // namespace lamina
