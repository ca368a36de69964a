// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lamina/deposition/deposition_settings.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// One motion of the nozzle tip and what comes out of it on the way. A motion without length is a drop, or a
/// blob: all of it comes out at one place.
struct ToolAxisMotion {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, frame of the voxels]
  Point3 end = Point3::Zero();
  Eigen::Vector3d start_tool_axis{0, 0,
                                  -1};  ///< direction of the tool axis (z of the nozzle), of unit length
  Eigen::Vector3d end_tool_axis{0, 0, -1};
  double volume_mm3 = 0.0;
  /// Radius of the round strand that comes out. 0 if not known: it follows from volume and length, which
  /// needs a motion that is no shorter than a few hundredths of a millimetre.
  double radius_mm = 0.0;
};

/// Where the material of a deposit went, in voxels' volumes [mm³]. Deposited, held back, excess and outside
/// make up what was extruded.
struct DepositTotals {
  double path_mm = 0.0;  ///< length of motions that deposited something
  double extruded_mm3 = 0.0;
  double deposited_mm3 = 0.0;
  double excess_mm3 = 0.0;   ///< found no room within reach
  double outside_mm3 = 0.0;  ///< came out beyond the frame
  double held_mm3 = 0.0;     ///< less than a voxel, waits for the next portion
};

/// Whether the height of the top is kept for each column of voxels: 4 bytes a column.
enum class TopHeights { None, Kept };

/// Lays motions of a nozzle into voxels, one after the other, so that what is deposited is what was extruded
/// (the deposition of VOLCO [Gleadall2018]). The nozzle halts every 0.51 radii of the strand
/// (`deposition.step`); at each halt the portion extruded since the last one goes into the open voxels
/// nearest to a point one radius along the tool axis from the tip. Nothing goes before the plane through the
/// tip square to the tool axis, below the bed, or into a voxel that is solid already. So strands are round in
/// the air, flat under the nozzle and on the bed, and material spreads where strands cross.
///
/// What is left of a portion after whole voxels is held for the next one: model and extruded volume differ by
/// less than a voxel. Material that finds no room within `deposition.reach_mm` is not deposited later: it
/// counts as excess. Nothing is deposited beyond the frame; material whose strand lies beyond the frame
/// counts as outside. Voxels at the same distance take turns from portion to portion, by sides of the strand;
/// so the result depends on the motions and their order alone.
///
/// Cost is proportional to the voxels deposited. Where material has to go far, the shell around the full
/// place adds to it. Memory is that of the grid (`VoxelGrid`: bricks where something lies), 4 bytes a column
/// if tops are kept.
class VoxelDeposit {
 public:
  static constexpr double kThickestStrand = 20.0;  ///< radius of a strand [mm]

  /// All open. Of the settings, step, reach and bed are used.
  /// @throws InvalidInput if the reach is above 2^17 voxels
  VoxelDeposit(const VoxelFrame& frame, const DepositionSettings& settings,
               TopHeights tops = TopHeights::None);
  ~VoxelDeposit();
  VoxelDeposit(VoxelDeposit&&) noexcept;
  VoxelDeposit& operator=(VoxelDeposit&&) noexcept;

  /// A motion without volume lays nothing.
  /// @throws InvalidInput if the motion is not finite or farther out than 1 km, the volume or radius negative
  ///   or the strand thicker than `kThickestStrand`, or a tool axis is not of unit length
  void lay(const ToolAxisMotion& motion);

  const VoxelGrid& grid() const;
  DepositTotals totals() const;
  /// Top of what is deposited [mm]: the nozzle's plane where it ironed the uppermost voxels, else their upper
  /// face. The bed if nothing is deposited.
  double highest() const;
  /// Height of the top in the column of (x, y), seen from above [mm]: the nozzle's plane where that is
  /// within half a voxel of the upper face of the uppermost solid voxel, else that face; the bed where
  /// nothing is deposited or beyond the frame. The bed everywhere if tops are not kept.
  double surfaceHeight(double x, double y) const;

  /// Moves the voxels out; the deposit must not be used afterwards.
  VoxelGrid takeGrid();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
