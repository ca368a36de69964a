// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes cell_controller and trajectory_driver at a simulated controller that outlives both.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <csignal>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "ros/cell/unit_of_nodes.hpp"
#include "ros/drive/two_beads.hpp"

namespace lamina {
namespace {

using test::Command;
using test::kAccepted;
using test::kHalf;
using test::NodeProcess;
using test::runs;
using test::waitUntil;

constexpr char kMachine[] = "five_axis_head_table";
constexpr unsigned kRows = 6;  // of two beads and the travel between them

/// The file of two beads, slow enough for a person, or a busy computer, to do something meanwhile: 37 s.
std::string slowBeads(double z = test::kHeight) {
  Toolpath beads = test::twoBeads(z);
  for (Path& path : beads.layers[0].paths) path.feed_mm_s = 3.0;
  std::string csv;
  writeCsv(beads, [&csv](std::string_view piece) { csv += piece; });
  return csv;
}

/// A robot's cell: simulated controller, driver and unit, of which the last two can be killed.
class RobotCell : public test::UnitOfNodes {
 public:
  /// @param host_wait_s  of the controller, for a driver that is late or dead
  explicit RobotCell(const std::string& name, double owner_grace_s = 0.0, double host_wait_s = 60.0)
      : UnitOfNodes(name, {"_executor/kind:=driver", "_executor/placement:=as_is",
                           std::string("_machine/name:=") + kMachine}),
        owner_grace_s_(owner_grace_s),
        machine(space_, kMachine) {
    // No goal may be left out: each is a piece of the way.
    const std::string controller_action = space_ + '/' + names::kFollowJointTrajectory;
    ros::param::set(controller_action + "/actionlib_client_pub_queue_size", 1000);
    ros::param::set(controller_action + "/actionlib_server_pub_queue_size", 10000);
    const std::string chosen = std::string("_machine/name:=") + kMachine;
    robot_ = start({}, LAMINA_CONTROLLER_NODE, {chosen, "_host_wait_s:=" + std::to_string(host_wait_s)});
    follower_ =
        start({}, LAMINA_PUBLISHER_NODE, {chosen, "_mode:=follow", "/tf:=tf", "/tf_static:=tf_static"});
    startDriver();
    startController();
  }
  ~RobotCell() {
    controller.reset();  // before what it commands
  }

