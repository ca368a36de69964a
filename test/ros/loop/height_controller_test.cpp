// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop as a node, over prints whose answer is known; and over the same ones without a master.
#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "correction_messages.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "latched.hpp"
#include "ros/bag_player.hpp"
#include "ros/loop/controlled_wall.hpp"
#include "ros/loop/estimated_bag.hpp"
#include "ros/loop/shown_cells.hpp"
#include "ros/loop/wall_messages.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::calibratedLoop;
using test::Controller;
using test::estimate;
using test::LiveWall;
using test::NodeProcess;
using test::replayed;
using test::ReportedMachine;
using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;
using test::SensorDoes;
using test::waitUntil;
using StateMessage = lamina_msgs::LoopState;

SensedWallCase wallCase() {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  return wall;
}

/// A third as long: for what does not depend on the length.
SensedWallCase shortWall(std::size_t layers) {
  SensedWallCase wall = wallCase();
  wall.length_mm = 20.0;
  wall.layers = layers;
  return wall;
}

TEST(HeightController, GivesTheMapsThatAreWorkedOut) {
  const SensedWallCase wall = wallCase();
  const test::WallTruth truth = test::wallTruth(wall);
  const test::ScratchFolder folder;
  test::writeBag(folder.file("wall.bag"), sensedWall(wall));
  Controller controller({"_output_folder:=" + folder.file("report")});
  ros::NodeHandle node;
  const test::ShownCells shown(node);
  const test::BagPlayer player(folder.file("wall.bag"), {"--rate=10"});
  waitUntil([&] {
    return controller.layers.size() >= wall.layers && controller.maps.size() >= wall.layers &&
           shown.areAll(wall.layers);
  });
  ASSERT_EQ(controller.layers.size(), wall.layers);
  ASSERT_EQ(controller.maps.size(), wall.layers);
  for (std::size_t k = 0; k < wall.layers; ++k) {
    const auto& layer = controller.layers[k];
    EXPECT_EQ(layer.layer, k);
    EXPECT_EQ(layer.state, StateMessage::ACTIVE + 0);
    EXPECT_TRUE(layer.is_measured);
    EXPECT_NEAR(layer.coverage, 1.0, 1e-12);
    EXPECT_NEAR(toMillimetres(layer.mean_error), truth.error_mm[k], 0.01);
    EXPECT_LT(toMillimetres(layer.flatness), 0.05);
    EXPECT_NEAR(toMillimetres(layer.rmse), std::abs(truth.error_mm[k]), 0.05);
    EXPECT_NEAR(layer.gain_mean, truth.gain[k], 0.01);
    EXPECT_LE(layer.gain_least, layer.gain_mean);
    EXPECT_GE(layer.gain_greatest, layer.gain_mean);
    EXPECT_EQ(layer.map_digest, controller.maps[k].digest);
    EXPECT_EQ(layer.limited_share, 0.0);
    EXPECT_EQ(layer.contested_share, 0.0);
    EXPECT_EQ(layer.deviating_share, 0.0);
    EXPECT_GT(layer.consistency, 0.0);
    EXPECT_GT(layer.repeatability, 0.0);
    for (const std::uint16_t alarm : layer.alarms) EXPECT_EQ(alarm, 6106) << "cells that are all alike";
    const CorrectionMap map = toCore(controller.maps[k]);
    const double amount = map.paths.empty() ? 0.0 : correctionAt(map.paths[0], 30.0).amount;
    EXPECT_NEAR(amount, truth.amount[k], 0.01) << k;
  }
  ASSERT_TRUE(shown.areAll(wall.layers));
  EXPECT_EQ(shown.cells->width, 120U) << "60 mm of cells of 0.5 mm";
  EXPECT_EQ(shown.cells->fields.back().name, "sigma");
  EXPECT_EQ(shown.gains->width, 120U);
  EXPECT_EQ(shown.gains->fields.back().name, "gain");
  EXPECT_EQ(controller.end(SIGINT), 0);
  EXPECT_NE(readFile(folder.file("report/loop_report.html")).find("<svg"), std::string::npos);
  EXPECT_NE(readFile(folder.file("report/loop_layers.csv")).find(controller.maps.back().digest),
            std::string::npos);
}

