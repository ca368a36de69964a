// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/control/bead_section.hpp"
#include "lamina/control/cell_atlas.hpp"
#include "lamina/control/profile_reading.hpp"

namespace lamina {

/// The lack of cross-section of a cell.
struct SectionReading {
  std::size_t cell = 0;  ///< of the newest layer
  double deficit = 0.0;  ///< as `sectionDeficit`
};

/// The upper contours of the beads of a layer, gathered from all profiles that show them: a bead that lies
/// along the sensor's line of light is shown point by point across, by one profile after the other.
///
/// The contour of each cell is kept in twelve strips across its bead, as means of the points in them. A point
/// on a neighbouring bead belongs to that bead. Where the light passes the base of a bead of a plane layer
/// within the planned width, and meets nothing before, a layer's height is missing. Points on the same cells
/// in the same order give the same contours. 144 bytes a cell.
class SectionContours {
 public:
  /// Forgets all contours: a layer begins.
  void begin();
  /// Adds the points of a profile that lie on deposited cells of the newest layer of the atlas.
  void see(const SensorProfile& profile, const CellAtlas& atlas, const SightSettings& settings);
  /// The readings of the cells that have received points since the last call, ascending by cell. Cells whose
  /// contour has too few strips (`sectionDeficit`) are left out.
  std::vector<SectionReading> take();

 private:
  static constexpr std::size_t kStrips = 12;
  /// Means of the points of a strip.
  struct Strip {
    float across_mm = 0.0F;
    float lower_mm = 0.0F;  ///< depth below the planned top, beyond that of the planned contour at its place
    unsigned points = 0;
  };
  using Contour = std::array<Strip, kStrips>;

  void add(std::size_t cell, double across_mm, double below_mm);
  std::vector<ContourPoint> contourOf(std::size_t cell) const;
  Bead beadOf(std::size_t cell) const { return {cells_->width_mm[cell], cells_->height_mm[cell]}; }

  std::shared_ptr<const LayerCells> cells_;  ///< of the layer; null before its first profile
  std::vector<Contour> contours_;            ///< one for each cell
  std::vector<std::size_t> touched_;         ///< cells that points were added to; some of them several times
};

}  // namespace lamina
