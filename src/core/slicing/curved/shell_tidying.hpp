// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// What is too small to lay [mm²].
struct TidyLimits {
  double least_piece_mm2 = 0.0;   ///< smaller pieces are dropped
  double largest_hole_mm2 = 0.0;  ///< smaller holes are closed
};

/// A shell without what cannot be deposited. Holes are closed by triangles from their middle, if these face
/// as the shell does around them. Cuts along creases and walls leave both.
LayerSurface tidied(const LayerSurface& shell, const TidyLimits& limits);

}  // namespace lamina