TEST(HeightController, ReplaysToTheSameBitsAtAnySpeedAndWithoutAMaster) {
  const SensedWallCase wall = shortWall(4);
  const test::ScratchFolder folder;
  const std::string bag = folder.file("wall.bag");
  test::writeBag(bag, sensedWall(wall));
  const nlohmann::json offline = estimate(bag, "--namespace / -o " + folder.file("estimate"));
  const std::vector<std::string> expected = offline["prints"][0]["map_digests"];
  EXPECT_EQ(expected.size(), wall.layers);
  EXPECT_NE(expected[2], expected[3]);
  EXPECT_EQ(replayed(bag, wall.layers, "10"), expected);
  EXPECT_EQ(replayed(bag, wall.layers, "1"), expected);
  {
    const Controller controller;
    const test::BagPlayer player(bag, {"--rate=10", "--delay=0.5"});
    waitUntil([&] { return controller.layers.size() >= wall.layers; });
    std::vector<std::string> coasting;
    for (const auto& map : controller.coasting_maps) coasting.push_back(map.digest);
    EXPECT_EQ(coasting.size(), wall.layers - 1);
    EXPECT_EQ(coasting, std::vector<std::string>(offline["prints"][0]["coasting_digests"]));
  }
  EXPECT_NE(readFile(folder.file("estimate/correction_3.csv")).find(expected[3]), std::string::npos);
  const std::vector<FiledMap> maps = readCorrectionFiles(folder.file("estimate"));
  EXPECT_EQ(maps.size(), wall.layers);
  const ProgrammedToolpath planned =
      readProgrammedToolpath(readFile(folder.file("estimate/toolpath.csv")), "toolpath.csv");
  for (const FiledMap& each : maps) EXPECT_EQ(defectOf(each.map, planned), "") << each.file;
}

TEST(HeightController, TakesTheOffsetOfTheSensorsClockOff) {
  SensedWallCase wall = wallCase();
  wall.layers = 4;
  const test::ScratchFolder folder;
  const SensedWall printed = sensedWall(wall);
  test::writeBag(folder.file("right.bag"), printed);
  test::writeBag(folder.file("late.bag"), printed, 0.25);
  const nlohmann::json right = estimate(folder.file("right.bag"));
  const nlohmann::json late = estimate(folder.file("late.bag"), "--set sensor.time_offset_s=0.25");
  EXPECT_EQ(right["prints"][0]["map_digests"], late["prints"][0]["map_digests"]);
}

constexpr double kLate = 0.25;  // s, by which the stamps of a sensor are late

/// What `lamina calibrate` found of the wall's sensor, by a clock that is late.
Calibration wallCalibration(const std::string& machine = "cartesian_gantry") {
  Calibration found;
  found.machine = machine;
  found.time = CalibratedTime{kLate, 1e-4, 0.0, 0.0, {"bobbing", "2026-11-23T12:00:00Z"}};
  found.pose = CalibratedPose{};
  found.pose->nozzle_from_sensor = test::sensorOfWall();
  found.pose->origin = {"cross", "2026-11-23T12:00:01Z"};
  return found;
}

const std::vector<std::string> kUntyped = {"_sensor/time_offset_trusted:=false",
                                           "_sensor/place_trusted:=false"};

