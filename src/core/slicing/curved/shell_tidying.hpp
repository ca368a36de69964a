// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// Sizes of what is too small to deposit.
struct TidyLimits {
  double least_piece_mm2 = 0.0;   ///< smaller pieces are dropped
  double largest_hole_mm2 = 0.0;  ///< smaller holes are closed
};

/// A shell without its small pieces and small holes, such as arise at cuts along creases and walls. A hole is
/// closed by triangles from its middle, provided that they face as the shell around it does.
LayerSurface tidied(const LayerSurface& shell, const TidyLimits& limits);

}  // namespace lamina
