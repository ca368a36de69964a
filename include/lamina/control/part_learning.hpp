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
  std::string program;  ///< hash of the program
  std::string machine;
  std::string material;
};

/// Relative amounts learnt from previous parts, with which the same part is to be deposited again.
struct PartMap {
  PartIdentity identity;
  std::size_t parts = 0;                    ///< number of parts from which it was learnt
  std::vector<std::vector<double>> amount;  ///< by layer and cell
};

/// A layer of a part as deposited and measured. Vectors have one value per cell.
struct DepositedLayer {
  LayerCells cells;
  std::vector<double> amount;  ///< relative change with which the layer was deposited
  /// Planned less actual growth of this layer alone [mm]; not finite for cells that were not seen.
  std::vector<double> growth_error_mm;
};

/// How a part ended. Nothing is learnt from an aborted part.
enum class PartEnd { Complete, Aborted };

/// The map for the next part by iterative learning [Bristow2006]: Q (u + K F (1 / g - 1 - u)).
///
/// u is the previous map, 0 for the first part. g is the gain measured at each cell: actual over commanded
/// growth of this layer alone, so that amounts that only compensated for errors of the layers below are not
/// learnt. F is the low-pass of the loop along the path and across beads. Q averages a layer with the layers
/// above and below, by weights of 1/2 and 1/4 each, where these have equal numbers of cells. K is the greater
/// of `part_learning` and 1 over the number of parts, this one included; thus the map is at first a mean over
/// the parts. Cells that were not seen change only by the smoothing of F and Q. The result is within the
/// limits of the loop. If the part was aborted, the result is `before`.
/// @throws InvalidInput naming the difference, if the identities differ; if the part has another number of
///   layers than the map, or one of its layers another number of cells; if a layer does not have one value
///   per cell
PartMap learntFromPart(const PartMap& before, const PartIdentity& identity,
                       const std::vector<DepositedLayer>& part, PartEnd end, const LoopSettings& settings);

/// The map as CSV, a row per cell after comments that state program, machine, material, number of parts and a
/// digest of all of it. Reading it back gives the same bits, without empty layers at the top of the part.
std::string partMapCsv(const PartMap& map);

/// Reads a map from text that `partMapCsv` wrote.
/// @param source  names the text in errors
/// @throws InvalidInput naming source and line: if a comment is missing, the columns are others, a number
///   cannot be read, layers do not ascend, an amount is -1 or less or above 5, or the digest is not that of
///   the map
PartMap readPartMap(std::string_view text, const std::string& source);

/// The first difference between the identity of a map and another one, as "machine 'a' instead of 'b'", where
/// 'b' is that of the map; empty if there is none. A map must not be used where the identity differs.
std::string differenceOf(const PartIdentity& map, const PartIdentity& other);

}  // namespace lamina