/// A sensor whose clock is late, and that tf has 7 mm off its place: the file says where and when it sees.
TEST(HeightController, GoesByTheFileOfACalibration) {
  const SensedWallCase wall = shortWall(4);
  const test::ScratchFolder folder;
  const SensedWall printed = sensedWall(wall);
  test::writeBag(folder.file("right.bag"), printed);
  test::writeBag(folder.file("off.bag"), printed, kLate, {7.0, 3.0, 1.0});
  const std::string cell = folder.file("cell.yaml");
  writeCalibration(cell, wallCalibration());
  const nlohmann::json right = estimate(folder.file("right.bag"))["prints"][0];
  const nlohmann::json all = estimate(folder.file("off.bag"), "", "--set sensor.calibration=" + cell);
  const nlohmann::json& calibrated = all["prints"][0];
  for (std::size_t k = 0; k < wall.layers; ++k) {
    EXPECT_NEAR(calibrated["layers"][k]["mean_error_mm"], right["layers"][k]["mean_error_mm"], 1e-4) << k;
    EXPECT_NEAR(calibrated["layers"][k]["gain_mean"], right["layers"][k]["gain_mean"], 1e-4) << k;
  }
  EXPECT_NE(all["calibration"][0].get<std::string>().find("250.000 ms"), std::string::npos);
  std::vector<std::string> parameters = kUntyped;
  parameters.push_back("_sensor/calibration:=" + cell);
  const std::vector<std::string> expected = calibrated["map_digests"];
  EXPECT_EQ(replayed(folder.file("off.bag"), wall.layers, "4", parameters), expected);
}

/// The offset that a print's own scans tell, put into the file beside the place of the sensor.
double offsetOfPrint(const std::string& bag, const std::string& cell) {
  Calibration place = wallCalibration("cartesian_gantry");
  place.time.reset();
  writeCalibration(cell, place);
  const std::string command =
      std::string(LAMINA_COMMAND) + " calibrate time " + bag + " --method overlap -o " + cell;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const Calibration found = readCalibration(cell);
  EXPECT_TRUE(found.time && found.pose);
  return found.time ? found.time->offset_s : 0.0;
}

/// Scans there and back and there, by a clock that is 0.1 s late, which nobody knows: the print is its own
/// calibration, and gives the figures that a known offset gives.
TEST(HeightController, IsCalibratedByTheScansOfThePrintItself) {
  SensedWallCase wall = wallCase();
  wall.layers = 6;
  wall.scans = 3;
  wall.grows = [](std::size_t, double along_mm) { return 1.0 + 0.1 * std::sin(0.45 * along_mm); };
  const test::ScratchFolder folder;
  const std::string bag = folder.file("late.bag");
  test::writeBag(bag, sensedWall(wall), 0.1);
  EXPECT_NEAR(offsetOfPrint(bag, folder.file("cell.yaml")), 0.1, 0.002);
  const auto rmseWith = [&](const std::string& known) {
    return estimate(bag, "", known)["prints"][0]["layers"];
  };
  const nlohmann::json found = rmseWith("--set sensor.calibration=" + folder.file("cell.yaml"));
  const nlohmann::json known = rmseWith(
      "--set sensor.time_offset_s=0.1 --set sensor.time_offset_trusted=true --set sensor.place_trusted=true");
  for (std::size_t k = 0; k < wall.layers; ++k) {
    const double rmse_mm = known[k]["rmse_mm"];
    EXPECT_NEAR(found[k]["rmse_mm"], rmse_mm, 0.05 * rmse_mm) << k;
  }
}

TEST(HeightController, EndsAtItsStartWithoutTheCalibrationItIsGiven) {
  const test::ScratchFolder folder;
  NodeProcess node(LAMINA_LOOP_NODE,
                   {"_sensor/calibration:=" + folder.file("none.yaml"), "__name:=uncalibrated"});
  EXPECT_EQ(node.wait(), 1);
}

/// Two layers; the scan of each takes two seconds and a half, a second longer than the longest silence.
SensedWallCase slowlyScanned() {
  SensedWallCase wall = shortWall(2);
  wall.scan_mm_s = 8.0;
  return wall;
}

