// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An emulated machine whose sensor and feeder are late, and whose sensor sits elsewhere than its description
// says, runs the programs of `lamina calibrate plan`; what is recorded as bags gives all of it back, and so
// do the services of a node that listens meanwhile.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/child_process.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "ros/node_process.hpp"
#include "ros/playback/tf_recording.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kLate = 0.08;      // s, by which the sensor's stamps are late
constexpr double kSpeedUp = 2.0;    // machine time per wall time, in which stamps are
constexpr double kDeadTime = 0.25;  // s of machine time, of the feeder
constexpr double kLag = 0.1;        // s

const std::string kPty = test::inRosHome("calibration_test");

/// Of programs and evaluation alike: what takes less time than the defaults.
const std::vector<std::pair<std::string, std::string>> kBrisk = {
    {"calibrate.bob_s", "6"},        {"calibrate.scan_mm_s", "40"}, {"calibrate.bead_mm_s", "40"},
    {"calibrate.feeder_mm_s", "40"}, {"calibrate.square_mm", "30"}, {"calibrate.feeder_gap_mm", "8"},
    {"calibrate.step_mm", "20"}};

/// The gantry with its sensor 2.5, 1.5 and 0.5 mm and 1.5 deg off.
std::string gantryWithMovedSensor() {
  std::string urdf = machineByName("cartesian_gantry").urdf;
  const std::string there = "<origin xyz=\"0.025 0 0.06\" rpy=\"3.14159265358979 0 0\"/>";
  const std::size_t at = urdf.find(there);
  EXPECT_NE(at, std::string::npos);
  return urdf.replace(at, there.size(),
                      "<origin xyz=\"0.0275 -0.0015 0.0605\" rpy=\"3.14159265358979 0 0.0261799387799\"/>");
}

/// What is recorded while a program runs.
class Recorder {
 public:
  Recorder() : tf_("/") {
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_profile =
        [this](const auto& profile) { profiles_.push_back(profile); };
    profile_ = node_.subscribe<sensor_msgs::PointCloud2>(names::kProfile, 100000, on_profile);
  }

  bool isConnected() const { return profile_.getNumPublishers() > 0 && tf_.isConnected(); }
  ros::Time lastProfile() const { return profiles_.empty() ? ros::Time() : profiles_.back()->header.stamp; }

  void write(const std::string& path) const {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    tf_.write(bag);
    for (const auto& profile : profiles_) bag.write(names::kProfile, profile->header.stamp, *profile);
  }

 private:
  ros::NodeHandle node_;
  test::TfRecording tf_;
  ros::Subscriber profile_;
  std::vector<sensor_msgs::PointCloud2ConstPtr> profiles_;
};

/// Runs the command as a person does.
void lamina(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{LAMINA_COMMAND};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProgramEnd end = runProgram({all, "", 600.0}, NoProgress());
  ASSERT_EQ(end.exit_code, 0) << end.errors;
  std::printf("%s", end.output.c_str());
}

std::vector<std::string> withBrisk(std::vector<std::string> arguments) {
  for (const auto& [key, value] : kBrisk) {
    arguments.emplace_back("--set");
    arguments.push_back(key + "=" + value);
  }
  return arguments;
}

/// Runs the program of a plan and keeps what is seen as a bag.
void recordPlan(const std::string& kind, const std::string& bag) {
  const test::ScratchFolder folder;
  const std::string program = folder.file(kind + ".gcode");
  lamina(withBrisk({"calibrate", "plan", kind, "-o", program, "--set", "program.start_code=G28", "--set",
                    "program.end_code=G4 P500"}));
  Recorder recorder;
  ASSERT_TRUE(test::waitUntil([&] { return recorder.isConnected(); }));
  const StreamSession session(StreamableProgram::fromText(kind, readFile(program)), {}, {kPty, 115200}, {});
  lamina_msgs::MachineRest rest;
  ASSERT_TRUE(test::waitUntil([&] {
    return session.isOver() && callService(names::kMachineRest, rest) && rest.response.is_resting;
  }));
  ASSERT_TRUE(test::waitUntil([&] { return recorder.lastProfile() >= rest.response.last_profile; }));
  recorder.write(bag);
}

