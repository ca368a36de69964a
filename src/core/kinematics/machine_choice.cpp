// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/machine_choice.hpp"

#include "lamina/kinematics/description_files/cell_description.hpp"

namespace lamina {

void describe(SettingsSchema& schema, MachineSettings& settings, const std::string& meaning) {
  schema.choice("machine.name", settings.name, kinematicModelNames(), meaning);
  schema.text("machine.urdf", settings.urdf, "File that describes the machine; empty takes the named one.");
}

CartesianMachine machineOf(const MachineSettings& settings) {
  return settings.urdf.empty() ? machineByName(settings.name)
                               : machineFromUrdf(readMachineDescription(settings.urdf));
}

BuildSpace buildSpaceOf(const MachineSettings& settings) {
  return settings.urdf.empty() ? buildSpaceByName(settings.name)
                               : buildSpaceFromUrdf(readMachineDescription(settings.urdf));
}

std::unique_ptr<KinematicModel> kinematicModelOf(const MachineSettings& settings) {
  return settings.urdf.empty() ? kinematicModelByName(settings.name)
                               : kinematicModelFromUrdf(readMachineDescription(settings.urdf));
}

}  // namespace lamina
