// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// One executed motion of the nozzle tip and what came out of it on the way.
struct DepositedMotion {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, bed frame]
  Point3 end = Point3::Zero();    ///< nozzle tip [mm, bed frame]
  double volume_mm3 = 0.0;
};

/// Lays executed motions into a height map, one after the other: a simple model, for seeing what a machine
/// did, not for predicting pores.
///
/// A bead is a stadium in cross-section: the nozzle's plane is its ceiling, the highest ground under its
/// centre line its floor, its edges are half discs, and it is as wide as its volume asks for, so that over
/// flat ground the map gains exactly what was extruded. Where neighbours already fill the room, the bead
/// becomes wider instead of higher. Too little material for a stadium gives a disc lying on the ground, lower
/// than the nozzle. What lies deeper than the floor stays open: valleys between the beads of the layer
/// below become pores, and gaps are bridged up to `kBridgedSpan`. The map holds one height per cell, so it
/// does not show these voids and gains their volume too. Sagging, ooze and the pressure in the nozzle are not
/// modelled. Edges are blurred by one cell.
///
/// Motions may be as short as they like; the cost is proportional to the cells the bead covers.
class BeadDeposit {
 public:
  static constexpr double kBridgedSpan = 20.0;  ///< [mm] a bead spans before it sinks to the ground below
  static constexpr double kWidestBead = 20.0;   ///< [mm]

  /// @param ground  known in all its cells, for instance 0 everywhere
  explicit BeadDeposit(HeightMap ground);

  /// A motion without volume lays nothing. What lies beyond the map is not kept.
  /// @throws InvalidInput if the motion is not finite, farther out than 1 km, or the volume negative
  void lay(const DepositedMotion& motion);

  const HeightMap& surface() const { return surface_; }
  /// Largest height of the surface [mm].
  double highest() const { return highest_; }

  /// Material that found no room under the nozzle within three times the bead's width [mm³].
  double excessVolume() const { return excess_mm3_; }

 private:
  struct Cell {
    std::size_t index = HeightGrid::kNoCell;  ///< kNoCell beyond the map
    double distance = 0.0;                    ///< from the centre line [mm]
    double ceiling = 0.0;                     ///< nozzle plane here [mm]
    double underside = 0.0;                   ///< of the bead here [mm]
    double floor = 0.0;                       ///< what lies here already, at least the underside [mm]
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
  double layer_gap_ = 0.0;  ///< from there down to the ground of the last supported bead; 0 before the first
  double unsupported_mm_ = 0.0;  ///< length of the bead since it left its support
  double excess_mm3_ = 0.0;
};

}  // namespace lamina
