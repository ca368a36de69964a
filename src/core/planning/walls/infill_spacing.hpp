// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Where a layer stands in its stack.
struct LayerPlace {
  std::size_t index = 0;  ///< from 0
  std::size_t count = 1;  ///< of all layers
};

/// How the lines of infill of one layer lie.
struct InfillSpacing {
  double spacing_mm = 0.0;  ///< between neighbouring lines, centre to centre; 0 lays none
  double pitch_mm = 0.0;    ///< plan width that a bead of nominal cross-section fills
};

/// Whether neighbouring lines lie side by side, and narrow rests between them are filled.
inline bool isSolid(const InfillSpacing& infill) { return infill.spacing_mm == infill.pitch_mm; }

/// What `infill.pitch_mm`, `infill.density` and, in the first and last `infill.outer_layers`,
/// `infill.outer_pitch_mm` ask for. Up to 1.25 pitches a pitch is that of a solid fill, whose beads overlap
/// or leave a little open.
/// @param pitch_mm  at which beads fill the layer exactly, or `bead.pitch_mm`
/// @throws InvalidConfig naming the key if a pitch is less than half of that
InfillSpacing infillSpacing(const InfillSettings& settings, double pitch_mm, const LayerPlace& place);

}  // namespace lamina
