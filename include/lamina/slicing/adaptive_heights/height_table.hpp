// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/slicing/planar/layer_stack.hpp"

namespace lamina {

/// A table of layers as CSV text, with the columns z_mm, the top of a layer above the bottom of the first
/// one, and height_mm.
std::string heightTable(const std::vector<LayerBounds>& bounds);

/// The layers of a part that reaches from `bottom_mm` to `top_mm`, with the heights of a table. Layers at the
/// top whose cut would lie above the part are left out.
/// @param path  path of a table in the format of `heightTable`
/// @throws InvalidInput naming the line if a layer does not begin where the one before ends, a height is not
///   positive, or a value is no number; also if the table ends below `top_mm` by more than half of its last
///   layer, and as `readCsvTable`
std::vector<LayerBounds> readHeightTable(const std::string& path, double bottom_mm, double top_mm);

}  // namespace lamina
