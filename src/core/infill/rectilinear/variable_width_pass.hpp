// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "infill/rectilinear/raster_walk.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// What a pass meets at one of its ends.
enum class PassEnd {
  Free,       ///< nothing: it fills its variable-width line as far as that goes
  Turn,       ///< a link as wide as the variable-width line that keeps half of that from the border
  LinkAbove,  ///< a narrow link along the border that closes the variable-width line from above
  LinkBelow,  ///< the same from below
  Joined,     ///< such a link of the neighbouring variable-width line, which goes on where this one ends
};

struct PassEndShape {
  PassEnd kind = PassEnd::Free;
  double inset_mm = 0.0;  ///< of a turn, from the end of the line
  Vertical towards =
      Vertical::Up;  ///< where the variable-width line goes on round the end, if it does both ways
};

/// An outline that comes into a variable-width line from its edge and goes back to it.
struct Notch {
  std::size_t pass = 0;  ///< line inside that it touches
  std::uint32_t crossing = 0;
  Vertical direction = Vertical::Up;  ///< in which its chain leaves the edge
  bool is_cap = false;                ///< material beyond the edge that no other pass fills
};

/// All of them, by pass.
std::vector<Notch> findNotches(const RasterWalk& walk);

/// The variable-width lines of a raster whose passes run along its odd lines.
struct VariableWidthLines {
  const RasterWalk& walk;
  std::vector<Notch> notches;
  double narrowest_mm = 0.0;  ///< plan width; outlines of the raster keep half of it from the area's border
};

/// The bead that fills the variable-width line round the raster line that begins at `left`: in the middle of
/// the material there, and as wide. From left to right, in the raster frame; a single point if there is no
/// more room.
FillPath passThrough(const VariableWidthLines& lines, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end);

}  // namespace lamina