/// A step of one of the services, with the settings of the programs.
template <class Service>
typename Service::Response step(const std::string& name, std::uint8_t step, const std::string& method = "") {
  Service call;
  call.request.step = step;
  call.request.machine = "cartesian_gantry";
  if constexpr (!std::is_same_v<Service, lamina_msgs::CalibrateFeeder>) call.request.method = method;
  for (const auto& [key, value] : kBrisk) call.request.settings.push_back(settingMessage(key, value));
  EXPECT_TRUE(callService(name, call)) << name;
  return call.response;
}

template <class Service>
void begin(const std::string& name) {
  const auto begun = step<Service>(name, Service::Request::BEGIN);
  ASSERT_EQ(begun.status.code, lamina_msgs::Status::OK + 0) << begun.status.message;
}

template <class Service>
typename Service::Response finished(const std::string& name) {
  // What the node has of the last stamps may be on its way.
  ros::WallDuration(0.3).sleep();
  auto found = step<Service>(name, Service::Request::FINISH);
  EXPECT_EQ(found.status.code, lamina_msgs::Status::OK + 0) << found.status.message;
  for (const std::string& sentence : found.report) std::printf("node: %s\n", sentence.c_str());
  return found;
}

std::vector<std::string> machineArguments(const std::string& urdf) {
  return {"_pty:=" + kPty, "_machine/urdf:=" + urdf, "_emulator/speed_up:=" + std::to_string(kSpeedUp),
          "_deposit/model:=heights", "_sensor/time_offset_s:=" + std::to_string(kSpeedUp * kLate)};
}

double angleBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.linear().transpose() * b.linear())).angle();
}

void expectTruth(const Calibration& found) {
  ASSERT_TRUE(found.time && found.pose);
  EXPECT_NEAR(found.time->offset_s, kLate, 0.001);
  const Eigen::Isometry3d truth = machineFromUrdf(gantryWithMovedSensor()).nozzle_from_sensor;
  const Eigen::Isometry3d pose = found.pose->nozzle_from_sensor;
  EXPECT_EQ(found.pose->not_found, "");
  EXPECT_LT((pose.translation() - truth.translation()).norm(), 0.05);
  EXPECT_LT(angleBetween(pose, truth), 0.05 * M_PI / 180.0);
}

Calibration ofGantry() {
  Calibration cell;
  cell.machine = "cartesian_gantry";
  return cell;
}

bool isReady() {
  return std::filesystem::exists(kPty) && ros::service::exists(names::kCalibrateFeeder, false);
}

TEST(CalibrationTest, FindsHowLateAndWhereAnEmulatedSensorSees) {
  using lamina_msgs::CalibrateSensor;
  using lamina_msgs::CalibrateTime;
  const test::ScratchFolder folder;
  writeFile(folder.file("moved.urdf"), gantryWithMovedSensor());
  const test::NodeProcess machine(LAMINA_MACHINE_NODE, machineArguments(folder.file("moved.urdf")));
  const std::string calibration_file = folder.file("known.yaml");
  writeCalibration(calibration_file, ofGantry());
  const test::NodeProcess loop(LAMINA_LOOP_NODE,
                               {"_sensor/calibration:=" + calibration_file, "_request:=active"});
  ASSERT_TRUE(test::waitUntil(isReady));
  const std::string cell = folder.file("cell.yaml");
  begin<CalibrateTime>(names::kCalibrateTime);
  recordPlan("bobbing", folder.file("bobbing.bag"));
  const auto time = finished<CalibrateTime>(names::kCalibrateTime);
  EXPECT_NEAR(time.time_offset, kLate, 0.001);
  EXPECT_GT(time.agreement, 0.99);
  EXPECT_GT(time.spread, 0.0);
  EXPECT_GE(time.scatter, 0.0);
  EXPECT_LT(std::abs(time.drift), 0.1);
  EXPECT_GT(time.profiles, 100U);
  lamina(withBrisk({"calibrate", "time", folder.file("bobbing.bag"), "-o", cell}));
  begin<CalibrateSensor>(names::kCalibrateSensor);
  recordPlan("cross", folder.file("cross.bag"));
  const auto place = finished<CalibrateSensor>(names::kCalibrateSensor);
  EXPECT_EQ(place.kept, "");
  EXPECT_TRUE(place.not_observable.empty());
  ASSERT_EQ(place.singular_values.size(), 6U);
  EXPECT_GT(place.singular_values.back(), 1.0);
  EXPECT_EQ(place.spread.size(), 6U);
  EXPECT_LT(place.rms, 0.1e-3);
  EXPECT_GT(place.points, 1000U);
  lamina(withBrisk({"calibrate", "sensor", folder.file("cross.bag"), "-o", cell}));
  expectTruth(readCalibration(cell));
  expectTruth(readCalibration(calibration_file));
  EXPECT_NEAR(toMillimetres(place.nozzle_from_sensor.position.x),
              readCalibration(calibration_file).pose->nozzle_from_sensor.translation().x(), 1e-9);
}

