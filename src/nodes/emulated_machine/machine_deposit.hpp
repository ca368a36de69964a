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
  /// What comes next does not go on from what was deposited last.
  virtual void endBead() {}
  /// What a sensor above sees; valid while this lives.
  virtual HeightSource surface() const = 0;
  /// The frame in which the surface has heights: that of the bed, unless beads grow another way than upwards.
  virtual Eigen::Isometry3d bedFromSurface() const { return Eigen::Isometry3d::Identity(); }
  /// Largest height of the surface [mm].
  virtual double highest() const = 0;
  /// Points of the surface where something lies [mm, bed].
  virtual std::vector<Point3> points() const = 0;
};

/// Nothing yet, over the bed that the settings say is shown.
/// @param tool_axis  of the machine, of unit length [bed]
/// @throws InvalidInput if that has more cells than a map can have
/// Beads of a disturbed process grow against the tool axis.
/// @throws InvalidConfig if pieces are to break off on a machine whose tool axis leans, which would have to
///   fall
std::unique_ptr<MachineDeposit> bareBed(BuildSpace space, const Eigen::Vector3d& tool_axis,
                                        const EmulatedMachineSettings& settings);

}  // namespace lamina
