// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/server/simple_action_server.h>
#include <gtest/gtest.h>

#include "correction_messages.hpp"
#include "follow_joint_trajectory.hpp"
#include "lamina/control/correction_map.hpp"
#include "ros/drive/drive_cell.hpp"
#include "ros/drive/two_beads.hpp"
#include "ros/node_process.hpp"
#include "ros/test_clock.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using test::Deposit;
using test::depositOf;
using test::DriveCell;
using test::isOnBead;
using test::kHalf;
using test::kHeight;
using test::kLag;
using test::straight;
using test::twoBeads;
using test::waitUntil;

constexpr double kUnderBed = -40.0;  // mm
constexpr double kLiftSpeed = 20.0;  // mm/s, of all drivers

void expectDriven(DriveCell& cell) {
  ASSERT_TRUE(cell.ends());
  const auto result = cell.result();
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_GT(result.duration, 3.5);  // 110 mm at 30 mm/s
  EXPECT_GT(result.worst_tip_error, 0.0);
  EXPECT_LT(result.worst_tip_error, 1e-3);
  EXPECT_LE(result.rms_tip_error, result.worst_tip_error);
  EXPECT_EQ(result.starvations, 0U);
  EXPECT_TRUE(cell.comesTo("Complete")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  EXPECT_LT((cell.tip(cell.reports.back()) - Point3(-kHalf, 35, kHeight)).norm(), 0.01);
  EXPECT_TRUE(waitUntil([&] { return cell.tracking.worst_tip_error == result.worst_tip_error; }));
  EXPECT_LE(cell.tracking.tip_error, cell.tracking.worst_tip_error);
  EXPECT_GE(cell.tracking.least_queued, 0.0);
  EXPECT_TRUE(waitUntil([&] { return cell.processes > 3U && cell.grown > 0U; }));
}

/// The tool is well above the bead, and was never lifted faster than asked; at times as fast.
void expectLifted(const DriveCell& cell) {
  EXPECT_GT(cell.tip(cell.reports.back()).z(), kHeight + 9.0);
  double fastest = 0.0;
  for (std::size_t i = cell.lastDeposit() + 1; i < cell.reports.size(); ++i) {
    const double rise = cell.tip(cell.reports[i]).z() - cell.tip(cell.reports[i - 1]).z();
    const ros::Duration passed =
        cell.reports[i].process.header.stamp - cell.reports[i - 1].process.header.stamp;
    fastest = std::max(fastest, rise / passed.toSec());
  }
  EXPECT_NEAR(fastest, kLiftSpeed, 0.1 * kLiftSpeed);
}

class DrivenMachine : public testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  DrivenMachine() : cell(GetParam().first, GetParam().second) {}

  void awaitBead() {
    ASSERT_TRUE(waitUntil([&] { return cell.isDepositing() || cell.isDone(); }));
    ASSERT_FALSE(cell.isDone()) << cell.result().status.message;
  }
  void awaitTravel() {
    awaitBead();
    ASSERT_TRUE(waitUntil([&] { return !cell.isDepositing(); }));
  }

  DriveCell cell;
};

TEST_P(DrivenMachine, DrivesAPartToItsEndAndDepositsOnBeadsOnly) {
  cell.drive(twoBeads());
  expectDriven(cell);
  std::size_t deposited = 0;
  for (const auto& report : cell.reports) {
    const Point3 tip = cell.tip(report);
    if (report.process.flow > 0.0) {
      ++deposited;
      EXPECT_TRUE(isOnBead(tip, kLag)) << tip.transpose();
    } else {
      EXPECT_FALSE(isOnBead(tip, -2.0)) << tip.transpose();
    }
  }
  EXPECT_GT(deposited, 30U);
}