/// Beads with steps, deposited by a feeder that is late, seen by a sensor where its description says.
TEST(CalibrationTest, FindsHowLateAnEmulatedFeederFollows) {
  using lamina_msgs::CalibrateFeeder;
  const test::ScratchFolder folder;
  const std::string urdf = folder.file("gantry.urdf");
  writeFile(urdf, machineByName("cartesian_gantry").urdf);
  std::vector<std::string> arguments = machineArguments(urdf);
  arguments.push_back("_plant/dead_time_s:=" + std::to_string(kDeadTime));
  arguments.push_back("_plant/lag_s:=" + std::to_string(kLag));
  arguments.emplace_back("_deposit/bead_width_mm:=0.8");
  const test::NodeProcess machine(LAMINA_MACHINE_NODE, arguments);
  const std::string calibration_file = folder.file("known.yaml");
  Calibration known = ofGantry();
  known.time = CalibratedTime{kLate, 1e-4, 0.0, 0.0, {"bobbing", "2026-11-23T12:00:00Z"}};
  writeCalibration(calibration_file, known);
  const test::NodeProcess loop(LAMINA_LOOP_NODE,
                               {"_sensor/calibration:=" + calibration_file, "_request:=active"});
  ASSERT_TRUE(test::waitUntil(isReady));
  begin<CalibrateFeeder>(names::kCalibrateFeeder);
  recordPlan("feeder", folder.file("feeder.bag"));
  const auto found = finished<CalibrateFeeder>(names::kCalibrateFeeder);
  EXPECT_NEAR(found.dead_time, kDeadTime, 0.03);
  EXPECT_NEAR(found.lag, kLag, 0.03);
  EXPECT_GT(found.dead_time_spread, 0.0);
  EXPECT_GT(found.lag_spread, 0.0);
  EXPECT_NEAR(found.gain, 1.0, 0.1);
  EXPECT_LT(found.rms, 0.1);
  EXPECT_GT(found.sections, 100U);
  const Calibration kept = readCalibration(calibration_file);
  ASSERT_TRUE(kept.feeder && kept.time);
  EXPECT_NEAR(kept.feeder->dead_time_s, found.dead_time, 1e-9);
  EXPECT_EQ(kept.feeder->origin.method, "bead");
  const std::string cell = folder.file("cell.yaml");
  writeCalibration(cell, known);
  lamina(withBrisk({"calibrate", "feeder", folder.file("feeder.bag"), "-o", cell}));
  const Calibration from_bag = readCalibration(cell);
  ASSERT_TRUE(from_bag.feeder);
  EXPECT_NEAR(from_bag.feeder->dead_time_s, kDeadTime, 0.03);
  EXPECT_NEAR(from_bag.feeder->lag_s, kLag, 0.03);
}

