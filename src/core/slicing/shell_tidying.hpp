// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/surface/layer_surface.hpp"

namespace lamina {

/// A shell without what cannot be laid: pieces smaller than a tenth of a square of its height are gone, and
/// holes smaller than that of a bead (twice as wide as high) are closed by triangles from their middle, if
/// these face as the shell does around them. Cuts along creases and walls leave both.
LayerSurface tidied(const LayerSurface& shell, double height_mm);

}  // namespace lamina
