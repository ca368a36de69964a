// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Choice of a machine or robot.
struct MachineSettings {
  std::string name = "cartesian_gantry";  ///< one of `kinematicModelNames`
  std::string urdf;  ///< path of a description that replaces the named machine; empty for none
};

/// Adds the keys machine.name and machine.urdf.
/// @param meaning  description of machine.name: "Machine that prints the part."
void describe(SettingsSchema& schema, MachineSettings& settings, const std::string& meaning);

/// The chosen machine, with its linear axes only.
/// @throws FileError, InvalidConfig as `machineFromUrdf`, `machineByName`
CartesianMachine machineOf(const MachineSettings& settings);

/// The build space of the chosen machine or robot.
/// @throws FileError, InvalidConfig as `buildSpaceFromUrdf`, `buildSpaceByName`
BuildSpace buildSpaceOf(const MachineSettings& settings);

/// The chosen machine or robot with all its joints.
/// @throws FileError, InvalidConfig as `kinematicModelFromUrdf`, `kinematicModelByName`
std::unique_ptr<KinematicModel> kinematicModelOf(const MachineSettings& settings);

}  // namespace lamina
