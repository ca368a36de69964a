// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A point of the upper contour of a bead.
struct ContourPoint {
  double across_mm = 0.0;  ///< from the bead's middle
  double below_mm = 0.0;   ///< below the planned top, along the growth direction
};

/// Lack of cross-section of a bead by its upper contour, over the planned cross-section; negative if there is
/// too much. It is measured below the bead's own crown and above its planned base, so that neither the height
/// of the nozzle nor settling counts. Each point stands for a strip as wide as the mean spacing of points,
/// and lacks what it lies lower than the planned stadium does at its place: a bead as planned lacks nothing,
/// wherever the points lie. A bead that is too wide shows by its shoulders alone, up to (1/2 - pi/8) h² / A;
/// flanks in shadow count as planned.
/// @param contour  points within half the bead's width of its middle
/// @return nothing if there are fewer than five points, none on the crown (the middle third), or none beyond
///   three tenths of the width on either side
std::optional<double> sectionDeficit(const std::vector<ContourPoint>& contour, const Bead& bead);

/// The lack of cross-section of a cell.
struct SectionReading {
  std::size_t layer = 0;
  std::size_t cell = 0;
  double deficit = 0.0;  ///< as `sectionDeficit`
};

/// Reads the cross-sections of the beads of the newest layer that a profile crosses, one of each crossing.
/// Points that lie on a neighbouring bead are that one's.
std::vector<SectionReading> readSections(const SensorProfile& profile, const CellAtlas& atlas,
                                         const SightSettings& settings);

/// States to the loop of a pressed process the sections of its layer that a profile shows; without effect on
/// that of a free one.
void seeSections(HeightLoop& loop, const SensorProfile& profile, const CellAtlas& atlas,
                 const SightSettings& settings);

}  // namespace lamina
