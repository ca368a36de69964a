// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine_settings.hpp"

#include <sstream>

namespace lamina {

void describe(SettingsSchema& schema, EmulatedMachineSettings& settings) {
  schema.text("pty", settings.pty, "Stable path to make as a link to the pseudo-terminal; empty for none.");
  schema.integer("tcp_port", settings.tcp_port, {-1, 65535},
                 "TCP port on the loopback interface; 0 for any free one, -1 for none.");
  schema.text("faults", settings.faults, "Faults: kind=rate or kind=line,line, separated by spaces.");
  describe(schema, settings.machine, "Machine that is emulated.");
  schema.number("filament_diameter_mm", settings.filament_diameter_mm, Bounds::above(0.0, 20.0),
                "Diameter of the filament.");
  schema.number("position_spacing_mm", settings.position_spacing_mm, Bounds::above(0.0, 1000.0),
                "Distance between positions along a motion; its end is always one.");
  schema.number("profile_spacing_mm", settings.profile_spacing_mm, Bounds::above(0.0, 1000.0),
                "Distance between profiles, and positions, along a motion that is measured.");
  schema.choice<DepositModel>(
      "deposit.model", settings.deposit_model,
      {{"auto", DepositModel::Auto}, {"voxels", DepositModel::Voxels}, {"heights", DepositModel::Heights}},
      "Deposited material in voxels, or as a map of heights, as on belts if auto.");
  schema.number("deposit.cell_mm", settings.deposit_cell_mm, {0.02, 10.0},
                "Voxel of the deposited material, half a layer at most; or cell of the map.");
  schema.number("deposit.belt_mm", settings.deposit_belt_mm, Bounds::above(0.0, 1e5),
                "How much of a belt is shown, from its start.");
  schema.number("deposit.period_s", settings.deposited_period_s, Bounds::above(0.0, 3600.0),
                "Time between publications of the deposited material.");
  schema.flag("profile_while_depositing", settings.profile_while_depositing,
              "Whether the sensor also measures during motions that deposit.");
  describe(schema, settings.grown);
  describe(schema, settings.plant);
  describe(schema, settings.emulator);
  describe(schema, settings.sensor);
}

std::vector<Fault> faultsOf(const EmulatedMachineSettings& settings) {
  std::vector<Fault> faults;
  std::istringstream words(settings.faults);
  for (std::string word; words >> word;) faults.push_back(faultFromText(word));
  return faults;
}

EmulatedPorts portsOf(const EmulatedMachineSettings& settings) {
  EmulatedPorts ports;
  ports.pty_link = settings.pty;
  if (settings.tcp_port >= 0) ports.tcp_port = static_cast<std::uint16_t>(settings.tcp_port);
  return ports;
}

}  // namespace lamina