TEST_P(DrivenMachine, ShowsTheWholePartToWhoSubscribesOnceItIsDone) {
  cell.drive(twoBeads());
  expectDriven(cell);
  double shown_m = 0.0;
  const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> on_part =
      [&](const auto& message) {
        for (const auto& marker : message->markers)
          for (std::size_t i = 1; i < marker.points.size(); i += 2)
            shown_m += std::abs(marker.points[i].x - marker.points[i - 1].x);
      };
  ros::NodeHandle node(GetParam().first);
  const ros::Subscriber late =
      node.subscribe<visualization_msgs::MarkerArray>(names::kPartMarkers, 10, on_part);
  EXPECT_TRUE(waitUntil([&] { return shown_m > 0.0; }));
  EXPECT_NEAR(shown_m, 2.0 * 2.0 * kHalf / 1000.0, 1e-6);
}

TEST_P(DrivenMachine, PausesOnBeadAndTravelAndCompletesOnceResumed) {
  cell.drive(twoBeads());
  EXPECT_FALSE(cell.calls("pause")) << "on the way to the start";
  awaitBead();
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(cell.calls("pause"));
    ASSERT_TRUE(cell.comesTo("Held")) << cell.state;
    EXPECT_TRUE(cell.staysSafe());
    ASSERT_TRUE(cell.calls("resume"));
    EXPECT_FALSE(cell.calls("resume"));
    if (i == 0) awaitTravel();
  }
  expectDriven(cell);
}

TEST_P(DrivenMachine, GoesOnAtAShareOfTheSpeedAndItsFlow) {
  cell.setSpeed(0.5);
  cell.setSpeed(2.0);  // is not used
  cell.drive(twoBeads());
  awaitTravel();
  const std::size_t second = cell.reports.size();
  cell.setSpeed(1.0);
  expectDriven(cell);
  const Deposit slow = depositOf(cell, 0, second);
  const Deposit fast = depositOf(cell, second, cell.reports.size());
  EXPECT_NEAR(slow.fastest_mm_s, 15.0, 0.5);
  EXPECT_NEAR(fast.fastest_mm_s, 30.0, 1.0);
  EXPECT_NEAR(slow.greatest_flow, 0.5 * fast.greatest_flow, 0.02 * fast.greatest_flow);
}

TEST_P(DrivenMachine, AbortsOnABeadAndLiftsTheTool) {
  cell.drive(twoBeads());
  awaitBead();
  ASSERT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::CANCELLED + 0);
  EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  expectLifted(cell);
  EXPECT_FALSE(cell.calls("abort"));
}

TEST_P(DrivenMachine, AbortsWhereItIsHeldAndLiftsTheTool) {
  cell.drive(twoBeads());
  awaitBead();
  ASSERT_TRUE(cell.calls("pause"));
  ASSERT_TRUE(cell.comesTo("Held")) << cell.state;
  const ros::Time held = cell.reports.back().process.header.stamp;
  const ros::Duration longer_than_silence(1.2);  // for which a controller may be silent
  ASSERT_TRUE(
      waitUntil([&] { return cell.reports.back().process.header.stamp > held + longer_than_silence; }));
  ASSERT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::CANCELLED + 0) << cell.result().status.message;
  EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  expectLifted(cell);
}

TEST_P(DrivenMachine, AbortsOnATravelAndOnTheWayToTheStart) {
  cell.drive(twoBeads());
  awaitTravel();
  ASSERT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  ASSERT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.comesTo("Starting")) << cell.state;
  ASSERT_TRUE(waitUntil([&] { return cell.calls("abort"); }));
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::CANCELLED + 0);
  ASSERT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
}

