// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// Turns and moves a plan to where the surface lies seen along z: least squares over the area, without
/// mirroring. Where that reports no direction, as below a surface that faces down, the direction in which the
/// surface runs towards x comes to lie along x, or, if it does not run there, the one towards y along y.
void layOverProjection(LayerChart& chart);

/// Moves plans such that no two of their boxes overlap: those in the way of earlier ones go into rows beyond
/// the others in y, 10 mm apart. Level charts at the same height stay where they are, in each other's holes
/// too.
void moveApart(std::vector<LayerChart>& charts);

}  // namespace lamina
