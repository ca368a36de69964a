// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/part/placement.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/collision/checked_machine.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A toolpath, and where its part stands on the bed.
struct ToolpathOnBed {
  Toolpath toolpath;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
};

/// Reads the toolpath of a file (.csv, whatever its suffix), and places it as `lamina check` does.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram if it is no toolpath, quoting its first line; or as `readCsv`
ToolpathOnBed readToolpathOnBed(const std::string& path, Placement placement, const BuildSpace& space);

/// Checks that joint trajectories can express all that a toolpath asks for.
/// @throws InvalidInput as `requireSupported`, `requireLevels`
void requireDrivable(const Toolpath& toolpath);

/// How a toolpath is checked before it is driven.
struct DriveCheckSettings {
  JointPathSettings joints;
  ClearanceSettings clearance;
};

/// The settings by which a toolpath is checked, "joints.yaw: free" on a line each, in the order of their
/// keys: all of joints.*, and those of clearance.* that decide what collides, unless clearance.need is never.
std::string driveSettingsSheet(const DriveCheckSettings& settings);

/// Refuses settings of a unit that differ from those of its driver: what the unit lets into its queue is to
/// be what the driver runs.
/// @param sheet  that of the driver (`driveSettingsSheet`)
/// @throws InvalidConfig naming each key that differs, with both values; a key that one of them lacks, as one
/// of another release does, differs
void requireSameDriveSettings(const DriveCheckSettings& unit, const std::string& sheet);

/// The joints by which a machine or robot drives a toolpath, once reach, limits and collisions are checked
/// (`checkRun`).
/// @param found  called with the result of the check, also if there are no findings
/// @throws InvalidInput as `requireDrivable`; Unreachable as `requireClear`; Cancelled
KinematicModelRun drivableRun(ToolpathOnBed placed, const CheckedMachine& machine,
                              const DriveCheckSettings& settings,
                              const std::function<void(const MachineCheck&)>& found, Progress& progress);

}  // namespace lamina