/// What the services refuse, each by name; nothing is written, and a recording goes on.
TEST(CalibrationTest, RefusesByName) {
  using lamina_msgs::CalibrateFeeder;
  using lamina_msgs::CalibrateSensor;
  using lamina_msgs::CalibrateTime;
  const test::ScratchFolder folder;
  const std::string calibration_file = folder.file("known.yaml");
  writeCalibration(calibration_file, ofGantry());
  const std::string before = readFile(calibration_file);
  const test::NodeProcess loop(LAMINA_LOOP_NODE, {"_sensor/calibration:=" + calibration_file});
  ASSERT_TRUE(test::waitUntil([] { return ros::service::exists(names::kCalibrateFeeder, false); }));
  const auto expectRefused = [](const lamina_msgs::Status& status, std::uint8_t code, const char* word) {
    EXPECT_EQ(status.code, code) << status.message;
    EXPECT_NE(status.message.find(word), std::string::npos) << word << " in: " << status.message;
  };
  using Status = lamina_msgs::Status;
  const std::uint8_t kBegin = CalibrateTime::Request::BEGIN;
  const std::uint8_t kFinish = CalibrateTime::Request::FINISH;
  const std::uint8_t kDrop = CalibrateTime::Request::DROP;
  expectRefused(step<CalibrateTime>(names::kCalibrateTime, kFinish).status, Status::REJECTED, "BEGIN");
  expectRefused(step<CalibrateTime>(names::kCalibrateTime, 7).status, Status::INVALID_INPUT, "7");
  CalibrateSensor other;
  other.request.machine = "irb_4600";
  ASSERT_TRUE(callService(names::kCalibrateSensor, other));
  expectRefused(other.response.status, Status::INVALID_CONFIG, "irb_4600");
  expectRefused(other.response.status, Status::INVALID_CONFIG, "cartesian_gantry");
  begin<CalibrateSensor>(names::kCalibrateSensor);
  expectRefused(step<CalibrateTime>(names::kCalibrateTime, kBegin).status, Status::REJECTED,
                "calibrate_sensor");
  expectRefused(step<CalibrateFeeder>(names::kCalibrateFeeder, kDrop).status, Status::REJECTED,
                "calibrate_sensor");
  expectRefused(step<CalibrateSensor>(names::kCalibrateSensor, kFinish).status, Status::INVALID_INPUT,
                "0 clouds");
  CalibrateSensor unknown;
  unknown.request.step = kFinish;
  unknown.request.method = "pyramid";
  unknown.request.pyramid = {0.04, 0.02, 0.01};
  unknown.request.touched = {0.1, 0.1};
  unknown.request.top = {0.01};
  unknown.request.settings = {settingMessage("calibrate.bobs", "1")};
  ASSERT_TRUE(callService(names::kCalibrateSensor, unknown));
  expectRefused(unknown.response.status, Status::INVALID_CONFIG, "calibrate.bobs");
  EXPECT_EQ(step<CalibrateSensor>(names::kCalibrateSensor, kDrop).status.code, Status::OK + 0);
  EXPECT_EQ(readFile(calibration_file), before);
}

/// What would be refused when the machine has moved.
TEST(CalibrationTest, RefusesAtTheBeginning) {
  using lamina_msgs::CalibrateSensor;
  using lamina_msgs::CalibrateTime;
  const test::NodeProcess loop(LAMINA_LOOP_NODE, {"__name:=asked"});
  ASSERT_TRUE(test::waitUntil([] { return ros::service::exists(names::kCalibrateFeeder, false); }));
  const auto expectRefused = [](const lamina_msgs::Status& status, const std::string& words) {
    EXPECT_NE(status.code, lamina_msgs::Status::OK + 0);
    EXPECT_NE(status.message.find(words), std::string::npos) << words << " in: " << status.message;
  };
  for (const std::uint8_t when : {CalibrateTime::Request::BEGIN, CalibrateTime::Request::FINISH})
    expectRefused(step<CalibrateTime>(names::kCalibrateTime, when, "bob").status,
                  "expected one of bobbing, edge, overlap");
  expectRefused(
      step<CalibrateSensor>(names::kCalibrateSensor, CalibrateSensor::Request::BEGIN, "pairs").status,
      "expected one of cross");
  CalibrateSensor pyramid;
  pyramid.request.method = "pyramid";
  pyramid.request.top = {std::nan("")};
  ASSERT_TRUE(callService(names::kCalibrateSensor, pyramid));
  expectRefused(pyramid.response.status, "expected a finite one");
  CalibrateTime unknown;
  unknown.request.settings = {settingMessage("calibrate.bobs", "1")};
  ASSERT_TRUE(callService(names::kCalibrateTime, unknown));
  expectRefused(unknown.response.status, "calibrate.bobs");
  // Nothing has begun.
  begin<CalibrateSensor>(names::kCalibrateSensor);
}

