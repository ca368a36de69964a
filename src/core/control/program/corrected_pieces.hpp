// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "control/program/deposit_cursor.hpp"
#include "lamina/control/correction_map.hpp"

namespace lamina {

/// A piece of a motion that is deposited with one correction.
struct CorrectedPiece {
  double share = 1.0;  ///< share of the motion's length
  PointCorrection mean;
  double end_dz_mm = 0.0;
};

/// The corrections of a toolpath by layer and path.
class CorrectionsByPath {
 public:
  /// Adds the map of a layer.
  /// @throws InvalidInput as `validate`; if there is a map of the layer already
  void add(const CorrectionMap& map);
  /// Replaces the map of a layer, or adds it.
  /// @throws InvalidInput as `validate`
  void replace(const CorrectionMap& map);

  /// The corrections of a path; null if there are none.
  const PathCorrection* find(std::size_t layer, std::size_t path) const;

 private:
  std::map<std::size_t, CorrectionMap> maps_;  ///< by layer
};

/// Divides a stretch of a path into pieces within which the amount changes by at most `split_change`. The
/// mean of each piece is exact for corrections that are linear between stations.
std::vector<CorrectedPiece> correctedPieces(const PathCorrection& correction, const DepositedStretch& stretch,
                                            double split_change);

}  // namespace lamina
