// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Role of a drop in its layer.
enum class DropRole : std::uint8_t { Contour, Infill, VoidFill };

/// A sequence of drops that are deposited one after the other: the drops of the layer with the indices
/// [begin, end).
struct DropChain {
  DropRole role = DropRole::Infill;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The drops of one layer, all of one diameter, in the order of deposition.
struct DropLayer {
  double diameter_mm = 0.0;
  std::vector<Point2> drops;  ///< centres [mm]
  std::vector<DropChain> chains;
  bool is_dense = false;  ///< whether the infill is packed hexagonally
};

/// A contour of drops.
struct DropContour {
  std::size_t chain = 0;      ///< index of its chain in the layer
  Polygon outline;            ///< through the centres of its drops [mm]
  bool is_hole = false;       ///< whether it follows a hole; it is then clockwise
  bool is_border = false;     ///< whether it is the outermost of the contours along its outline or hole
  bool is_innermost = false;  ///< whether no other contour is inside of it
};

/// The contours of a layer: its chains of role Contour with at least three drops. Contours around material
/// are counter-clockwise, those around holes clockwise. A contour around material is a border unless the next
/// contour outside of it is also counter-clockwise. A contour around a hole is a border unless the next
/// contour inside of it is also clockwise. A contour around a hole is no border either if a gap of more than
/// 2.5 diameters shows that drops are missing, and another contour is the border of the hole. A contour with
/// such a gap that crosses a contour without one counts as the next outside of the latter only if there is no
/// other.
std::vector<DropContour> contoursOf(const DropLayer& layer);

/// The outlines of the border contours, which bound the material by the even-odd rule; empty if there is no
/// contour.
std::vector<Polygon> borders(const std::vector<DropContour>& contours);

/// Guesses the chains of a layer whose program does not distinguish contours from infill. A chain continues
/// as long as each drop is at most two diameters from the one before, and ends where it returns to its start.
/// A closed chain is a contour if it is inside of no other closed chain. A closed chain inside of another is
/// a contour too, of a hole, if it encloses a space without drops that is wider than 1.2 diameters. All other
/// chains are infill.
std::vector<DropChain> guessChains(const std::vector<Point2>& drops, double diameter_mm);

}  // namespace lamina
