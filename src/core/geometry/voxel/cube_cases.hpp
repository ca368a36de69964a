// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lamina {

/// An edge of the unit cube: from a corner one step along an axis.
struct CubeEdge {
  std::array<int, 3> corner{};
  int axis = 0;
};

/// The twelve edges: four along x, four along y, four along z.
const std::array<CubeEdge, 12>& cubeEdges();

/// A closed line over edges of the cube that parts the corners inside from those outside, counter-clockwise
/// seen from outside.
struct CubeLoop {
  std::vector<std::uint8_t> edges;
  /// A fan from the first edge has no diagonal within a face of the cube. If false, only a fan about a point
  /// amid the loop has none.
  bool is_fan = true;
};

/// The loops of a cube. Bit x + 2 y + 4 z of the case reports whether that corner is inside.
const std::vector<CubeLoop>& cubeLoops(unsigned corners_inside);

}  // namespace lamina