/// The scan of a layer begins, by the stamp of its first cloud, or would.
std::int64_t scanOf(const SensedWall& printed, std::size_t layer) {
  const double above = printed.part.toolpath.layers[layer].paths[1].points[1].z();
  for (const StampedTip& pose : printed.tips)
    if (pose.tip.z() > above - 1e-6) return pose.stamp_ns;
  return 0;
}

/// Seconds of the machine's clock from the fault to the state that it should lead to.
double reactionTime(const SensedWallCase& wall, bool loses_tf, std::uint16_t alarm) {
  Controller controller({"_loop/silence_s:=1.5", "_monitor/reorder_s:=0.2", "_arrival_hold_s:=0.1"});
  LiveWall live(wall);
  const std::int64_t fault_ns = scanOf(live.printed, 1);
  if (loses_tf) live.no_tf_from_ns = fault_ns + 100'000'000;
  live.say([&] { return controller.isIn(StateMessage::COASTING); });
  EXPECT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::COASTING); })) << alarm;
  const StateMessage& state = controller.states.back();
  EXPECT_EQ(state.alarm, alarm);
  EXPECT_EQ(state.reaction, StateMessage::COAST + 0);
  EXPECT_EQ(state.coasting_for, StateMessage::SIGHT + 0);
  EXPECT_EQ(state.layer, 1U);
  EXPECT_EQ(state.state_name, "coasting");
  EXPECT_FALSE(state.reason.empty());
  return (live.now() - test::timeOf(fault_ns)).toSec();
}

TEST(HeightController, CoastsWithinASecondWhenTheSensorFallsSilent) {
  SensedWallCase wall = slowlyScanned();
  wall.sensor = [](std::size_t layer) { return layer == 1 ? SensorDoes::KeepSilent : SensorDoes::Measure; };
  EXPECT_LT(reactionTime(wall, false, 6101), 1.5 + 1.0);
}

TEST(HeightController, ReportsASilentSensorToTheUnitUntilItIsHeardAgain) {
  SensedWallCase wall = slowlyScanned();
  wall.layers = 3;
  wall.sensor = [](std::size_t layer) { return layer == 1 ? SensorDoes::KeepSilent : SensorDoes::Measure; };
  Controller controller({"_loop/silence_s:=1.5", "_monitor/reorder_s:=0.2", "_arrival_hold_s:=0.1"});
  LiveWall live(wall);
  live.say([&] { return controller.hasRaised(6101); });
  ASSERT_TRUE(waitUntil([&] { return controller.hasRaised(6101); }));
  EXPECT_EQ(controller.alarms.back().source, "height_controller");
  EXPECT_NE(controller.alarms.back().message.find("no cloud for "), std::string::npos)
      << controller.alarms.back().message;
  EXPECT_FALSE(controller.hasEnded(6101));
  live.say([&] { return controller.hasEnded(6101); });
  EXPECT_TRUE(waitUntil([&] { return controller.hasEnded(6101); }));
}

TEST(HeightController, CoastsWithinASecondWhenTheSensorIsStuck) {
  for (const SensorDoes does : {SensorDoes::SayNothing, SensorDoes::SayTheSame}) {
    SensedWallCase wall = slowlyScanned();
    wall.sensor = [does](std::size_t layer) { return layer == 1 ? does : SensorDoes::Measure; };
    EXPECT_LT(reactionTime(wall, false, 6103), 0.5 + 1.0) << "fifty profiles and a second";
  }
}

TEST(HeightController, CoastsWithinASecondWhenTfStops) {
  EXPECT_LT(reactionTime(slowlyScanned(), true, 6102), 0.1 + 1.5 + 1.0);
}

