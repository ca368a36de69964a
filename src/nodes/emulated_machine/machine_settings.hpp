// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/deposition/grown_deposit.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"

namespace lamina {

/// Representation of the deposit.
enum class DepositModel {
  Auto,     ///< voxels, on belts heights
  Voxels,   ///< `VoxelDeposit`
  Heights,  ///< `BeadDeposit`
};

struct EmulatedMachineSettings {
  std::string pty;     ///< link to the pseudo-terminal; empty for none
  int tcp_port = -1;   ///< on the loopback interface; 0 for any free one, -1 for none
  std::string faults;  ///< "kind=rate kind=line,line", as in `lamina emulate --fault`
  MachineSettings machine;
  double filament_diameter_mm = 1.75;
  double position_spacing_mm = 1.0;  ///< of the positions published along a motion
  double profile_spacing_mm = 0.1;   ///< of profiles, and of the positions they are taken at
  DepositModel deposit_model = DepositModel::Auto;
  double deposit_cell_mm = 0.1;           ///< side of a voxel, or of a cell of the height map
  double deposit_belt_mm = 200.0;         ///< length of a belt that the map shows
  double deposited_period_s = 0.5;        ///< between publications of the deposited material
  bool profile_while_depositing = false;  ///< whether the sensor also measures during motions that deposit
  PlantSettings plant;  ///< deviations of the process; with any, deposits are a `GrownDeposit`
  GrownDepositSettings grown;
  EmulatedSettings emulator;
  ProfileSensorSettings sensor;
};

/// Adds the keys pty, tcp_port, faults, machine.*, filament_diameter_mm, position_spacing_mm,
/// profile_spacing_mm, deposit.*, profile_while_depositing, plant.*, emulator.*, motion.* and sensor.*.
void describe(SettingsSchema& schema, EmulatedMachineSettings& settings);

/// @throws InvalidConfig if a text is no fault
std::vector<Fault> faultsOf(const EmulatedMachineSettings& settings);
EmulatedPorts portsOf(const EmulatedMachineSettings& settings);

}  // namespace lamina
