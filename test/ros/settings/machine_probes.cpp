// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Machines that are not there, and what they deposit.
#include "nodes/emulated_machine/machine_deposit.hpp"
#include "nodes/emulated_machine/motion_samples.hpp"
#include "nodes/simulated_controller/deposited_material.hpp"
#include "ros/settings/node_probes.hpp"

namespace lamina::test {
namespace {

std::string portsAndFaults(const SettingTexts& set) {
  const auto settings = settingsWith<EmulatedMachineSettings>(set);
  const EmulatedPorts ports = portsOf(settings);
  std::vector<double> numbers{ports.tcp_port ? double(*ports.tcp_port) : -1.0};
  for (const Fault& fault : faultsOf(settings)) numbers.push_back(double(fault.kind));
  return ports.pty_link + " " + numbersText(numbers);
}

/// What lies on a bed, or belt, after a bead of 60 mm; and of the next one, twice as thick.
std::string beadOn(const std::string& machine, const SettingTexts& set) {
  const Eigen::Vector3d down(0, 0, -1);
  const auto deposit = bareBed(buildSpaceByName(machine), down, settingsWith<EmulatedMachineSettings>(set));
  deposit->lay({{100, 100, 0.2}, {100, 160, 0.2}, down, down, 4.0}, {0.0, 1.0});
  deposit->endBead();
  deposit->lay({{100, 100, 0.4}, {100, 160, 0.4}, down, down, 8.0}, {2.0, 3.0});
  const HeightSource surface = deposit->surface();
  return numbersText({deposit->highest(), double(deposit->points().size()), double(surface.grid.columns),
                      double(surface.grid.rows), surface.grid.cell_mm});
}

/// Two beads of 20 mm, one above the other, that a controller's machine lays on the part of its bed that is
/// kept.
std::string laidByController(const SettingTexts& set) {
  DepositedMaterial laid(settingsWith<ControllerSettings>(set));
  double time_s = 0.0;
  for (const double z : {1.5, 3.0}) {
    laid.observe({time_s, {0.0, 0.0, z}, 0.0});
    for (int i = 0; i <= 20; ++i) laid.observe({time_s += 0.1, {1.0 * i, 0.0, z}, 45.0});
    laid.observe({time_s, {20.0, 0.0, z}, 0.0});
    laid.observe({time_s += 1.0, {0.0, 0.0, z + 5.0}, 0.0});
  }
  const HeightGrid& grid = laid.surface().grid();
  return numbersText({double(grid.columns), double(grid.rows), laid.surface().at(grid.cellAt({10.0, 0.0})),
                      laid.surface().at(grid.cellAt({10.0, 1.2}))});
}

}  // namespace

std::vector<SettingProbe> machineProbes() {
  const auto mount = [](const SettingTexts& set) {
    const Point3 place = sensorMount(settingsWith<ControllerSettings>(set));
    return numbersText({place.x(), place.y(), place.z()});
  };
  const auto on_bed = [](const SettingTexts& set) { return beadOn("cartesian_gantry", set); };
  const auto on_belt = [](const SettingTexts& set) { return beadOn("belt_45", set); };
  return {{"where a machine is reached, and what is wrong with it",
           "",
           portsAndFaults,
           {{"pty=/tmp/machine"}, {"tcp_port=2323"}, {"faults=silence=3"}}},
          {"a bead on a bed",
           "deposit.cell_mm=0.5",
           on_bed,
           {{"deposit.model=heights"}, {"deposit.cell_mm=0.2"}}},
          {"a bead on a belt", "deposit.cell_mm=0.5", on_belt, {{"deposit.belt_mm=50"}}},
          {"where a sensor is mounted", "", mount, {{"sensor.mount_mm=0,5,-60"}}},
          {"a bead that a controller lays",
           "deposit.area_mm=-10,-10,40,10",
           laidByController,
           {{"deposit.area_mm=-10,-10,50,10"},
            {"deposit.cell_mm=1"},
            {"deposit.layers=2", "plant.wear=0.5"},
            {"deposit.bead_width_mm=4"}}}};
}

}  // namespace lamina::test
