// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// What a learnt map is good for.
struct PartIdentity {
  std::string program;  ///< its hash
  std::string machine;
  std::string material;
};

/// Relative amounts learnt from the parts before, by layer and cell: how to lay the same part again.
struct PartMap {
  PartIdentity identity;
  std::size_t parts = 0;  ///< learnt from
  std::vector<std::vector<double>> amount;
};

/// How a layer of a part turned out.
struct LaidLayer {
  LayerCells cells;
  std::vector<double> amount;  ///< relative, as laid
  /// Planned less actual growth of this layer alone; not finite where not seen.
  std::vector<double> growth_error_mm;
};

/// How a part ended. One that was aborted teaches nothing.
enum class PartEnd { Complete, Aborted };

/// The map for the next part: u = Q (u + K F (1 / g - 1 - u)) [Bristow2006], u the map before, 0 for the
/// first part, and g how much of what it was told each layer has grown by itself. What was laid beyond the
/// map to mend layers below is not learnt. F is the loop's low-pass along the path, Q the mean of a layer and
/// its two neighbours where their cells are as many. K is `part_learning`, and of the first parts, whose mean
/// is taken, one over their number where that is more. Within the limits of the loop. Cells that were not
/// seen keep what they had.
/// @throws InvalidInput if the identities differ, naming what; or the part has other layers than the map, or
/// a
///   layer of it other cells
PartMap learntFromPart(const PartMap& before, const PartIdentity& identity,
                       const std::vector<LaidLayer>& part, PartEnd end, const LoopSettings& settings);

/// The map as comma-separated rows, one a cell, under comments that state program, machine, material, parts
/// and a digest of all of it; it reads back to the same bits, but for layers without cells at the top.
std::string partMapCsv(const PartMap& map);

/// @param source  names the text in errors
/// @throws InvalidInput naming source and line: a comment that is missing, other columns, a number that is
///   none, layers that do not ascend, an amount of -1 or less or of more than 5, a digest that is another's
PartMap readPartMap(std::string_view text, const std::string& source);

/// What differs between a map's part and another: "machine 'a' instead of 'b'"; empty if nothing does. A map
/// that differs must not be used.
std::string differenceOf(const PartIdentity& map, const PartIdentity& other);

}  // namespace lamina