TEST_P(DrivenMachine, RefusesWhatItCannotDriveAndNothingMoves) {
  ASSERT_TRUE(waitUntil([&] { return cell.reports.size() > 5; }));
  const std::size_t before = cell.reports.size() - 1;
  const auto refusal = [&] {
    EXPECT_TRUE(cell.ends());
    EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
    return cell.result().status;
  };
  cell.drive(twoBeads(0.7), "irb_4400");
  EXPECT_EQ(refusal().code, Status::INVALID_INPUT + 0);
  Toolpath far = twoBeads();
  far.layers[0].paths[1].points[1].x() = far.layers[0].paths[2].points[0].x() = 9000.0;
  cell.drive(far);
  const Status reach = refusal();
  EXPECT_EQ(reach.code, Status::UNREACHABLE + 0);
  EXPECT_NE(reach.message.find("path 1, waypoint 1"), std::string::npos) << reach.message;
  cell.drive(twoBeads(kUnderBed));
  const Status collision = refusal();
  EXPECT_EQ(collision.code, Status::UNREACHABLE + 0);
  EXPECT_NE(collision.message.find("'nozzle'"), std::string::npos) << collision.message;
  EXPECT_TRUE(waitUntil([&] { return cell.findings > 1; }));
  EXPECT_TRUE(cell.staysSafe());
  EXPECT_LT((cell.reports.back().joints - cell.reports[before].joints).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(TrajectoryDriver, DrivenMachine,
                         testing::Values(std::pair{"arm", "irb_4600"},
                                         std::pair{"table", "five_axis_head_table"}),
                         [](const auto& machine) { return std::string(machine.param.first); });

/// It waits for longer than a controller may be silent, which reports nothing at rest; a pause meanwhile does
/// not let it into the layer; a plan that begins elsewhere is refused and reported; an abort lifts the tool.
TEST(TrajectoryDriver, StaysInFrontOfALayerWithoutAMapAndLiftsTheToolFromThere) {
  DriveCell cell("waiting", "five_axis_head_table");
  ros::NodeHandle node("waiting");
  auto plans = node.advertise<lamina_msgs::Toolpath>(names::kReplannedToolpath, 1, true);
  std::vector<lamina_msgs::AppliedCorrection> applied;
  const boost::function<void(const lamina_msgs::AppliedCorrectionConstPtr&)> on_applied =
      [&](const auto& message) { applied.push_back(*message); };
  const auto uses =
      node.subscribe<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 100, on_applied);
  Toolpath part = twoBeads();
  const Point3 end(-kHalf, 35, kHeight);
  const Point3 above(-kHalf, 35, 2.0 * kHeight);
  part.layers[0].paths.push_back(straight(PathRole::Travel, end, above));
  part.layers.push_back({above.z(), kHeight, {straight(PathRole::OuterWall, above, {kHalf, 35, above.z()})}});
  cell.drive(part);
  const auto stays = [&](double time_s) {
    const auto now = [&] { return cell.reports.back().process.header.stamp; };
    const ros::Time from = now();
    return waitUntil([&] { return now() > from + ros::Duration(time_s); }) &&
           cell.reports[cell.lastDeposit()].process.header.stamp < from;
  };
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing() || cell.isDone(); }));
  ASSERT_TRUE(waitUntil([&] {
    return cell.isDone() || (!cell.isDepositing() && (cell.tip(cell.reports.back()) - above).norm() < 1e-3);
  }));
  ASSERT_FALSE(cell.isDone()) << cell.result().status.message;
  EXPECT_TRUE(stays(7.0)) << "longer than the controller may be silent";
  ASSERT_TRUE(cell.calls("pause"));
  ASSERT_TRUE(cell.comesTo("Held")) << cell.state;
  ASSERT_TRUE(cell.calls("resume"));
  ASSERT_TRUE(cell.comesTo("Execute")) << cell.state;
  EXPECT_TRUE(stays(3.0)) << "a pause lets it into no layer";
  lamina_msgs::Toolpath plan;
  plan.id = "plan-from-0-of-" + toolpathId(part);
  publishLatched(plans, plan);
  ASSERT_TRUE(waitUntil([&] { return !applied.empty(); }));
  EXPECT_EQ(applied.back().toolpath_id, plan.id);
  EXPECT_NE(applied.back().reason.find("held in front of layer 1"), std::string::npos)
      << applied.back().reason;
  ASSERT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::CANCELLED + 0) << cell.result().status.message;
  EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  EXPECT_GT(cell.tip(cell.reports.back()).z(), above.z() + 9.0) << "the tool is off the part";
}

