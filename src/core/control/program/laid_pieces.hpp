// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "control/program/deposit_cursor.hpp"
#include "lamina/control/correction_map.hpp"

namespace lamina {

/// A piece of a motion that is laid with one amount.
struct LaidPiece {
  double share = 1.0;  ///< of the motion's length
  PlaceCorrection mean;
  double end_dz_mm = 0.0;
};

/// The maps of a toolpath by layer and path.
class CorrectionsByPath {
 public:
  /// @throws InvalidInput as `validate`; if there is a map of the layer already
  void add(const CorrectionMap& map);
  /// In place of the map of the layer, if there is one.
  /// @throws InvalidInput as `validate`
  void replace(const CorrectionMap& map);

  /// None if nothing is known of the path.
  const PathCorrection* find(std::size_t layer, std::size_t path) const;

 private:
  std::map<std::size_t, CorrectionMap> maps_;  ///< by layer
};

/// Pieces of a stretch of a path, in each of which the amount changes by that much at most. Their means are
/// exact for corrections that are linear between stations.
std::vector<LaidPiece> laidPieces(const PathCorrection& correction, const LaidStretch& stretch,
                                  double split_change);

}  // namespace lamina
