// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// An island of a layer, identified by its box: all that is deposited of the part at one place.
struct DepositedPlace {
  Box2 box;                         ///< [mm, in the plane of the layers]
  std::vector<std::size_t> visits;  ///< indices of the visits to it, in order
};

/// Paths that follow each other at one place, with the travels between them.
struct PlaceVisit {
  std::size_t begin = 0;  ///< index of the first travel that leads to it
  std::size_t first = 0;  ///< index of the first path that deposits
  std::size_t end = 0;    ///< one past the last path that deposits
};

/// A layer divided into places. Places with overlapping boxes are one; build aids and drops have none.
struct PlacedLayer {
  std::vector<PlaceVisit> visits;      ///< all paths except travels after the last of them
  std::vector<DepositedPlace> places;  ///< in the order in which they are first visited
};

/// Divides a layer.
/// @param layers_from_part  rotation that makes the plane of the layers level
PlacedLayer placesOf(const ToolpathLayer& layer, const Eigen::Quaterniond& layers_from_part);

/// The places of a layer, and the times at which they were left last.
struct PlaceTimes {
  std::vector<Box2> boxes;
  std::vector<double> left_s;
};

/// Latest time at which a place below a box was left; minus infinity if there is none.
double leftBelow(const Box2& box, const PlaceTimes& below);

}  // namespace lamina
