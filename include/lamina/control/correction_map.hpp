// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// The correction at a point of a path.
struct PointCorrection {
  double amount = 0.0;  ///< relative change of the volume deposited per length
  double speed = 0.0;   ///< relative change of the travel speed
  /// Shift of the nozzle: in G-code along the normal of the layers, for a robot against the tool axis.
  double dz_mm = 0.0;

  bool isNone() const { return amount == 0.0 && speed == 0.0 && dz_mm == 0.0; }
};

/// The corrections of one path, at stations in the middles of equal pieces of it: station i lies (i + 1/2)
/// times the spacing from the start of the path. Corrections are linear between stations, and constant before
/// the first and after the last one.
struct PathCorrection {
  std::size_t path = 0;     ///< number in the layer, travels included
  double spacing_mm = 0.0;  ///< distance from station to station
  std::vector<PointCorrection> stations;
};

/// The amounts with which the layer above is expected to begin, at equal times from its start: what a program
/// commands for it in the last dead time of a feeder, while the layer below it ends. Amount i is that at
/// (i + 1/2) times the interval, at planned speeds.
struct ExpectedBeginning {
  double interval_s = 0.0;
  std::vector<double> amount;  ///< relative change of the volume deposited per length; may be empty
};

/// The corrections of one layer of a toolpath. Paths without an entry are deposited as planned.
struct CorrectionMap {
  std::string toolpath_id;
  std::size_t layer = 0;
  /// Number among the maps of this layer; the map with the greatest number is valid. 0 is the coasting map:
  /// it is issued with the map of the layer below, in case the layer's own map does not come in time.
  std::uint64_t sequence = 0;
  std::vector<PathCorrection> paths;  ///< ascending by `path`
  ExpectedBeginning ahead = {};       ///< of the layer above; empty where no feeder needs it
};

/// Whether a map of a loop is the coasting map of its layer.
inline bool isCoasting(const CorrectionMap& map) { return map.sequence == 0; }

/// Whether a path with these corrections is deposited as planned.
bool isNone(const PathCorrection& correction);

/// The correction at a distance from the start of the path [mm]; none if the path has no stations.
PointCorrection correctionAt(const PathCorrection& path, double along_mm);

/// The corrections of the cells of a layer, one value per cell, as in `PointCorrection`. An empty vector
/// means that there is no correction of its kind.
struct CellCorrections {
  std::vector<double> amount;
  std::vector<double> speed;
  std::vector<double> dz_mm;
};
/// The map of a layer with a station at each cell.
CorrectionMap correctionMap(const LayerCells& cells, const CellCorrections& corrections,
                            const std::string& toolpath_id, std::uint64_t sequence);

/// A hash of all values of the map, 64 bits as 16 hexadecimal digits: FNV-1a over words of 64 bits, with a
/// further mixing step for each.
std::string digestOf(const CorrectionMap& map);

/// @throws InvalidInput naming path and station: if a value is not finite, an amount or speed is -1 or less
///   or above 5, a shift is above 100 mm, a spacing is not positive or, of several stations, below 0.001 mm,
///   paths do not ascend, a path has no stations, or the expected beginning is none
void validate(const CorrectionMap& map);

/// The map as CSV, a row per station under comments that state toolpath, layer, sequence and digest, and the
/// expected beginning of the layer above if there is one; it reads back to the same bits.
std::string correctionMapCsv(const CorrectionMap& map);

/// Reads a map from text that `correctionMapCsv` wrote.
/// @param source  names the text in errors
/// @throws InvalidInput naming source and line: if `validate` refuses the map, a comment is missing, a number
///   cannot be read, or the digest is not that of the map
CorrectionMap readCorrectionMap(std::string_view text, const std::string& source);

}  // namespace lamina
