// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/deposition/voxel_deposit.hpp"
#include "lamina/geometry/voxel/height_source.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "machine_settings.hpp"

namespace lamina {

/// Machine times of a motion [s].
struct MachineTimes {
  double start_s = 0.0;
  double end_s = 0.0;
};

/// What an emulated machine has deposited, in frame `bed`.
class MachineDeposit {
 public:
  MachineDeposit() = default;
  MachineDeposit(const MachineDeposit&) = delete;
  MachineDeposit& operator=(const MachineDeposit&) = delete;
  virtual ~MachineDeposit() = default;

  virtual void lay(const ToolAxisMotion& motion, const MachineTimes& times) = 0;
  /// States that the next material does not continue the last bead.
  virtual void endBead() {}
  /// The surface as a sensor above sees it; valid during the object's lifetime.
  virtual HeightSource surface() const = 0;
  /// The frame in which the surface has heights: that of the bed, unless beads grow in another direction than
  /// upwards.
  virtual Eigen::Isometry3d bedFromSurface() const { return Eigen::Isometry3d::Identity(); }
  /// Largest height of the surface [mm].
  virtual double highest() const = 0;
  /// Points of the surface where material lies [mm, bed].
  virtual std::vector<Point3> points() const = 0;
};

/// An empty deposit over the bed area that the settings show. Beads of a disturbed process grow against the
/// tool axis.
/// @param tool_axis  tool axis of the machine, of unit length [bed]
/// @throws InvalidInput if the area has more cells than a map can have
/// @throws InvalidConfig if pieces are to break off on a machine whose tool axis leans, which would have to
///   fall
std::unique_ptr<MachineDeposit> bareBed(BuildSpace space, const Eigen::Vector3d& tool_axis,
                                        const EmulatedMachineSettings& settings);

}  // namespace lamina
