// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/pattern/gyroid_section.hpp"
#include "infill/pattern/pattern_cut.hpp"

namespace lamina {

/// The curves of a section across a box: marching squares over a grid that goes a little beyond it, in time
/// linear in its area, then motions divided until they leave the surface by no more than the chord error.
/// Curves do not meet. Where the plane nearly touches the surface and two curves come together, they may turn
/// the other way, within a tenth of a step.
/// @param step_mm  of the grid; a sixteenth of the cell is fine enough
PatternCurves gyroidCurves(const GyroidSection& section, const Box2& box, double step_mm,
                           double chord_error_mm);

}  // namespace lamina
