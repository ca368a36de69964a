// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// A motion of the nozzle tip that was executed, and the volume that was extruded on the way.
struct DepositedMotion {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, bed frame]
  Point3 end = Point3::Zero();    ///< nozzle tip [mm, bed frame]
  double volume_mm3 = 0.0;
};

/// Deposits executed motions, one after the other, into a height map. The model is simple: it shows the
/// result of executed motions, and does not predict pores.
///
/// The cross-section of a bead is a stadium. Its top is at the height of the nozzle, its underside at the
/// highest ground below its centre line, its edges are half discs, and its width follows from its volume:
/// over flat ground the map gains exactly what was extruded. Where neighbouring beads fill part of the space,
/// the bead becomes wider instead of higher. Too little material for a stadium gives a disc that lies on the
/// ground, lower than the nozzle. Space below the underside stays open: valleys between the beads of the
/// layer below become pores, and gaps are bridged up to `kBridgedSpan`. As the map has one height per cell,
/// it does not show these voids, and gains their volume too. Sagging, oozing and the pressure in the nozzle
/// are not modelled. Edges are blurred by one cell.
///
/// Motions may be of any length; the cost is proportional to the number of cells that the bead covers.
class BeadDeposit {
 public:
  /// Length that a bead bridges before it sinks to the ground below [mm].
  static constexpr double kBridgedSpan = 20.0;
  static constexpr double kWidestBead = 20.0;  ///< greatest width of a bead [mm]

  /// @param ground  initial heights, known in all cells, for instance 0 everywhere
  explicit BeadDeposit(HeightMap ground);

  /// Deposits a motion. A motion without volume deposits nothing. Material beyond the map is lost.
  /// @throws InvalidInput if the motion is not finite or farther out than 1 km, or the volume is negative or
  ///   not finite
  void lay(const DepositedMotion& motion);

  const HeightMap& surface() const { return surface_; }
  /// Greatest height of the surface [mm].
  double highest() const { return highest_; }

  /// Volume for which there was no space below the nozzle within three times the bead's width [mm³].
  double excessVolume() const { return excess_mm3_; }

 private:
  struct Cell {
    std::size_t index = HeightGrid::kNoCell;  ///< kNoCell beyond the map
    double distance = 0.0;                    ///< distance from the centre line [mm]
    double ceiling = 0.0;                     ///< height of the nozzle here [mm]
    double underside = 0.0;                   ///< height of the bead's underside here [mm]
    double floor = 0.0;  ///< height of the material already here, at least the underside [mm]
  };

  void layPiece(const DepositedMotion& piece);
  double gapUnder(const DepositedMotion& piece, double disc_diameter);
  double gapToSupport(const std::vector<Cell>& line, double ceiling) const;
  std::vector<Cell> cellsAround(const DepositedMotion& piece, double reach) const;
  double room(double width, double height) const;
  double widthFor(double volume, double widest, double height) const;
  void fill(double width, double height);

  HeightMap surface_;
  double highest_;
  std::vector<float> deposited_at_;  ///< nozzle height at which each cell was last deposited [mm]
  std::vector<Cell> cells_;          ///< around the piece being deposited
  double layer_z_ = 0.0;             ///< nozzle height of the last piece [mm]
  /// Height from `layer_z_` down to the ground of the last supported bead; 0 before the first.
  double layer_gap_ = 0.0;
  double unsupported_mm_ = 0.0;  ///< length of the bead since it left its support
  double excess_mm3_ = 0.0;
};

}  // namespace lamina
