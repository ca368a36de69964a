// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "infill/rectilinear/raster_walk.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How a pass ends.
enum class PassEnd {
  Free,  ///< freely: it fills its variable-width line to the end
  Turn,  ///< at a link as wide as the variable-width line, which keeps half of that width from the border
  LinkAbove,  ///< at a narrow link along the border that closes the variable-width line from above
  LinkBelow,  ///< at a narrow link along the border that closes the variable-width line from below
  Joined,     ///< at such a link of the neighbouring variable-width line, which continues where this one ends
};

struct PassEndShape {
  PassEnd kind = PassEnd::Free;
  double inset_mm = 0.0;  ///< distance of a turn from the end of the line
  Vertical towards =
      /// Direction in which the variable-width line continues around the end, if it does so on both sides.
      Vertical::Up;
};

/// A stretch of outline that enters a variable-width line from its edge and returns to that edge.
struct Notch {
  std::size_t pass = 0;  ///< index of the segment inside that it touches
  std::uint32_t crossing = 0;
  Vertical direction = Vertical::Up;  ///< direction in which it leaves the edge
  bool is_cap = false;                ///< whether there is material beyond the edge that no other pass fills
};

/// All notches, sorted by pass.
std::vector<Notch> findNotches(const RasterWalk& walk);

/// The variable-width lines of a raster whose passes run along its odd lines.
struct VariableWidthLines {
  const RasterWalk& walk;
  std::vector<Notch> notches;
  double narrowest_mm = 0.0;  ///< plan width; outlines of the raster keep half of it from the area's border
};

/// The bead that fills the variable-width line around the raster segment that begins at `left`: in the middle
/// of the material, and as wide as the material. It runs from left to right, in the raster frame; a single
/// point if there is no room for more.
FillPath passThrough(const VariableWidthLines& lines, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end);

}  // namespace lamina
