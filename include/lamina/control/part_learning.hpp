// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// The program, machine and material for which a learnt map is valid.
struct PartIdentity {
  std::string program;  ///< hash of it
  std::string machine;
  std::string material;
};

/// Relative amounts learnt from previous parts, with which the same part is to be deposited again.
struct PartMap {
  PartIdentity identity;
  std::size_t parts = 0;                    ///< number learnt from
  std::vector<std::vector<double>> amount;  ///< by layer and cell
};

/// A layer of a part as deposited and measured. Vectors have one value per cell.
struct DepositedLayer {
  LayerCells cells;
  std::vector<double> amount;  ///< relative, as deposited
  /// Planned less actual growth of this layer alone [mm]; not finite where it was not seen.
  std::vector<double> growth_error_mm;
};

/// How a part ended. Nothing is learnt from an aborted one.
enum class PartEnd { Complete, Aborted };

/// The map for the next part by iterative learning [Bristow2006]: Q (u + K F (1 / g - 1 - u)).
///
/// u is the map before, 0 for the first part. g is the gain measured at each cell: actual over commanded
/// growth of the layer alone, so that amounts deposited to mend layers below are not learnt. F is the
/// low-pass of the loop along the path and across beads. Q is the mean of a layer and its two neighbours,
/// where their numbers of cells are equal. K is `part_learning`, or 1 over the number of parts if that is
/// greater, which makes the map the mean of the first parts. Cells that were not seen keep their values. The
/// result is within the limits of the loop.
/// @throws InvalidInput if the identities differ, naming in what, or if the part has another number of layers
///   than the map, or one of its layers another number of cells
PartMap learntFromPart(const PartMap& before, const PartIdentity& identity,
                       const std::vector<DepositedLayer>& part, PartEnd end, const LoopSettings& settings);

/// The map as CSV, a row per cell under comments that state program, machine, material, parts and a digest of
/// all of it. It reads back to the same bits, except that layers without cells at the top are left out.
std::string partMapCsv(const PartMap& map);

/// Reads a map from such a text.
/// @param source  names the text in errors
/// @throws InvalidInput naming source and line: a comment that is missing, other columns, a number that is
///   none, layers that do not ascend, an amount of -1 or less or of more than 5, a digest that is another's
PartMap readPartMap(std::string_view text, const std::string& source);

/// The first difference of a map's identity from another, as "machine 'a' instead of 'b'"; empty if there is
/// none. A map that differs must not be used.
std::string differenceOf(const PartIdentity& map, const PartIdentity& other);

}  // namespace lamina
