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

/// A motion of the nozzle tip, and what is extruded on the way. A motion without length is a drop or a blob:
/// all of it is extruded at one position.
struct ToolAxisMotion {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, frame of the voxels]
  Point3 end = Point3::Zero();
  /// Direction of the tool axis (z of the nozzle) at start and end, of unit length.
  Eigen::Vector3d start_tool_axis{0, 0, -1};
  Eigen::Vector3d end_tool_axis{0, 0, -1};
  double volume_mm3 = 0.0;
  /// Radius of the round strand that is extruded. 0 if not known: it then follows from volume and length, for
  /// which the motion must not be shorter than a few hundredths of a millimetre.
  double radius_mm = 0.0;
};

/// Outcome of the extruded material, in volumes of voxels [mm³]. The extruded volume is the sum of deposited,
/// held, excess and outside.
struct DepositTotals {
  double path_mm = 0.0;  ///< length of motions that deposited something
  double extruded_mm3 = 0.0;
  double deposited_mm3 = 0.0;
  double excess_mm3 = 0.0;   ///< volume without room within reach
  double outside_mm3 = 0.0;  ///< extruded outside the frame
  double held_mm3 = 0.0;     ///< less than a voxel, kept for the next portion
};

/// Whether the height of the top is stored for each column of voxels: 4 bytes a column.
enum class TopHeights { None, Kept };

/// Deposits motions of a nozzle into voxels, one after the other; the deposited volume is the extruded volume
/// (the deposition of VOLCO [Gleadall2018]). The nozzle halts every 0.51 radii of the strand
/// (`deposition.step`). At each halt the portion extruded since the last one fills the open voxels nearest to
/// a centre, which lies one radius along the tool axis from the tip. Voxels are not filled if they lie behind
/// the plane through the tip perpendicular to the tool axis (on the side of the nozzle), lie below the bed,
/// or are solid already. As a result strands are round in the air and flat under the nozzle and on the bed,
/// and material spreads where strands cross.
///
/// The remainder of a portion below a whole voxel is kept for the next portion: the deposited volume differs
/// from the extruded volume by less than a voxel. Material for which there is no room within
/// `deposition.reach_mm` counts as excess and is not deposited later. Nothing is deposited outside the frame;
/// material of strands outside the frame, seen along z, counts as outside. Among voxels at the same distance,
/// the sides of the strand are preferred by turns from portion to portion: the result depends on the motions
/// and their order alone.
///
/// The cost is proportional to the number of voxels deposited; where material has to go far, the search
/// around the full region adds to it. The memory is that of the grid (`VoxelGrid`: bricks where something is
/// deposited), and 4 bytes a column if tops are kept.
class VoxelDeposit {
 public:
  static constexpr double kThickestStrand = 20.0;  ///< greatest radius of a strand [mm]

  /// An empty deposit. Of the settings, step, reach and bed are used.
  /// @throws InvalidInput if the reach is above 2^17 voxels
  VoxelDeposit(const VoxelFrame& frame, const DepositionSettings& settings,
               TopHeights tops = TopHeights::None);
  ~VoxelDeposit();
  VoxelDeposit(VoxelDeposit&&) noexcept;
  VoxelDeposit& operator=(VoxelDeposit&&) noexcept;

  /// Deposits a motion. A motion without volume deposits nothing.
  /// @throws InvalidInput if the motion is not finite or farther out than 1 km; if the volume or radius is
  ///   negative; if the strand is thicker than `kThickestStrand`; if a tool axis is not of unit length
  void lay(const ToolAxisMotion& motion);

  const VoxelGrid& grid() const;
  DepositTotals totals() const;
  /// Height of the top of the deposit [mm]: the height of the nozzle where it flattened the uppermost voxels,
  /// otherwise their upper face; the bed if nothing is deposited.
  double highest() const;
  /// Height of the top in the column of (x, y) [mm]: the height of the nozzle if it is within half a voxel of
  /// the upper face of the uppermost solid voxel, otherwise that face. The bed where nothing is deposited and
  /// outside the frame; the bed everywhere if tops are not kept.
  double surfaceHeight(double x, double y) const;

  /// Moves the voxels out; the deposit must not be used afterwards.
  VoxelGrid takeGrid();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
