// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/pattern/gyroid_section.hpp"
#include "infill/pattern/pattern_cut.hpp"

namespace lamina {

/// The curves of a section in a box, by marching squares over a grid slightly larger than the box, in time
/// linear in its area; then motions are divided until they are within the chord error of the surface. Curves
/// do not cross. Where the plane nearly touches the surface, so that two curves approach each other within a
/// tenth of a step, they may be connected the other way.
/// @param step_mm  step of the grid; a sixteenth of the cell is fine enough
PatternCurves gyroidCurves(const GyroidSection& section, const Box2& box, double step_mm,
                           double chord_error_mm);

}  // namespace lamina
