// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/picture/canvas.hpp"
#include "lamina/picture/toolpath_picture.hpp"
#include "picture/bead_drawing.hpp"

namespace lamina {

/// Draws all deposited beads and drops, the farthest first.
/// @param box  bounding box of the deposition, from the bottom of the first layer
void drawDeposition(Canvas& canvas, const Projection& projection, const Toolpath& toolpath, const Box3& box,
                    PictureColour colouring);

}  // namespace lamina
