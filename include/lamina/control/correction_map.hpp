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

/// What is changed at a place of a path.
struct PlaceCorrection {
  double amount = 0.0;  ///< relative, of what is laid per length
  double speed = 0.0;   ///< relative, of the travel speed
  double dz_mm = 0.0;   ///< of the nozzle: along the layer's normal in G-code, back along a robot's tool axis

  bool isNone() const { return amount == 0.0 && speed == 0.0 && dz_mm == 0.0; }
};

/// The corrections of one path, at the middles of equal pieces: station i lies at (i + 1/2) times the
/// distance. Between stations they are linear, before the first and after the last one they stay.
struct PathCorrection {
  std::size_t path = 0;     ///< of the layer, travels counted too
  double spacing_mm = 0.0;  ///< from station to station
  std::vector<PlaceCorrection> stations;
};

/// How a layer is laid otherwise than its toolpath says. Paths that it does not name are laid as planned.
struct CorrectionMap {
  std::string toolpath_id;
  std::size_t layer = 0;
  std::uint64_t sequence = 0;         ///< of maps of this layer; the later one holds
  std::vector<PathCorrection> paths;  ///< ascending
};

/// The correction at a length along the path; none if the path has no stations.
PlaceCorrection correctionAt(const PathCorrection& path, double along_mm);

/// A map of what each cell of a layer is to have; vectors of no values are none.
struct CellCorrections {
  std::vector<double> amount;
  std::vector<double> speed;
  std::vector<double> dz_mm;
};
CorrectionMap correctionMap(const LayerCells& cells, const CellCorrections& corrections,
                            const std::string& toolpath_id, std::uint64_t sequence);

/// 16 hexadecimal digits that depend on every value of the map and nothing else (FNV-1a).
std::string digestOf(const CorrectionMap& map);

/// @throws InvalidInput naming path and station: what is not finite, an amount or speed of -1 or less or of
///   more than 5, a shift of more than 100 mm, a distance that is not positive, paths that do not ascend, a
///   path without stations
void validate(const CorrectionMap& map);

/// The map as comma-separated rows under comments that state toolpath, layer, sequence and digest; it reads
/// back to the same bits.
std::string correctionMapCsv(const CorrectionMap& map);

/// @param source  names the text in errors
/// @throws InvalidInput naming source and line: what `validate` refuses, a comment that is missing, a number
///   that is none, a digest that is not that of the map
CorrectionMap readCorrectionMap(std::string_view text, const std::string& source);

}  // namespace lamina