TEST(TrajectoryDriver, AbortsAndLeavesTheMachineSafeWhenAskedToStop) {
  for (const int signal : {SIGINT, SIGTERM}) {
    DriveCell cell("driverless", "five_axis_head_table");
    test::NodeProcess driver(
        LAMINA_DRIVER_NODE,
        {"__ns:=/driverless", "_machine/name:=five_axis_head_table", "_feeder/points:=250",
         "_feeder/ahead_s:=4.0", "_feeder/reaction_s:=0.5", "_start_delay_s:=0.2", "_lift_mm_s:=20",
         "_tracking/silence_by:=stamps", "_approach/joint_speed:=1.0"});
    cell.drive(twoBeads());
    ASSERT_TRUE(waitUntil([&] { return cell.isDepositing(); }));
    EXPECT_EQ(driver.end(signal), 0);
    EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
    EXPECT_TRUE(cell.staysSafe());
    EXPECT_GT(cell.tip(cell.reports.back()).z(), kHeight + 9.0) << "it was lifted before the node left";
  }
}

/// A controller that does as it is reported by the test.
class FaultyController {
 public:
  using Server = actionlib::SimpleActionServer<follow::Action>;

  FaultyController(const KinematicModel& model, const std::string& space)
      : node_(space),
        states_(node_.advertise<sensor_msgs::JointState>(names::kJointStates, 10)),
        server_(node_, names::kFollowJointTrajectory, false) {
    for (const DrivenJoint& joint : model.joints()) {
      const bool is_linear = joint.kind == JointKind::Linear;
      const double at = is_linear ? 0.5 * (joint.low + joint.high) : std::clamp(0.0, joint.low, joint.high);
      state_.name.push_back(joint.name);
      state_.position.push_back(is_linear ? at / 1000.0 : at);
    }
    const boost::function<void(const ros::TimerEvent&)> tell = [this](const ros::TimerEvent&) {
      if (reports_joints) states_.publish(state_);
    };
    timer_ = node_.createTimer(ros::Duration(0.02), tell);
    server_.registerGoalCallback([this] {
      begin = server_.acceptNewGoal()->trajectory.header.stamp;
      if (!refuses) return;
      follow::Result result;
      result.error_string = "drives are off";
      server_.setAborted(result);
    });
    server_.registerPreemptCallback([this] {
      was_cancelled = !server_.isNewGoalAvailable();
      if (was_cancelled) server_.setPreempted();
    });
    server_.start();
  }

  bool reports_joints = false;
  bool refuses = true;
  bool was_cancelled = false;
  ros::Time begin;  ///< of the last goal's motion

 private:
  ros::NodeHandle node_;
  sensor_msgs::JointState state_;
  ros::Publisher states_;
  ros::Timer timer_;
  Server server_;
};

/// Eight beads side by side in one layer.
Toolpath eightBeads() {
  ToolpathLayer layer{kHeight, kHeight, {}};
  for (int bead = 0; bead < 8; ++bead) {
    const double y = 5.0 * bead;
    if (bead > 0)
      layer.paths.push_back(
          straight(PathRole::Travel, layer.paths.back().points.back(), {-kHalf, y, kHeight}));
    layer.paths.push_back(straight(PathRole::OuterWall, {-kHalf, y, kHeight}, {kHalf, y, kHeight}));
  }
  return {"eight beads", {layer}};
}

CorrectionMap evenMap(const Toolpath& part, double amount, std::uint64_t sequence, std::size_t layer = 0) {
  const LayerCells cells = layerCells(part.layers[layer], layer, 0.5);
  return correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, toolpathId(part),
                       sequence);
}

