// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/slicing/planar/layer_stack.hpp"

namespace lamina {

/// Layers as CSV with the columns z_mm, the top of a layer over the part's lowest point, and height_mm.
std::string heightTable(const std::vector<LayerBounds>& bounds);

/// Layers of a part that reaches from `bottom_mm` to `top_mm`, as a table says. Layers that would be cut
/// above the part are left out.
/// @param path  of a table as `heightTable` makes it
/// @throws InvalidInput naming the line if a layer does not begin where the one before ends, a height is not
/// positive, a value is no number, or the table ends below the part by more than half of its last layer; as
/// `readCsvTable`
std::vector<LayerBounds> readHeightTable(const std::string& path, double bottom_mm, double top_mm);

}  // namespace lamina
