// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Hexagons whose walls stand on each other in all layers. Each run is a row of half hexagons; where two rows
/// meet, on one edge in three, two beads lie side by side. With spacing s and pitch p the distance of
/// parallel walls is (4 s + sqrt(16 s² - 12 p s)) / 3, so that the beads have the same length per area as
/// those of a zigzag. This is 8 s / 3 for thin walls; at s = p lines lie side by side. A solid fill is a
/// zigzag.
std::vector<FillPath> honeycomb(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