/// A cell whose driver hears of correction maps, and says by which it has laid.
class CorrectedCell : public DriveCell {
 public:
  CorrectedCell() : DriveCell("/trimmed", "five_axis_head_table"), node_("/trimmed") {
    const boost::function<void(const lamina_msgs::AppliedCorrectionConstPtr&)> on_applied =
        [this](const auto& message) { applied.push_back(*message); };
    correction = node_.advertise<lamina_msgs::CorrectionMap>(names::kCorrection, 10, true);
    uses_ = node_.subscribe<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 100, on_applied);
  }
  /// Drives a part by a map; returns once it deposits.
  bool drivesBy(const lamina_msgs::CorrectionMap& map, const Toolpath& part) {
    const auto isHeard = [&] { return correction.getNumSubscribers() > 0 && uses_.getNumPublishers() > 0; };
    if (!waitUntil(isHeard)) return false;
    publishLatched(correction, map);
    drive(part);
    return waitUntil([&] { return isDepositing() || isDone(); });
  }

  ros::Publisher correction;
  std::vector<lamina_msgs::AppliedCorrection> applied;

 private:
  ros::NodeHandle node_;
  ros::Subscriber uses_;
};

/// A map that comes while the first bead is deposited holds for what is not handed over by then: the last
/// one.
TEST(TrajectoryDriver, TrimsALayerThatIsUnderWay) {
  const Toolpath part = eightBeads();
  CorrectedCell cell;
  ASSERT_TRUE(cell.drivesBy(toMessage(evenMap(part, 0.2, 1)), part));
  publishLatched(cell.correction, toMessage(evenMap(part, -0.1, 2)));
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  const double planned = 1e-9 * 30.0 * crossSection(Bead{1.0, kHeight});  // m^3/s
  std::size_t first = 0;
  std::size_t last = 0;
  for (const auto& report : cell.reports) {
    const Point3 tip = cell.tip(report);
    if (!(report.process.flow > 0.0) || std::abs(tip.x()) > 10.0) continue;
    const bool is_first = std::abs(tip.y()) < kLag;
    const bool is_last = std::abs(tip.y() - 35.0) < kLag;
    if (is_first) {
      EXPECT_NEAR(report.process.flow / planned, 1.2, 0.02) << tip.transpose();
    }
    if (is_last) {
      EXPECT_NEAR(report.process.flow / planned, 0.9, 0.02) << tip.transpose();
    }
    first += is_first ? 1 : 0;
    last += is_last ? 1 : 0;
  }
  EXPECT_GT(first, 5U);
  EXPECT_GT(last, 5U);
  ASSERT_EQ(cell.applied.size(), 1U) << "of the map that the layer begins with";
  EXPECT_EQ(cell.applied[0].digest, toMessage(evenMap(part, 0.2, 1)).digest);
}

/// The map of the second layer does not come: it is laid by its coasting map.
TEST(TrajectoryDriver, DrivesALayerWithoutAMapByItsCoastingMap) {
  Toolpath part = twoBeads();
  const Point3 end(-kHalf, 35, kHeight);
  const Point3 above(-kHalf, 35, 2.0 * kHeight);
  part.layers[0].paths.push_back(straight(PathRole::Travel, end, above));
  part.layers.push_back({above.z(), kHeight, {straight(PathRole::OuterWall, above, {kHalf, 35, above.z()})}});
  CorrectedCell cell;
  ASSERT_TRUE(cell.drivesBy(toMessage(evenMap(part, 0.2, 1)), part));
  const lamina_msgs::CorrectionMap coasting = toMessage(evenMap(part, -0.2, 0, 1));
  publishLatched(cell.correction, coasting);
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  const double planned = 1e-9 * 30.0 * crossSection(Bead{1.0, kHeight});  // m^3/s
  std::size_t reports[2] = {0, 0};                                        // by layer
  for (const auto& report : cell.reports) {
    const Point3 tip = cell.tip(report);
    const std::size_t layer = tip.z() > 1.5 * kHeight ? 1 : 0;
    // From 1.2 to 0.8 by 0.5 a second: 24 mm at 30 mm/s, from x = -20 mm on.
    const bool is_even = layer == 1 ? tip.x() > 8.0 && tip.x() < 16.0 : std::abs(tip.x()) < 10.0;
    if (!(report.process.flow > 0.0) || !is_even) continue;
    ++reports[layer];
    EXPECT_NEAR(report.process.flow / planned, layer == 1 ? 0.8 : 1.2, 0.02) << tip.transpose();
  }
  EXPECT_GT(reports[0], 10U);
  EXPECT_GT(reports[1], 5U);
  ASSERT_TRUE(waitUntil([&] { return cell.applied.size() == 2; })) << cell.applied.size();
  EXPECT_EQ(cell.applied[0].digest, toMessage(evenMap(part, 0.2, 1)).digest);
  EXPECT_EQ(cell.applied[1].layer, 1U);
  EXPECT_EQ(cell.applied[1].digest, coasting.digest);
  EXPECT_GE(cell.applied[1].waited, 2.0) << "loop.wait_s";
  EXPECT_EQ(cell.applied[1].reason, "");
}

