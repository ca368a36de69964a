// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/planar/layer_stack.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"

namespace lamina {

/// One layer of a part, as planners start from it: its heights, and the cross-section of the mesh in it.
struct Layer {
  LayerBounds bounds;
  Section section;
};

}  // namespace lamina
