// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/pattern/gyroid_section.hpp"
#include "infill/pattern/pattern_cut.hpp"

namespace lamina {

/// The curves of a level section across a box: one period of each of two graphs, followed by chords, repeated
/// as often as it takes.
/// @param section  a level one
PatternCurves levelGyroidCurves(const GyroidSection& section, const Box2& box, double chord_error_mm);

}  // namespace lamina
