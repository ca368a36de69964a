// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The shipped config/<node>.yaml state every parameter of the node with the default that the code has.
#include <gtest/gtest.h>

#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/startup/startup_sequence.hpp"
#include "nodes/cell_controller/cell_settings.hpp"
#include "nodes/deposition_simulator/simulator_settings.hpp"
#include "nodes/emulated_coupler/coupler_settings.hpp"
#include "nodes/emulated_machine/machine_settings.hpp"
#include "nodes/gcode_incliner/incliner_settings.hpp"
#include "nodes/gcode_streamer/streamer_settings.hpp"
#include "nodes/height_controller/height_controller_settings.hpp"
#include "nodes/host_watch/watch_settings.hpp"
#include "nodes/layer_height_monitor/monitor_settings.hpp"
#include "nodes/operator_page/page_settings.hpp"
#include "nodes/optimiser/optimiser_settings.hpp"
#include "nodes/plc_link/link_settings.hpp"
#include "nodes/process_io/process_io_settings.hpp"
#include "nodes/servo_bridge/bridge_settings.hpp"
#include "nodes/simulated_controller/controller_settings.hpp"
#include "nodes/trajectory_driver/driver_settings.hpp"
#include "nodes/trajectory_publisher/publisher_settings.hpp"

namespace {

std::map<std::string, std::string> valuesOf(const lamina::SettingsSchema& schema) {
  std::map<std::string, std::string> values;
  for (const lamina::Setting& setting : schema.settings()) values[setting.key] = setting.get();
  return values;
}

/// Expects config/<node>.yaml to hold these keys and values.
void expectValues(const std::string& node, const std::map<std::string, std::string>& values) {
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/config/" + node + ".yaml";
  std::map<std::string, std::string> shipped;
  for (const auto& setting : lamina::settingsFromYaml(lamina::readFile(path), path))
    shipped[setting.key] = setting.text;
  EXPECT_EQ(shipped, values);
}

/// The schema's keys and the values it has now.
void expectDefaults(const std::string& node, const lamina::SettingsSchema& schema) {
  expectValues(node, valuesOf(schema));
}

TEST(NodeConfig, OfCellControllerIsCompleteAndHasTheDefaults) {
  lamina::CellControllerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("cell_controller", schema);
}

TEST(NodeConfig, OfPlcLinkIsCompleteAndHasTheDefaults) {
  lamina::LinkSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("plc_link", schema);
}

TEST(NodeConfig, OfDepositionSimulatorIsCompleteAndHasTheDefaults) {
  lamina::DepositionSimulatorSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("deposition_simulator", schema);
}

TEST(NodeConfig, OfEmulatedCouplerIsCompleteAndHasTheDefaults) {
  lamina::EmulatedCouplerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("emulated_coupler", schema);
}

TEST(NodeConfig, OfEmulatedMachineIsCompleteAndHasTheDefaults) {
  lamina::EmulatedMachineSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("emulated_machine", schema);
}

TEST(NodeConfig, OfGcodeInclinerIsCompleteAndHasTheDefaults) {
  lamina::GcodeInclinerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("gcode_incliner", schema);
}

TEST(NodeConfig, OfGcodeStreamerIsCompleteAndHasTheDefaults) {
  lamina::GcodeStreamerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("gcode_streamer", schema);
}

TEST(NodeConfig, OfOperatorPageIsCompleteAndHasTheDefaults) {
  lamina::OperatorPageSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("operator_page", schema);
}

/// Sets everything that a shipped file states.
void load(const std::string& file, lamina::SettingsSchema& schema) {
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/config/" + file;
  for (const auto& setting : lamina::settingsFromYaml(lamina::readFile(path), path))
    schema.set(setting.key, setting.text);
}

TEST(NodeConfig, OfTrajectoryDriverIsCompleteAndHasTheDefaults) {
  lamina::DriverSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("trajectory_driver", schema);
}

// Maps without rows are no keys.
TEST(NodeConfig, OfProcessIoIsCompleteAndHasTheDefaults) {
  lamina::ProcessIoSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  std::map<std::string, std::string> values = valuesOf(schema);
  for (const char* const table : {"devices", "channels", "inputs"}) values.erase(table);
  expectValues("process_io", values);
}

TEST(NodeConfig, OfServoBridgeIsCompleteAndHasTheDefaults) {
  lamina::ServoBridgeSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("servo_bridge", schema);
}

TEST(NodeConfig, OfSimulatedControllerIsCompleteAndHasTheDefaults) {
  lamina::ControllerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("simulated_controller", schema);
}

TEST(NodeConfig, OfTheLargeGantryLoadsAndHasAStartupSequence) {
  lamina::GcodeStreamerSettings streamer;
  lamina::SettingsSchema streamer_schema;
  describe(streamer_schema, streamer);
  load("large_gantry_45_startup.yaml", streamer_schema);
  EXPECT_EQ(lamina::makeStartupSequence(streamer.startup).size(), lamina::kStartupStepCount);
  lamina::EmulatedMachineSettings machine;
  lamina::SettingsSchema machine_schema;
  describe(machine_schema, machine);
  load("large_gantry_45_emulator.yaml", machine_schema);
  EXPECT_EQ(machine.machine.name, streamer.machine.name);
  EXPECT_EQ(machine.emulator.vacuum_zones, static_cast<int>(lamina::vacuumZones(streamer.startup).size()));
}

TEST(NodeConfig, OfSlicingServiceIsCompleteAndHasTheDefaults) {
  lamina::JobSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("slicing_service", schema);
}

TEST(NodeConfig, OfVoidFillerIsCompleteAndHasTheDefaults) {
  lamina::JobSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("void_filler", schema);
  expectDefaults("stiffness_solver", schema);
}

TEST(NodeConfig, OfOptimiserIsCompleteAndHasTheDefaults) {
  lamina::OptimiserSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("optimiser", schema);
}

TEST(NodeConfig, OfTrajectoryPublisherIsCompleteAndHasTheDefaults) {
  lamina::PublisherSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("trajectory_publisher", schema);
}

TEST(NodeConfig, OfHostWatchIsCompleteAndHasTheDefaults) {
  lamina::HostWatchNodeSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("host_watch", schema);
}

TEST(NodeConfig, OfLayerHeightMonitorIsCompleteAndHasTheDefaults) {
  lamina::LayerHeightMonitorSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("layer_height_monitor", schema);
}

TEST(NodeConfig, OfHeightControllerIsCompleteAndHasTheDefaults) {
  lamina::HeightControllerSettings settings;
  lamina::SettingsSchema schema;
  describe(schema, settings);
  expectDefaults("height_controller", schema);
}

/// Sets what a file states of a node, under its name.
/// @return how much
std::size_t loadOf(const std::string& node, const std::string& file, lamina::SettingsSchema& schema) {
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/config/" + file;
  std::size_t count = 0;
  for (const auto& setting : lamina::settingsFromYaml(lamina::readFile(path), path)) {
    if (setting.key.rfind(node + ".", 0) != 0) continue;
    schema.set(setting.key.substr(node.size() + 1), setting.text);
    ++count;
  }
  return count;
}

TEST(NodeConfig, OfTheDemosByJointsHoldsSettingsThereAre) {
  for (const std::string file : {"demo_five_axis.yaml", "demo_volumetric.yaml", "demo_robot.yaml"}) {
    lamina::JobSettings slicing;
    lamina::SettingsSchema slicing_schema;
    describe(slicing_schema, slicing);
    EXPECT_GT(loadOf("slicing_service", file, slicing_schema), 0U);
    EXPECT_NO_THROW(validate(slicing)) << file;
  }
  lamina::DriverSettings driver;
  lamina::SettingsSchema driver_schema;
  describe(driver_schema, driver);
  EXPECT_GT(loadOf("trajectory_driver", "demo_robot.yaml", driver_schema), 0U);
  EXPECT_EQ(driver.run.timing.process.kind, lamina::ProcessKind::Powder);
}

TEST(NodeConfig, OfTheDemosHoldsSettingsThereAre) {
  const std::string folder = std::string(LAMINA_SOURCE_DIR) + "/config/";
  EXPECT_EQ(lamina::loadJobSettings(folder + "demo.yaml", {}).scan.every_layers, 1);
  EXPECT_EQ(lamina::loadJobSettings(folder + "demo_inclined.yaml", {}).planning.skirt.count, 0);
}

}  // namespace