/// The machine waited for the map of the third layer in vain: 6116 comes within a second, the layer counts as
/// coasted, and growth is learnt from what was deposited.
TEST(HeightController, ReportsAMapThatTheMachineMissed) {
  SensedWallCase wall = shortWall(4);
  wall.misses_map = [](std::size_t layer) { return layer == 2; };
  Controller controller({"_monitor/reorder_s:=0.1", "_arrival_hold_s:=0.1"});
  ros::NodeHandle node;
  auto applied = node.advertise<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 10);
  LiveWall live(wall);
  ASSERT_TRUE(waitUntil([&] { return applied.getNumSubscribers() > 0; }));
  lamina_msgs::AppliedCorrection missed = toMessage({2, 2.0, {}, {}}, live.printed.part.toolpath_id, "");
  lamina_msgs::AppliedCorrection of_another_print = missed;
  of_another_print.toolpath_id = "another";
  of_another_print.layer = 1;
  live.say([&] { return controller.maps.size() == 3; });
  applied.publish(of_another_print);
  applied.publish(missed);
  const auto isReported = [&] { return controller.states.back().alarm == 6116; };
  live.say(isReported);
  ASSERT_TRUE(waitUntil(isReported));
  EXPECT_EQ(controller.states.back().reaction, StateMessage::COAST + 0);
  EXPECT_NE(controller.states.back().reason.find("none came within 2 s"), std::string::npos)
      << controller.states.back().reason;
  live.say([&] { return controller.layers.size() == 4; });
  ASSERT_TRUE(waitUntil([&] { return controller.layers.size() == 4; }));
  const std::vector<std::uint8_t> states = {StateMessage::ACTIVE, StateMessage::ACTIVE,
                                            StateMessage::COASTING, StateMessage::ACTIVE};
  const test::WallTruth truth = test::wallTruth(wall);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(controller.layers[k].state, states[k]) << k;
    EXPECT_NEAR(controller.layers[k].gain_mean, truth.gain[k], 0.01) << k;
  }
  const auto& alarms = controller.layers[2].alarms;
  EXPECT_EQ(std::count(alarms.begin(), alarms.end(), 6116), 1);
}

lamina_msgs::SetLoop::Response setLoop(std::uint8_t request) {
  lamina_msgs::SetLoop call;
  call.request.request = request;
  EXPECT_TRUE(callService(names::kSetLoop, call));
  return call.response;
}

TEST(HeightController, FadesWhenItIsSwitchedOffAmidALayer) {
  const SensedWallCase wall = shortWall(5);
  Controller controller;
  LiveWall live(wall);
  live.say([&] { return controller.maps.size() >= 4 && controller.states.back().layer == 3; });
  const auto response = setLoop(lamina_msgs::SetLoop::Request::OFF);
  EXPECT_EQ(response.status.code, lamina_msgs::Status::OK + 0);
  EXPECT_EQ(response.state, StateMessage::OFF + 0);
  live.say([&] { return controller.layers.size() == 5; });
  ASSERT_TRUE(waitUntil([&] { return controller.layers.size() == 5; })) << "the print goes on";
  EXPECT_TRUE(controller.isIn(StateMessage::OFF));
  ASSERT_EQ(controller.maps.size(), 5U);
  const double last = toCore(controller.maps[3]).paths.at(0).stations.back().amount;
  const PathCorrection path = toCore(controller.maps[4]).paths.at(0);
  const double steepest = wall.settings.loop.feeder_rate_s / wall.speed_mm_s;  // 1/mm
  EXPECT_GT(last, 0.05);
  EXPECT_NEAR(path.stations.front().amount, last, steepest * path.spacing_mm * (1.0 + 1e-9));
  for (std::size_t i = 1; i < path.stations.size(); ++i)
    EXPECT_LE(std::abs(path.stations[i].amount - path.stations[i - 1].amount),
              steepest * path.spacing_mm * (1.0 + 1e-9));
  EXPECT_EQ(path.stations.back().amount, 0.0);
}

