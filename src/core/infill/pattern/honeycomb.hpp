// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Hexagons, their walls standing on each other in all layers. Each run is a row of half hexagons; where two
/// rows meet, two beads lie side by side, on one edge in three. At spacing s and pitch p the distance of
/// parallel walls is (4 s + sqrt(16 s² - 12 p s)) / 3, which makes the beads as long in an area as those of a
/// zigzag: 8 s / 3 for thin walls, and lines side by side at s = p. A solid fill is a zigzag.
std::vector<FillPath> honeycomb(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
