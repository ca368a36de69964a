// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// An island of a layer, as far as boxes tell: what is laid of the part at one place.
struct LaidPlace {
  Box2 box;                         ///< [mm, in the plane of the layers]
  std::vector<std::size_t> visits;  ///< the stretches of the layer's paths that lie in it, in their order
};

/// Paths that follow each other at one place, with the travels between them.
struct PlaceVisit {
  std::size_t begin = 0;  ///< of the travels that lead to it
  std::size_t first = 0;  ///< path that deposits
  std::size_t end = 0;    ///< behind the last one that does
};

/// A layer by places. Those whose boxes overlap are one; build aids and drops of material are at none.
struct PlacedLayer {
  std::vector<PlaceVisit> visits;  ///< of all paths but travels behind the last of them
  std::vector<LaidPlace> places;   ///< in the order in which they are first visited
};

/// @param layers_from_part  turns the plane of the layers level
PlacedLayer placesOf(const ToolpathLayer& layer, const Eigen::Quaterniond& layers_from_part);

/// When each place of a layer may be laid, and when it was left last.
struct PlaceTimes {
  std::vector<Box2> boxes;
  std::vector<double> left_s;
};

/// When what lies beneath a box was left last; before all time if nothing lies there.
double leftBeneath(const Box2& box, const PlaceTimes& below);

}  // namespace lamina
