// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What a drop belongs to.
enum class DropRole : std::uint8_t { Contour, Infill, VoidFill };

/// Drops deposited one after the other: the drops [begin, end) of their layer.
struct DropChain {
  DropRole role = DropRole::Infill;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The drops of one layer, all of one diameter, in the order they are deposited.
struct DropLayer {
  double diameter_mm = 0.0;
  std::vector<Point2> drops;  ///< centres [mm]
  std::vector<DropChain> chains;
  bool is_dense = false;  ///< the infill is packed hexagonally
};

/// A contour of drops.
struct DropContour {
  std::size_t chain = 0;      ///< index among the layer's chains
  Polygon outline;            ///< through the centres
  bool is_hole = false;       ///< follows a hole: it winds clockwise
  bool is_border = false;     ///< of the material; the others lie inside of such a one
  bool is_innermost = false;  ///< no other contour lies inside
};

/// The contours of the layer: its contour chains of three drops at least. A contour round material winds
/// counter-clockwise and is a border unless the next one around it does too; one round a hole winds clockwise
/// and is a border unless the next one inside does too. One that lacks so many drops that it has a step of
/// more than 2.5 diameters is no border of a hole where another one is, and is next around a whole one that
/// it runs across only if no other is around that.
std::vector<DropContour> contoursOf(const DropLayer& layer);

/// The borders of the material by the even-odd rule: outlines through the centres of the drops of its border
/// contours. None if the layer has no contour.
std::vector<Polygon> borders(const std::vector<DropContour>& contours);

/// Chains of a layer whose program does not distinguish contours from infill. Drops no farther from the one
/// before than two diameters are a chain, which ends where it returns to its start. Closed chains that lie in
/// no other are contours, and so are those inside of them round a space without drops and wider than 1.2
/// diameters: holes.
std::vector<DropChain> guessChains(const std::vector<Point2>& drops, double diameter_mm);

}  // namespace lamina
