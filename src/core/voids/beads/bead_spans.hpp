// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "voids/beads/scan_rows.hpp"

namespace lamina {

/// Which width of a bead counts.
enum class BeadMeasure {
  Reach,  ///< that of its cross-section
  Plan,   ///< that which it fills
};

/// Where beads of one run lie on a row. The arc length along the run changes evenly from one end to the
/// other.
struct BeadSpan : Span {
  std::uint32_t run = 0;  ///< index of the path in its layer
  double arc_low = 0.0;   ///< [mm] along the run where the span is lowest
  double arc_high = 0.0;
};

/// What a layer deposits, row by row and unsorted; skirt and travel left out.
std::vector<std::vector<BeadSpan>> beadSpans(const ToolpathLayer& layer, const ScanRows& rows,
                                             BeadMeasure measure);

/// A drop is a pass of its own: it is this much farther along its run than the drop before [mm].
constexpr double kDropArc = 1e6;

}  // namespace lamina
