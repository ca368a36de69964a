// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/planar/layer_stack.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"

namespace lamina {

/// One layer of a part: where it lies and what the mesh looks like there. What planners start from.
struct Layer {
  LayerBounds bounds;
  Section section;
};

}  // namespace lamina