TEST(TrajectoryDriver, EndsInAbortedIfTheControllerFails) {
  DriveCell cell("faulty", "five_axis_head_table");
  const auto ended = [&] {
    EXPECT_TRUE(cell.ends());
    EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
    return cell.result().status;
  };
  const auto failure = [&] {
    cell.drive(twoBeads(kUnderBed));  // which is not looked for here
    return ended();
  };
  cell.ask("0000000000000000");
  EXPECT_EQ(ended().code, Status::INVALID_INPUT + 0);
  EXPECT_EQ(failure().code, Status::TIMED_OUT + 0) << "no controller";
  FaultyController controller(*cell.model, "faulty");
  Status blind;
  ASSERT_TRUE(waitUntil([&] {
    blind = failure();
    return blind.message.find("no controller answers") == std::string::npos;
  })) << blind.message;
  EXPECT_EQ(blind.code, Status::TIMED_OUT + 0);
  EXPECT_NE(blind.message.find("joint_states"), std::string::npos) << blind.message;
  controller.reports_joints = true;
  const ros::Time before = ros::Time::now();
  const Status refused = failure();
  EXPECT_EQ(refused.code, Status::DEVICE_ERROR + 0);
  EXPECT_NE(refused.message.find("drives are off"), std::string::npos) << refused.message;
  EXPECT_GE((controller.begin - before).toSec(), 3.0) << "start_delay_s";
  controller.refuses = false;
  EXPECT_EQ(failure().code, Status::DISCONNECTED + 0) << "silent";
  EXPECT_TRUE(waitUntil([&] { return controller.was_cancelled; }));
}

TEST(TrajectoryDriver, EndsInAbortedIfRosTimeGoesBack) {
  test::TestClock clock("/clocked");
  DriveCell cell("clocked", "five_axis_head_table");
  FaultyController controller(*cell.model, "clocked");
  controller.reports_joints = true;
  controller.refuses = false;
  const test::NodeProcess driver(
      LAMINA_DRIVER_NODE,
      clock.followedBy({"_machine/name:=five_axis_head_table", "_check_clearance:=false",
                        "_tracking/silence_s:=60", "_approach/lift_mm:=5", "_approach/joint_speed:=1.0"}));
  cell.drive(twoBeads(kUnderBed));
  ASSERT_TRUE(waitUntil([&] { return !controller.begin.isZero() || cell.isDone(); }));
  ASSERT_FALSE(cell.isDone()) << cell.result().status.message;
  clock.goBack(10.0);
  ASSERT_TRUE(cell.ends());
  const Status status = cell.result().status;
  EXPECT_EQ(status.code, Status::DEVICE_ERROR + 0);
  EXPECT_NE(status.message.find("ROS time went back by"), std::string::npos) << status.message;
  EXPECT_TRUE(cell.comesTo("Aborted")) << cell.state;
  EXPECT_TRUE(waitUntil([&] { return controller.was_cancelled; }));
}

}  // namespace
}  // namespace lamina