TEST(HeightController, RefusesToCorrectUncalibrated) {
  Controller controller({"_sensor/place_trusted:=false", "_request:=none"});
  EXPECT_EQ(setLoop(lamina_msgs::SetLoop::Request::IDENTIFY).status.code, lamina_msgs::Status::OK + 0)
      << "there is nothing to refuse before the first toolpath";
  LiveWall live(slowlyScanned());
  ASSERT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::BLOCKED); }));
  const auto response = setLoop(lamina_msgs::SetLoop::Request::ACTIVE);
  EXPECT_EQ(response.status.code, lamina_msgs::Status::REJECTED + 0);
  EXPECT_NE(response.status.message.find("place"), std::string::npos) << response.status.message;
  EXPECT_EQ(response.state, StateMessage::BLOCKED + 0);
  EXPECT_EQ(setLoop(9).status.code, lamina_msgs::Status::INVALID_INPUT + 0);
}

TEST(HeightController, IsBlockedByTheCalibrationOfAnotherMachine) {
  const test::ScratchFolder folder;
  const std::string cell = folder.file("cell.yaml");
  writeCalibration(cell, wallCalibration("other_machine"));
  std::vector<std::string> parameters = kUntyped;
  parameters.push_back("_sensor/calibration:=" + cell);
  Controller controller(parameters);
  LiveWall live(slowlyScanned());
  ASSERT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::BLOCKED); }));
  const std::string& reason = controller.states.back().reason;
  for (const char* word : {"cell.yaml", "other_machine", "cartesian_gantry"})
    EXPECT_NE(reason.find(word), std::string::npos) << word << " in: " << reason;
}

/// Calibrated while it waits for that.
TEST(HeightController, ReadsACalibrationThatComesLater) {
  const test::ScratchFolder folder;
  const std::string cell = folder.file("cell.yaml");
  Calibration later = wallCalibration();
  later.time->offset_s = 0.0;
  Calibration first = later;
  first.time.reset();
  writeCalibration(cell, first);
  std::vector<std::string> parameters = kUntyped;
  parameters.push_back("_sensor/calibration:=" + cell);
  Controller controller(parameters);
  LiveWall live(slowlyScanned());
  ASSERT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::BLOCKED); }));
  std_srvs::Trigger read;
  writeFile(cell, "a: 1");
  ASSERT_TRUE(callService(names::kReadCalibration, read));
  EXPECT_EQ(read.response.success, 0U);
  EXPECT_NE(read.response.message.find("cell.yaml"), std::string::npos) << read.response.message;
  writeCalibration(cell, later);
  ASSERT_TRUE(callService(names::kReadCalibration, read));
  EXPECT_EQ(read.response.success, 1U) << read.response.message;
  ASSERT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::ACTIVE); }));
  live.say([&] { return !controller.layers.empty(); });
  ASSERT_TRUE(waitUntil([&] { return !controller.layers.empty(); }));
  EXPECT_TRUE(controller.layers.front().is_measured);
}

/// The second layer is found four layers too low: the print is held before the map of the third one comes.
void expectHeld(const Controller& controller, const std::optional<std::size_t>& maps_when_held) {
  const SensedWallCase wall = shortWall(3);
  LiveWall live(wall);
  const std::int64_t second = scanOf(live.printed, 0) + 1'000'000'000;
  for (SensedCloud& cloud : live.printed.clouds)
    if (cloud.stamp_ns > second)
      for (Point3& point : cloud.profiles[0]) point.z() += 1.4;  // farther from the sensor
  live.say([&] { return maps_when_held.has_value(); });
  ASSERT_TRUE(waitUntil([&] { return maps_when_held.has_value(); })) << controller.maps.size();
  EXPECT_EQ(*maps_when_held, 2U);
  EXPECT_TRUE(waitUntil([&] { return controller.hasRaised(6110); })) << "the unit is told why";
}

TEST(HeightController, HoldsThePrintWhenAPieceComesOff) {
  Controller controller({"_pauses_print:=true"});
  ros::NodeHandle node;
  std::optional<std::size_t> maps_when_held;
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> on_pause =
      [&](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        maps_when_held = controller.maps.size();
        response.success = 1U;
        return true;
      };
  const auto pause =
      node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(names::kPause, on_pause);
  expectHeld(controller, maps_when_held);
}

