// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Every setting that only a node has changes what a probe says, or is set in a test of the node that depends
// on it; those that end a driven job hold to the second.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "job/settings/covered_schemas.hpp"
#include "lamina/base/atomic_file.hpp"
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
#include "nodes/print_part/print_part_settings.hpp"
#include "nodes/print_part/print_report.hpp"
#include "nodes/process_io/process_io_settings.hpp"
#include "nodes/servo_bridge/bridge_settings.hpp"
#include "nodes/simulated_controller/controller_settings.hpp"
#include "nodes/trajectory_driver/driver_settings.hpp"
#include "nodes/trajectory_driver/report_watch.hpp"
#include "nodes/trajectory_driver/tracking.hpp"
#include "nodes/trajectory_publisher/publisher_settings.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/gantry_head.hpp"

namespace lamina::test {
namespace {

/// Keys of the nodes that the core does not describe.
std::set<std::string> nodeKeys() {
  std::set<std::string> keys;
  for (const auto& of_node :
       {keysOf<CellControllerSettings>(), keysOf<DepositionSimulatorSettings>(),
        keysOf<EmulatedCouplerSettings>(), keysOf<EmulatedMachineSettings>(), keysOf<GcodeInclinerSettings>(),
        keysOf<GcodeStreamerSettings>(), keysOf<HeightControllerSettings>(), keysOf<HostWatchNodeSettings>(),
        keysOf<LayerHeightMonitorSettings>(), keysOf<LinkSettings>(), keysOf<OperatorPageSettings>(),
        keysOf<OptimiserSettings>(), keysOf<ProcessIoSettings>(), keysOf<ControllerSettings>(),
        keysOf<DriverSettings>(), keysOf<PrintPartSettings>(), keysOf<PublisherSettings>(),
        keysOf<ServoBridgeSettings>()})
    keys.insert(of_node.begin(), of_node.end());
  for (const std::string& key : coreKeys()) keys.erase(key);
  return keys;
}

/// Of the cell's PLC.
const std::vector<TestedElsewhere>& plcTests() {
  static const std::vector<TestedElsewhere> all = {
      {"modbus.watchdog_action", "ros/cell/plc_link_test.cpp", "_modbus/watchdog_action"}};
  return all;
}

/// Of the loop on heights.
const std::vector<TestedElsewhere>& loopTests() {
  static const std::vector<TestedElsewhere> all = {
      {"feeder.uncertainty_s", "control/run/loop_run_settings_test.cpp", "feeder.uncertainty_s"},
      {"head.clearance_mm", "control/run/loop_run_settings_test.cpp", "head.clearance_mm"},
      {"loop.learned", "control/run/taught_part_test.cpp", "loop.learned"},
      {"memory_file", "ros/loop/height_controller_test.cpp", "_memory_file"},
      {"monitor.reorder_s", "control/run/loop_run_settings_test.cpp", "monitor.reorder_s"},
      {"monitor.settle_mm", "control/run/loop_run_settings_test.cpp", "monitor.settle_mm"},
      {"monitor.settle_s", "control/run/loop_run_settings_test.cpp", "monitor.settle_s"},
      {"process.gain_ratio", "control/run/loop_run_settings_test.cpp", "process.gain_ratio"},
      {"process.levelling_mm", "control/run/loop_run_settings_test.cpp", "process.levelling_mm"},
      {"process.material", "ros/loop/height_controller_test.cpp", "_process/material"},
      {"process.standoff", "control/run/loop_run_settings_test.cpp", "process.standoff"},
      {"request", "control/run/loop_run_settings_test.cpp", "\"request\""},
      {"sensor.calibration", "ros/loop/height_controller_test.cpp", "_sensor/calibration"},
      {"sensor.other_time_offset_sigmas_s", "control/run/loop_run_settings_test.cpp",
       "sensor.other_time_offset_sigmas_s"},
      {"sensor.other_time_offsets_s", "control/run/loop_run_settings_test.cpp",
       "sensor.other_time_offsets_s"},
      {"sensor.place_error_mm", "control/run/loop_run_settings_test.cpp", "sensor.place_error_mm"},
      {"sensor.place_trusted", "control/run/loop_run_settings_test.cpp", "sensor.place_trusted"},
      {"sensor.time_offset_sigma_s", "control/run/loop_run_settings_test.cpp", "sensor.time_offset_sigma_s"},
      {"sensor.time_offset_trusted", "control/run/loop_run_settings_test.cpp", "sensor.time_offset_trusted"}};
  return all;
}

/// Of the watch of a host.
const std::vector<TestedElsewhere>& hostTests() {
  static const std::vector<TestedElsewhere> all = {
      {"clock.shift_s", "ros/hosts/host_watch_test.py", "_clock/shift_s"},
      {"disk.folder", "ros/hosts/host_watch_test.py", "_disk/folder"},
      {"guard.socket", "ros/cell/cell_controller_test.cpp", "_guard/socket"},
      {"hosts.bind", "ros/hosts/host_watch_test.py", "_hosts/bind"},
      {"hosts.name", "ros/hosts/host_watch_test.py", "_hosts/name"},
      {"nodes", "ros/hosts/host_watch_test.py", "_nodes"}};
  return all;
}

/// Of process_io and its coupler.
const std::vector<TestedElsewhere>& processTests() {
  static const std::vector<TestedElsewhere> all = {
      {"bind", "ros/process_io/process_io.test", "bind"},
      {"ready", "ros/process_io/process_io.test", "ready"},
      {"state_hz", "ros/process_io/process_io_test.cpp", "state_hz"}};
  return all;
}

/// Of robots that take a target each cycle.
const std::vector<TestedElsewhere>& servoTests() {
  static const std::vector<TestedElsewhere> all = {{"emulated", "ros/drive/servo_bridge.test", "emulated"}};
  return all;
}

/// Of the operator's page.
const std::vector<TestedElsewhere>& pageTests() {
  static const std::vector<TestedElsewhere> all = {
      {"camera.topic", "ros/cell/operator_page_test.cpp", "_camera/topic"},
      {"web.folder", "ros/cell/operator_page_test.cpp", "_web/folder"}};
  return all;
}

const std::vector<TestedElsewhere>& nodeTests() {
  static const std::vector<TestedElsewhere> all = {
      {"baud", "ros/streaming/gcode_streamer_test.cpp", "_baud"},
      {"cartesian.rate_hz", "ros/playback/trajectory_publisher.test", "cartesian/rate_hz"},
      {"corrections.follow_plans", "ros/loop/corrected_stream_test.cpp", "_corrections/follow_plans"},
      {"corrections.folder", "ros/adapters/layer_corrector_test.cpp", "corrections.folder"},
      {"corrections.use", "ros/adapters/layer_corrector_test.cpp", "corrections.use"},
      {"executor.kind", "ros/cell/robot_cell_test.cpp", "_executor/kind"},
      {"executor.owner", "ros/cell/cell_of_nodes.hpp", "_executor/owner"},
      {"executor.placement", "ros/cell/job_rules_test.cpp", "as_is.placement = Placement::AsIs"},
      {"filament_diameter_mm", "ros/machine/configured_machine_test.cpp", "filament_diameter_mm"},
      {"host_wait_s", "ros/drive/simulated_controller.test", "host_wait_s"},
      {"journal.folder", "ros/cell/unit_of_nodes.hpp", "journal/folder"},
      {"journal.least_free_gib", "ros/cell/cell_controller_test.cpp", "_journal/least_free_gib"},
      {"load_program", "ros/playback/inclined_playback_test.cpp", "load_program"},
      {"map_period_s", "ros/monitor/layer_height_monitor.test", "map_period_s"},
      {"mode", "ros/deposition/deposition_following_test.cpp", "_mode:=follow"},
      {"output_folder", "ros/end_to_end.test", "output_folder"},
      {"owner.grace_s", "ros/cell/cell_of_nodes.hpp", "_owner/grace_s"},
      {"packml.hold_anywhere", "ros/cell/cell_controller_test.cpp", "packml/hold_anywhere"},
      {"part", "ros/end_to_end_test.cpp", "settings.part"},
      {"path_tolerance", "ros/drive/simulated_controller.test", "path_tolerance"},
      {"path_spacing_mm", "ros/playback/trajectory_publisher.test", "path_spacing_mm"},
      {"patience_s", "ros/end_to_end_test.cpp", "settings.patience_s"},
      {"port", "ros/streaming/gcode_streamer.test", "port"},
      {"position_spacing_mm", "ros/machine/configured_machine_test.cpp", "position_spacing_mm"},
      {"profile_spacing_mm", "ros/machine/emulated_machine.test", "profile_spacing_mm"},
      {"profile_while_depositing", "ros/machine/configured_machine_test.cpp", "profile_while_depositing"},
      {"queue_mb", "ros/monitor/layer_height_monitor.test", "queue_mb"},
      {"rate_hz", "ros/playback/trajectory_publisher.test", "rate_hz"},
      {"report_hz", "ros/drive/simulated_controller.test", "report_hz"},
      {"speed_up", "ros/playback/trajectory_publisher.test", "trajectory_publisher/speed_up"},
      {"start.needs_loop", "ros/cell/cell_controller_test.cpp", "_start/needs_loop:=true"},
      {"start_delay_s", "ros/drive/trajectory_driver.test", "start_delay_s"},
      {"view.largest_program_mb", "ros/slicing/gcode_incliner_test.cpp", "view.largest_program_mb"}};
  return all;
}

/// Intervals and patience that a test sets, which would pass with the usual ones too: none of them keeps
/// anybody safe.
const std::vector<TestedElsewhere>& onlySet() {
  static const std::vector<TestedElsewhere> all = {
      {"deposit.period_s", "ros/machine/emulated_belt.test", "period_s: 0.1"},
      {"following.period_s", "ros/deposition/deposition_following.test", "following/period_s"},
      {"hosts.interval_s", "ros/hosts/host_watch_test.py", "_hosts/interval_s"}};
  return all;
}

std::vector<SettingProbe> nodeProbes() {
  std::vector<SettingProbe> all;
  for (const auto& probes :
       {jogProbes(), driveProbes(), servoProbes(), plcProbes(), guardProbes(), hostProbes(),
        processIoProbes(), pageProbes(), machineProbes(), watchProbes(), shownProbes()})
    all.insert(all.end(), probes.begin(), probes.end());
  return all;
}

TEST(NodeSettingsCoverage, EverySettingStandsInATest) {
  std::set<std::string> covered;
  for (const SettingProbe& probe : nodeProbes())
    for (const SettingRow& row : probe.rows) covered.insert(changedKey(row));
  std::vector<TestedElsewhere> tests = nodeTests();
  tests.insert(tests.end(), loopTests().begin(), loopTests().end());
  tests.insert(tests.end(), hostTests().begin(), hostTests().end());
  tests.insert(tests.end(), processTests().begin(), processTests().end());
  tests.insert(tests.end(), pageTests().begin(), pageTests().end());
  tests.insert(tests.end(), plcTests().begin(), plcTests().end());
  tests.insert(tests.end(), servoTests().begin(), servoTests().end());
  tests.insert(tests.end(), onlySet().begin(), onlySet().end());
  for (const TestedElsewhere& setting : tests) {
    covered.insert(setting.key);
    const std::string text = readFile(std::string(LAMINA_SOURCE_DIR) + "/test/" + setting.file);
    EXPECT_NE(text.find(setting.word), std::string::npos) << setting.key << " in " << setting.file;
  }
  for (const TestedElsewhere& of_core : testedElsewhere()) covered.erase(of_core.key);
  const std::set<std::string> keys = nodeKeys();
  for (const std::string& key : keys) EXPECT_EQ(covered.count(key), 1U) << key << " stands in no test";
  for (const std::string& key : covered)
    EXPECT_EQ(keys.count(key), 1U) << key << " is no setting of a node alone";
}

TEST(NodeSettingsCoverage, OfJogs) { expectEffects(jogProbes()); }
TEST(NodeSettingsCoverage, OfDrivers) { expectEffects(driveProbes()); }
TEST(NodeSettingsCoverage, OfServos) { expectEffects(servoProbes()); }
TEST(NodeSettingsCoverage, OfPlcs) { expectEffects(plcProbes()); }
TEST(NodeSettingsCoverage, OfGuards) { expectEffects(guardProbes()); }
TEST(NodeSettingsCoverage, OfHosts) { expectEffects(hostProbes()); }
TEST(NodeSettingsCoverage, OfProcesses) { expectEffects(processIoProbes()); }
TEST(NodeSettingsCoverage, OfPages) { expectEffects(pageProbes()); }
TEST(NodeSettingsCoverage, OfMachines) { expectEffects(machineProbes()); }
TEST(NodeSettingsCoverage, OfWhatIsShown) { expectEffects(shownProbes()); }
TEST(NodeSettingsCoverage, OfWatches) { expectEffects(watchProbes()); }

TEST(NodeSettingsCoverage, APrintLooksForScansAtTheirClearance) {
  Path scan;
  scan.role = PathRole::Travel;
  scan.points = {{0, 0, 0.2}, {0, 0, 1.3}};  // 5.5 layers over the top
  const Toolpath toolpath{"scanned", {{0.2, 0.2, {scan}}}};
  const auto scanned = [&](const SettingTexts& set) {
    return scannedLayers(toolpath, settingsWith<PrintPartSettings>(set).scan_clearance_mm);
  };
  EXPECT_EQ(scanned({}), std::vector<std::size_t>{0});
  EXPECT_TRUE(scanned({{"scan.clearance_mm", "3"}}).empty());
}

/// When a driver that looks every 10 ms gives up a controller that reports for half a second by its stamps.
double givenUpAt(const SettingTexts& set) {
  const ros::Time begin(1000.0);
  const auto limits = settingsWith<DriverSettings>(set).tracking;
  ReportWatch watch(limits, 5.0, begin);
  for (int i = 1; i <= 50; ++i) {
    const ros::Time now = begin + ros::Duration(0.01 * i);
    watch.hear(now, now);
    if (watch.look(now)) return 0.01 * i;
  }
  for (int i = 51; i < 2000; ++i)
    if (watch.look(begin + ros::Duration(0.01 * i))) return 0.01 * i - 0.5;
  return -1.0;
}

TEST(NodeSettingsCoverage, SilenceEndsAJobAfterItsTime) {
  EXPECT_NEAR(givenUpAt({{"tracking.silence_s", "0.3"}}), 0.3, 0.021);
  EXPECT_NEAR(givenUpAt({{"tracking.silence_s", "2"}}), 2.0, 0.021);
  EXPECT_NEAR(givenUpAt({{"tracking.silence_s", "2"}, {"tracking.silence_by", "stamps"}}), 5.0, 0.021);
}

TEST(NodeSettingsCoverage, ATipTooFarFromThePathEndsAJob) {
  const GantryHead gantry(ToolAxisSpin::Free);
  Tracking tracking(gantry);
  JointValues wanted = JointValues::Zero(5);
  JointValues actual = wanted;
  EXPECT_FALSE(tracking.deviation(1e-3)) << "nothing was reported yet";
  actual.head<3>() << 2.0, 3.0, 6.0;  // 7 mm off
  tracking.add(wanted, actual);
  const auto deviation = [&](const SettingTexts& set) {
    return tracking.deviation(settingsWith<DriverSettings>(set).tracking.tip_mm);
  };
  ASSERT_TRUE(deviation({}));
  EXPECT_NE(deviation({})->find("expected at most 5"), std::string::npos) << *deviation({});
  EXPECT_TRUE(deviation({{"tracking.tip_mm", "6.999"}}));
  EXPECT_FALSE(deviation({{"tracking.tip_mm", "7.001"}}));
  EXPECT_FALSE(deviation({{"tracking.tip_mm", "0"}})) << "no limit";
}

}  // namespace
}  // namespace lamina::test