  void startDriver(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {std::string("_machine/name:=") + kMachine,
                                          "_executor/owner:=cell_controller",
                                          "_owner/grace_s:=" + std::to_string(owner_grace_s_),
                                          "_tracking/silence_by:=stamps",
                                          "_feeder/points:=250",
                                          "_feeder/ahead_s:=4",
                                          "_start_delay_s:=0.2",
                                          "_approach/lift_mm:=5",
                                          "_approach/joint_speed:=1.0",
                                          "_lift_mm_s:=20"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    driver = start({}, LAMINA_DRIVER_NODE, arguments);
  }
  std::uint32_t enqueueReleased() {
    const std::uint32_t job = enqueue(slowBeads(), "beads.csv");
    EXPECT_NE(job, 0U) << reason;
    EXPECT_EQ(change(job, lamina_msgs::ChangeQueue::Request::RELEASE), "");
    return job;
  }
  /// Whether a job is brought to where it deposits.
  void bringToBead() {
    ASSERT_TRUE(starts());
    ASSERT_TRUE(reaches("Execute"));
    ASSERT_TRUE(waitUntil([this] { return machine.isDepositing() || status.state_name != "Execute"; }));
    ASSERT_EQ(status.state_name, "Execute") << status.stop_message;
  }
  std::string recordOf(const std::string& job) const {
    const std::string file = folder.path() + "/record.json";
    EXPECT_EQ(
        runs(std::string(LAMINA_COMMAND) + " record " + folder.path() + "/cell " + job + " --json > " + file),
        0);
    return readFile(file);
  }

 private:
  double owner_grace_s_;
  std::unique_ptr<NodeProcess> robot_;
  std::unique_ptr<NodeProcess> follower_;

 public:
  test::DriveCell machine;
  std::unique_ptr<NodeProcess> driver;
};

bool isIn(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RobotCell, RunsAJobThatIsHeldAndAbortsTheNext) {
  RobotCell cell("robot_runs");
  EXPECT_EQ(cell.enqueue("G28\nG1 X10 E1\n", "part.gcode"), 0U);
  EXPECT_TRUE(isIn(cell.reason, "line 1 is 'G28'; expected the header of a toolpath")) << cell.reason;
  EXPECT_EQ(cell.enqueue(slowBeads(-40.0), "under.csv"), 0U);
  EXPECT_TRUE(isIn(cell.reason, "collision") || isIn(cell.reason, "bed")) << cell.reason;
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  EXPECT_EQ(cell.status.lines, kRows);
  EXPECT_FALSE(cell.machine.calls(names::kAbort)) << "orders are the cell's alone";

  ASSERT_EQ(cell.command(Command::HOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Held"));
  EXPECT_TRUE(cell.machine.staysSafe());
  const Point3 held = cell.machine.tip(cell.machine.reports.back());
  EXPECT_LT(cell.status.lines_acknowledged, kRows);
  ASSERT_EQ(cell.command(Command::UNHOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(waitUntil([&] { return cell.machine.isDepositing(); }));
  // It may have gone on for a moment until it was seen.
  EXPECT_LT((cell.machine.tip(cell.machine.reports[cell.machine.lastDeposit()]) - held).norm(), kHalf);
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged == kRows; }));
  EXPECT_EQ(cell.status.parts, 1U);
  EXPECT_TRUE(cell.status.is_part_on_plate);
  EXPECT_LT((cell.machine.tip(cell.machine.reports.back()) - Point3(-kHalf, 35, test::kHeight)).norm(), 0.01);
  const std::string record = cell.recordOf("1");
  EXPECT_TRUE(isIn(record, "\"good\"") && isIn(record, "1001 held by the operator")) << record;

  EXPECT_TRUE(cell.confirmRemoval("test"));
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  ASSERT_EQ(cell.command(Command::ABORT), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Aborted"));
  EXPECT_TRUE(cell.machine.staysSafe());
  EXPECT_GT(cell.machine.tip(cell.machine.reports.back()).z(), test::kHeight + 5.0) << "the tool is lifted";
  EXPECT_TRUE(waitUntil([&] { return cell.queue.jobs.empty(); })) << "it has ended";
  EXPECT_FALSE(cell.status.resume_waits);
}

/// A driver that is started otherwise drives otherwise than the unit has checked.
TEST(RobotCell, RefusesJobsWhoseDriverHasOtherSettings) {
  RobotCell cell("robot_differs");
  const auto takes = [&cell] { return cell.enqueue(slowBeads(), "beads.csv") != 0; };
  EXPECT_TRUE(takes()) << cell.reason;
  cell.driver->end(SIGINT);
  cell.startDriver({"_joints/yaw:=held", "_clearance/spacing_mm:=3.5"});
  ASSERT_TRUE(waitUntil([&] { return !takes(); })) << "the driver has said by what it checks";
  EXPECT_TRUE(isIn(cell.reason, "joints.yaw is 'free' for the unit and 'held' for its driver"))
      << cell.reason;
  EXPECT_TRUE(isIn(cell.reason, "' for the unit and '3.5' for its driver")) << cell.reason;
  EXPECT_FALSE(isIn(cell.reason, "approach.")) << cell.reason;
  cell.driver->end(SIGINT);
  // Parameters outlive the node that was started with them.
  cell.startDriver({"_joints/yaw:=free", "_clearance/spacing_mm:=1"});
  EXPECT_TRUE(waitUntil(takes)) << cell.reason;
}

/// How often each half millimetre of the two beads was laid, by what the controller reported.
class LaidCells {
 public:
  explicit LaidCells(const test::DriveCell& machine) {
    std::optional<Point3> before;
    for (const test::DriveCell::Report& report : machine.reports) {
      if (report.process.flow == 0.0) {
        last_ = {-1, -1};
        before.reset();
        continue;
      }
      const Point3 tip = machine.tip(report);
      if (before) length_mm_ += (tip - *before).norm();
      before = tip;
      const int bead = tip.y() > 20.0 ? 1 : 0;
      const Cell cell{bead, static_cast<int>(std::floor((tip.x() + kHalf) / kCell))};
      if (cell == last_) continue;
      ++times_[cell];
      last_ = cell;
    }
  }
  /// Those of the inside of a bead that were laid that often.
  std::vector<double> laid(int bead, int times) const {
    std::vector<double> places;
    for (int i = 2; i < static_cast<int>(2.0 * kHalf / kCell) - 2; ++i) {
      const auto found = times_.find({bead, i});
      if ((found == times_.end() ? 0 : found->second) == times) places.push_back(i * kCell - kHalf);
    }
    return places;
  }

  double length() const { return length_mm_; }

  static constexpr double kCell = 0.5;  // mm

 private:
  using Cell = std::pair<int, int>;
  std::map<Cell, int> times_;
  double length_mm_ = 0.0;
  Cell last_{-1, -1};
};

/// A job was cut off on its first bead, whose driver is there again: it is resumed where the machine came to
/// rest, and each bead is laid once, but for the overlap of 2 mm that is stated.
void resumesOnTheBead(RobotCell& cell) {
  cell.acknowledgeAll();
  ASSERT_TRUE(waitUntil([&] { return cell.command(Command::CLEAR) == kAccepted; })) << cell.reason;
  ASSERT_TRUE(cell.reaches("Stopped"));
  cell.bringToIdle();
  const auto place = [&cell]() -> std::string {
    for (const lamina_msgs::ResumeStep& step : cell.status.resume_steps)
      if (step.name == "place" && step.state == lamina_msgs::ResumeStep::PERSON) return step.text;
    return "";
  };
  ASSERT_TRUE(waitUntil([&] { return !place().empty(); })) << cell.status.resume_refusal;
  EXPECT_TRUE(isIn(place(), "the nozzle came to rest on it after")) << place();
  EXPECT_TRUE(isIn(place(), "layer 0, path 0, waypoint 1")) << place();
  EXPECT_NE(cell.command(Command::START), kAccepted) << "nothing goes on by itself";
  cell.confirmed_length = {0.036, 0.039};
  EXPECT_NE(cell.command(Command::START, Command::RESUME), kAccepted);
  EXPECT_EQ(cell.reason, "confirmed_length has 2 numbers; expected one at most");
  cell.confirmed_length = {0.039};
  EXPECT_NE(cell.command(Command::START, Command::RESUME), kAccepted) << "no more than 36 mm were laid";
  EXPECT_TRUE(isIn(cell.reason, "that was confirmed begins after 39 mm of beads")) << cell.reason;
  for (const lamina_msgs::ResumeStep& step : cell.status.resume_steps)
    if (step.name == "place") cell.confirmed_length = {step.begin_length};
  const double rested = cell.machine.tip(cell.machine.reports.back()).x();
  ASSERT_LT(std::abs(rested), kHalf - 4.0);
  ASSERT_TRUE(cell.starts(Command::RESUME)) << cell.reason;
  cell.confirmed_length.clear();
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged == kRows; }));
  const LaidCells laid(cell.machine);
  EXPECT_EQ(laid.laid(0, 0), std::vector<double>()) << "left out; it rested at " << rested;
  EXPECT_EQ(laid.laid(1, 0), std::vector<double>());
  for (const double x : laid.laid(0, 2)) {
    EXPECT_GT(x, rested - 2.0 - 2.0 * LaidCells::kCell);
    EXPECT_LT(x, rested + LaidCells::kCell);
  }
  EXPECT_LE(laid.laid(0, 2).size(), 7U);
  EXPECT_NEAR(laid.length(), 4.0 * kHalf + 2.0, 1.0);
  EXPECT_EQ(laid.laid(1, 2), std::vector<double>());
  // Two beads of 40 mm; what was laid twice counts as material, and as no length.
  EXPECT_NEAR(cell.status.laid_length, 0.080, 1e-6);
  const double per_metre = 1e-6 * crossSection({1.0, test::kHeight});
  EXPECT_NEAR(cell.status.material, 0.082 * per_metre, 0.001 * per_metre);
}

TEST(RobotCell, ResumesTheJobOfAKilledDriverOnItsBead) {
  RobotCell cell("robot_killed", 0.0, 10.0);
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  ASSERT_TRUE(
      waitUntil([&] { return cell.status.lines_acknowledged > 0 && cell.status.laid_length > 0.002; }));
  EXPECT_EQ(cell.driver->end(SIGKILL), -1);
  EXPECT_TRUE(waitUntil([&] { return cell.hasAlarm(2201); }));
  ASSERT_TRUE(cell.reaches("Aborted"));
  EXPECT_EQ(cell.status.stop_reason, 2201);
  EXPECT_TRUE(isIn(cell.status.stop_message, "trajectory_driver gives no sign of life"))
      << cell.status.stop_message;
  EXPECT_TRUE(cell.status.resume_waits);
  const std::string kept = cell.folder.path() + "/kept";
  ASSERT_EQ(runs("/usr/bin/python3 -c 'import sqlite3, sys; print(sqlite3.connect(sys.argv[1])"
                 ".execute(\"SELECT taken_through, path_mm > 2 FROM progress\").fetchall())' " +
                 cell.journalFile() + " > " + kept),
            0);
  EXPECT_EQ(readFile(kept), "[(" + std::to_string(cell.status.lines_acknowledged) + ", 1)]\n");
  cell.startDriver();
  EXPECT_TRUE(waitUntil([&] { return !cell.hasAlarm(2201) || cell.alarms.alarms[0].is_gone; }));
  resumesOnTheBead(cell);
}

TEST(RobotCell, ResumesAJobWhoseUnitAndDriverWereKilled) {
  RobotCell cell("robot_group", 0.0, 10.0);
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  ASSERT_TRUE(waitUntil([&] { return cell.status.laid_length > 0.002; }));
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  EXPECT_EQ(cell.driver->end(SIGKILL), -1);
  cell.startDriver();
  cell.startController();
  EXPECT_EQ(cell.status.state_name, "Aborted");
  EXPECT_TRUE(cell.status.resume_waits);
  resumesOnTheBead(cell);
}

TEST(RobotCell, DiscardsAJobThatWasCutOff) {
  RobotCell cell("robot_discarded", 0.0, 10.0);
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  ASSERT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged > 0; }));
  EXPECT_EQ(cell.driver->end(SIGKILL), -1);
  ASSERT_TRUE(cell.reaches("Aborted"));
  const unsigned reached = cell.status.lines_acknowledged;
  cell.startDriver();
  EXPECT_TRUE(waitUntil([&] { return !cell.hasAlarm(2201) || cell.alarms.alarms[0].is_gone; }));
  cell.acknowledgeAll();
  ASSERT_TRUE(waitUntil([&] { return cell.command(Command::CLEAR) == kAccepted; })) << cell.reason;
  ASSERT_TRUE(cell.reaches("Stopped"));
  cell.bringToIdle();
  EXPECT_NE(cell.command(Command::START), kAccepted);
  EXPECT_TRUE(isIn(cell.reason, "was cut off after waypoint " + std::to_string(reached))) << cell.reason;
  EXPECT_TRUE(cell.confirmRemoval("test"));
  cell.enqueueReleased();
  ASSERT_TRUE(cell.starts(Command::DISCARD));
  ASSERT_TRUE(cell.reaches("Execute"));
  ASSERT_EQ(cell.command(Command::STOP), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Stopped"));
  EXPECT_TRUE(cell.machine.staysSafe());
}

// Nobody would see what the robot does, or stop it.
TEST(RobotCell, FindsItsJobHeldWhenItWasGoneForLong) {
  RobotCell cell("robot_alone", 5.0);
  cell.enqueueReleased();
  cell.bringToIdle();
  cell.bringToBead();
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  EXPECT_TRUE(cell.machine.comesTo("Held")) << cell.machine.state;
  EXPECT_TRUE(cell.machine.staysSafe());
  cell.startController();
  EXPECT_EQ(cell.status.state_name, "Held");
  ASSERT_EQ(cell.command(Command::UNHOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged == kRows; }));
}

TEST(RobotCell, IsLaunched) {
  std::string refusal;
  EXPECT_TRUE(waitUntil([&refusal] {
    lamina_msgs::PackmlCommand call;
    call.request.expected_sequence = -1;
    call.request.command = Command::RESET;
    if (!callService("/launched_robot/packml_command", call)) return false;
    call.request.command = Command::START;
    if (!callService("/launched_robot/packml_command", call)) return false;
    refusal = call.response.message;
    return isIn(refusal, "no job of the queue") && !isIn(refusal, "no sign of life");
  })) << refusal;
}

}  // namespace
}  // namespace lamina