TEST(HeightController, AsksTheUnitToHoldThePrintWhereThereIsOne) {
  using Command = lamina_msgs::PackmlCommand;
  Controller controller({"_pauses_print:=true"});
  ros::NodeHandle node;
  std::optional<std::size_t> maps_when_held;
  const boost::function<bool(Command::Request&, Command::Response&)> on_command =
      [&](Command::Request& request, Command::Response& response) {
        if (request.command == Command::Request::HOLD) maps_when_held = controller.maps.size();
        response.result = 1;
        return true;
      };
  const auto unit =
      node.advertiseService<Command::Request, Command::Response>(names::kPackmlCommand, on_command);
  expectHeld(controller, maps_when_held);
}

/// Killed amid the fifth of seven layers, and started again: the layers that follow are corrected as if
/// nothing had happened.
TEST(HeightController, GoesOnWhereItWasKilled) {
  const test::ScratchFolder folder;
  const SensedWallCase wall = shortWall(7);
  const std::vector<std::string> parameters = {"_memory_file:=" + folder.file("memory.yaml"),
                                               "_process/material:=steel"};
  std::optional<Controller> controller(std::in_place, parameters);
  LiveWall live(wall);
  live.say([&] { return controller->layers.size() >= 4 && controller->states.back().layer == 4; });
  EXPECT_EQ(controller->end(SIGKILL), -1);
  controller.emplace(parameters);
  live.waitUntilHeard();
  live.say([] { return false; });
  ASSERT_TRUE(waitUntil([&] { return !controller->layers.empty() && controller->layers.back().layer == 6; }));
  ASSERT_EQ(controller->maps.front().layer, 4U) << "the layer under way";
  for (const auto& map : controller->maps) {
    const auto& expected = live.printed.maps[map.layer];
    EXPECT_NEAR(correctionAt(toCore(map).paths.at(0), 10.0).amount,
                correctionAt(expected.paths.at(0), 10.0).amount, 0.02)
        << map.layer;
  }
  for (const auto& layer : controller->layers) {
    if (layer.layer < 5) continue;
    EXPECT_LT(toMillimetres(layer.rmse), 1.2 * live.printed.layers[4].figures.rmse_mm) << layer.layer;
  }
  EXPECT_TRUE(waitUntil([&] { return !std::filesystem::exists(folder.file("memory.yaml")); }))
      << "the print is over";
}

/// Kept of another material: the loop begins at the first layer.
TEST(HeightController, DoesNotGoOnWithAnotherMaterial) {
  const test::ScratchFolder folder;
  const SensedWallCase wall = shortWall(4);
  const std::string memory = "_memory_file:=" + folder.file("memory.yaml");
  std::optional<Controller> controller(std::in_place,
                                       std::vector<std::string>{memory, "_process/material:=steel"});
  LiveWall live(wall);
  live.say([&] { return controller->layers.size() >= 3; });
  EXPECT_EQ(controller->end(SIGKILL), -1);
  controller.emplace(std::vector<std::string>{memory, "_process/material:=bronze"});
  ASSERT_TRUE(waitUntil([&] { return !controller->maps.empty(); }));
  EXPECT_EQ(controller->maps.front().layer, 0U);
}

