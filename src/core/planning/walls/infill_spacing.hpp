// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// The position of a layer in its stack.
struct LayerPlace {
  std::size_t index = 0;  ///< from 0
  std::size_t count = 1;  ///< of all layers
};

/// Spacing of the lines of infill in one layer.
struct InfillSpacing {
  double spacing_mm = 0.0;  ///< centre distance of neighbouring lines; 0: no lines
  double pitch_mm = 0.0;    ///< width of the strip that a nominal bead fills
};

/// Whether neighbouring lines touch, and narrow gaps between them are filled.
inline bool isSolid(const InfillSpacing& infill) { return infill.spacing_mm == infill.pitch_mm; }

/// The spacing by `infill.pitch_mm`, `infill.density` and, in the first and last `infill.outer_layers`,
/// `infill.outer_pitch_mm`. A spacing up to 1.25 pitches makes a solid fill, whose beads overlap or leave
/// small gaps.
/// @param pitch_mm  distance at which beads fill the layer exactly, or `bead.pitch_mm`
/// @throws InvalidConfig naming the key if a pitch is less than half of that
InfillSpacing infillSpacing(const InfillSettings& settings, double pitch_mm, const LayerPlace& place);

}  // namespace lamina
