// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/pattern/gyroid_section.hpp"
#include "infill/pattern/pattern_cut.hpp"

namespace lamina {

/// The curves of a level section in a box: one period of each of the two graphs, approximated by chords and
/// repeated as often as the box needs.
/// @param section  must be level
PatternCurves levelGyroidCurves(const GyroidSection& section, const Box2& box, double chord_error_mm);

}  // namespace lamina