/// More than is to be kept; what is under way ends when that is reported.
TEST(CalibrationTest, GivesUpARecordingThatTakesTooMuch) {
  using lamina_msgs::CalibrateTime;
  const test::NodeProcess loop(LAMINA_LOOP_NODE, {"_queue_mb:=0.01", "__name:=small"});
  ASSERT_TRUE(test::waitUntil([] { return ros::service::exists(names::kCalibrateFeeder, false); }));
  ros::NodeHandle node;
  auto profile = node.advertise<sensor_msgs::PointCloud2>(names::kProfile, 10);
  ASSERT_TRUE(test::waitUntil([&] { return profile.getNumSubscribers() > 0; }));
  begin<CalibrateTime>(names::kCalibrateTime);
  sensor_msgs::PointCloud2 cloud = toCloudMessage(std::vector<Point3>(100, Point3(0.0, 0.0, 60.0)));
  cloud.header.frame_id = names::kSensorFrame;
  cloud.header.stamp = ros::Time(1000.0);
  std::string why;
  const auto isGivenUp = [&] { return why.find("was given up") != std::string::npos; };
  test::waitUntil([&] {
    if (isGivenUp()) return true;
    for (int i = 0; i < 20; ++i) {
      cloud.header.stamp += ros::Duration(0.01);
      profile.publish(cloud);
    }
    why = step<CalibrateTime>(names::kCalibrateTime, CalibrateTime::Request::FINISH).status.message;
    return isGivenUp();
  });
  EXPECT_TRUE(isGivenUp()) << why;
  EXPECT_NE(why.find("queue_mb = 0.01"), std::string::npos) << why;
  begin<CalibrateTime>(names::kCalibrateTime);
}

/// One file serves all: what it is of has to be the machine of the node.
TEST(CalibrationTest, OfAnotherMachineIsRefusedByItsName) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("other.yaml");
  Calibration other = ofGantry();
  other.machine = "irb_4600";
  writeCalibration(file, other);
  for (const char* executable : {LAMINA_STREAMER_NODE, LAMINA_DRIVER_NODE}) {
    test::NodeProcess refused(executable, {"_sensor/calibration:=" + file, "__name:=refused"});
    EXPECT_EQ(refused.wait(), 1) << executable;
  }
}

/// A sensor whose stamps are late and that tf has 7 mm off its place, over a plate at its planned height.
TEST(CalibrationTest, ReportsToTheMonitorWhenAndFromWhereTheSensorSees) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("cell.yaml");
  Calibration cell = ofGantry();
  cell.time = CalibratedTime{kLate, 1e-4, 0.0, 0.0, {"bobbing", "2026-11-23T12:00:00Z"}};
  cell.pose = CalibratedPose{};
  cell.pose->nozzle_from_sensor = test::nozzleFromSensor();
  cell.pose->origin = {"cross", "2026-11-23T12:00:01Z"};
  writeCalibration(file, cell);
  const test::NodeProcess monitor(LAMINA_MONITOR_NODE, {"_sensor/calibration:=" + file, "__ns:=/plates",
                                                        "/tf:=/plates/tf", "/tf_static:=/plates/tf_static"});
  ros::NodeHandle node("plates");
  auto toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  auto profile = node.advertise<sensor_msgs::PointCloud2>(names::kProfile, 10000);
  auto tf = node.advertise<tf2_msgs::TFMessage>("tf", 10000);
  std::vector<lamina_msgs::LayerHeight> heights;
  const boost::function<void(const lamina_msgs::LayerHeightConstPtr&)> on_height = [&](const auto& height) {
    heights.push_back(*height);
  };
  const auto subscriber = node.subscribe<lamina_msgs::LayerHeight>(names::kLayerHeight, 10, on_height);
  lamina_msgs::Toolpath plates = test::twoPlates();
  plates.machine = "cartesian_gantry";
  publishLatched(toolpath, plates);
  bool is_measuring = false;
  const boost::function<void(const lamina_msgs::MeasuringConstPtr&)> on_measuring =
      [&](const auto& measuring) { is_measuring = measuring->toolpath_id == plates.id; };
  const auto announced = node.subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, on_measuring);
  ASSERT_TRUE(test::waitUntil(
      [&] { return is_measuring && profile.getNumSubscribers() > 0 && tf.getNumSubscribers() > 0; }));
  test::PlateScan scan;
  scan.surface = [](const Point2&) { return 0.25; };
  for (const test::ScanMessages& messages : {test::scanMessages(scan), test::liftAfter(scan)}) {
    for (const auto& transform : messages.transforms) {
      tf2_msgs::TFMessage moving;
      moving.transforms = {transform};
      tf.publish(moving);
    }
    for (sensor_msgs::PointCloud2 cloud : messages.clouds) {
      cloud.header.stamp += ros::Duration(kLate);
      profile.publish(cloud);
    }
  }
  ASSERT_TRUE(test::waitUntil([&] { return !heights.empty(); }));
  EXPECT_NEAR(toMillimetres(heights[0].mean_error), 0.05, 0.002);
  EXPECT_GT(heights[0].coverage, 0.95);
}

}  // namespace
}  // namespace lamina