/// Killed after two layers, and gone on with; then the machine starts the same part once more.
TEST(HeightController, BeginsAgainWhenTheMachineDoes) {
  const test::ScratchFolder folder;
  const std::vector<std::string> parameters = {"_memory_file:=" + folder.file("memory.yaml")};
  std::optional<Controller> controller(std::in_place, parameters);
  LiveWall live(shortWall(4));
  // What is kept of a layer is written after its figures were published, and before the next state is.
  live.say([&] { return controller->layers.size() >= 2 && controller->states.back().layer == 2; });
  EXPECT_EQ(controller->end(SIGKILL), -1);
  controller.emplace(parameters);
  ASSERT_TRUE(waitUntil([&] { return !controller->maps.empty(); }));
  EXPECT_EQ(controller->maps.front().layer, 2U);
  ReportedMachine machine;
  machine.say(lamina_msgs::MachineState::STARTING, -1);
  ASSERT_TRUE(waitUntil([&] { return controller->maps.back().layer == 0; }));
  EXPECT_TRUE(controller->maps.back().paths.empty()) << "nothing is known of the first layer";
  EXPECT_FALSE(std::filesystem::exists(folder.file("memory.yaml")));
}

/// A feeder that brings a little more than half: the layers left are planned anew, the print is held, and the
/// loop goes on with the plan once that is what the machine drives.
TEST(HeightController, PlansTheLayersLeftAnewAndGoesOnWithThat) {
  SensedWallCase wall = wallCase();
  wall.growth = 0.55;
  wall.layers = 12;
  wall.length_mm = 10.0;
  Controller controller({"_loop/replan:=scale", "_monitor/reorder_s:=0.1", "_arrival_hold_s:=0.1"});
  ros::NodeHandle node;
  lamina_msgs::ToolpathConstPtr plan;
  const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> on_plan = [&](const auto& message) {
    if (!plan) plan = message;
  };
  const auto plans = node.subscribe<lamina_msgs::Toolpath>(names::kReplannedToolpath, 1, on_plan);
  LiveWall live(wall);
  live.say([&] { return plan != nullptr; });
  ASSERT_TRUE(plan);
  EXPECT_NE(plan->id.find("-of-" + live.printed.part.toolpath_id), std::string::npos);
  const MachineToolpath planned = fromMessage(*plan);
  EXPECT_NEAR(planned.toolpath.layers.back().z_mm, 18.0, 1e-6) << "the planned top";
  EXPECT_LT(planned.toolpath.layers.size(), wall.layers);
  const auto driven = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  publishLatched(driven, *plan);
  const auto goes_on = [&] {
    return !controller.maps.empty() && controller.maps.back().toolpath_id == plan->id;
  };
  waitUntil(goes_on);
  ASSERT_TRUE(goes_on());
  EXPECT_EQ(controller.maps.back().layer, 0U);
  EXPECT_FALSE(controller.maps.back().paths.empty()) << "it corrects at once by what it has learnt";
  EXPECT_TRUE(waitUntil([&] { return controller.isIn(StateMessage::ACTIVE); }));
  const std::size_t maps = controller.maps.size();
  driven.publish(*plan);
  ros::WallDuration(0.5).sleep();
  driven.publish(test::toolpathMessage(live.printed));
  ASSERT_TRUE(waitUntil([&] { return controller.maps.size() > maps; }));
  EXPECT_EQ(controller.maps[maps].toolpath_id, live.printed.part.toolpath_id) << "no plan is begun twice";
}

TEST(HeightController, LeavesNothingHangingWhenItIsKilled) {
  const test::ScratchFolder folder;
  const SensedWallCase wall = shortWall(3);
  test::writeBag(folder.file("wall.bag"), sensedWall(wall));
  {
    Controller killed;
    const test::BagPlayer player(folder.file("wall.bag"));
    waitUntil([&] { return !killed.layers.empty(); });
    EXPECT_EQ(killed.end(SIGKILL), -1);
  }
  lamina_msgs::SetLoop call;
  const ros::WallTime asked = ros::WallTime::now();
  EXPECT_FALSE(callService(names::kSetLoop, call));
  EXPECT_LT((ros::WallTime::now() - asked).toSec(), 5.0);
  EXPECT_EQ(replayed(folder.file("wall.bag"), wall.layers, "10").size(), wall.layers)
      << "another takes its place";
}

}  // namespace
}  // namespace lamina
