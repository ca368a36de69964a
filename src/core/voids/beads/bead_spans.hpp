// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "voids/beads/scan_rows.hpp"

namespace lamina {

/// The width of a bead that is measured.
enum class BeadMeasure {
  Reach,  ///< the width of its cross-section
  Plan,   ///< the width of the strip that it fills
};

/// An interval of a row covered by a bead. The arc length along the bead's run changes evenly from one end of
/// the interval to the other.
struct BeadSpan : Span {
  std::uint32_t run = 0;  ///< index of the path in its layer
  double arc_low = 0.0;   ///< [mm] along the run at the lower end of the interval
  double arc_high = 0.0;
};

/// The intervals covered by the deposition of a layer, row by row and unsorted; skirt and travels are left
/// out.
std::vector<std::vector<BeadSpan>> beadSpans(const ToolpathLayer& layer, const ScanRows& rows,
                                             BeadMeasure measure);

/// Arc length by which a drop is farther along its run than the drop before, so that each drop counts as a
/// pass of its own [mm].
constexpr double kDropArc = 1e6;

}  // namespace lamina
