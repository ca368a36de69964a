// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/nozzle_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/trajectory/nozzle_csv.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "support/joint_paths.hpp"
#include "support/random_toolpath.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::PlanarArm;
using test::TiltingGantry;

/// Joint accelerations so great that the path's own limits govern.
TimingSettings pathLimits() {
  TimingSettings settings;
  settings.motion.acceleration_mm_s2 = 500.0;
  settings.motion.travel_acceleration_mm_s2 = 1000.0;
  settings.trajectory.joint_ramp_s = 1e-3;
  return settings;
}

Toolpath straightBead(const Point3& from, const Point3& to) {
  return {"line", {{0.2, 0.2, {test::straightPath(from, to)}}}};
}

std::vector<NozzleState> statesOf(const JointTrajectory& trajectory, const KinematicModel& model,
                                  double rate_hz) {
  return nozzleStates(evenTimes(0.0, trajectory.duration(), 1.0 / rate_hz),
                      [&](double time_s) { return nozzleState(trajectory.at(time_s), model); });
}

TEST(NozzleMotion, AStraightBeadHasItsFeedForATwist) {
  // 30 mm/s along (0.6, 0.8, 0), reached within 0.06 s and 0.9 mm at 500 mm/s².
  const Point3 along(0.6, 0.8, 0.0);
  const Point3 from(5.0, -7.0, 0.2);
  const Toolpath bead = straightBead(from, from + 60.0 * along);
  const TiltingGantry gantry;
  const TimedPath timed(bead, uprightPath(bead, gantry), gantry, pathLimits());
  const std::vector<NozzleState> states = statesOf(timed, gantry, 100.0);
  ASSERT_EQ(states.size(), 207U);  // 2.06 s
  for (std::size_t i = 0; i < states.size(); ++i) {
    const NozzleState& state = states[i];
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(state.time_s, t, 1e-9);
    const double speed = std::min({30.0, 500.0 * t, 500.0 * (2.06 - t)});
    const double left_s = 2.06 - t;
    const double way = t < 0.06        ? 250.0 * t * t
                       : left_s < 0.06 ? 60.0 - 250.0 * left_s * left_s
                                       : 30.0 * (t - 0.03);
    EXPECT_LT((state.tip - (from + way * along)).norm(), 1e-6) << i;
    EXPECT_LT((state.velocity - speed * along).norm(), 1e-6) << i;
    EXPECT_LT(state.turn.norm(), 1e-12);
    EXPECT_LT(state.orientation.angularDistance(nozzleDown()), 1e-9);
    EXPECT_NEAR(state.process.flow_mm3_s, crossSection({0.4, 0.2}) * speed, 1e-6);
  }
}

TEST(NozzleMotion, AToolThatTurnsHasItsTurnForATwist) {
  // Tilted by 0.01 rad per mm about x at 30 mm/s, the tip on the axis of the tilt.
  const Toolpath bead = straightBead({0, 0, 0.2}, {60, 0, 0.2});
  const TiltingGantry gantry(0.0);
  const JointPath joints =
      test::jointPathBy(bead, [&](const Point3& tip) { return gantry.valuesAt(tip, 0.01 * tip.x()); });
  const TimedPath timed(bead, joints, gantry, pathLimits());
  for (const double t : {0.1, 0.7, 1.5, 1.9}) {
    const NozzleState state = nozzleState(timed.at(t), gantry);
    const double tilt = 0.01 * 30.0 * (t - 0.03);
    EXPECT_LT((state.turn - Point3(0.3, 0.0, 0.0)).norm(), 1e-9);
    EXPECT_LT((state.velocity - Point3(30.0, 0.0, 0.0)).norm(), 1e-6);
    EXPECT_LT((state.orientation * Point3::UnitZ() - Point3(0, std::sin(tilt), -std::cos(tilt))).norm(),
              1e-9);
  }
}

TEST(NozzleMotion, ATurnInPlaceMovesNoTip) {
  Toolpath toolpath = straightBead({0, 0, 0}, {30, 0, 0});
  toolpath.layers[0].paths.push_back(test::straightPath({30, 0, 0}, {60, 0, 0}));
  const TiltingGantry gantry(0.0);
  JointPath path = uprightPath(toolpath, gantry);
  path.values[2][3] = path.values[3][3] = 1.5;
  const TimedPath timed(toolpath, path, gantry, pathLimits());
  const NozzleState state = nozzleState(timed.at(1.06 + 0.25), gantry);
  EXPECT_LT((state.tip - Point3(30, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(state.velocity.norm(), 0.0);
  EXPECT_NEAR(state.turn.x(), 3.0, 1e-9);  // rad/s, as fast as the joint goes
  EXPECT_EQ(state.process.flow_mm3_s, 0.0);
}

TEST(NozzleMotion, OfAnArmIsThatOfItsTip) {
  const PlanarArm arm;
  const Toolpath bead = straightBead({250, -150, 10}, {250, 150, 10});
  const JointPath joints = test::jointPathBy(bead, [&](const Point3& tip) { return arm.valuesAt(tip); });
  TimingSettings settings = pathLimits();
  settings.trajectory.joint_ramp_s = 0.2;
  settings.trajectory.blend_tolerance_mm = 0.0;
  const TimedPath timed(bead, joints, arm, settings);
  for (const NozzleState& state : statesOf(timed, arm, 50.0)) {
    EXPECT_NEAR(state.tip.x(), 250.0, settings.trajectory.line_tolerance_mm);
    const JointState joint = timed.at(state.time_s);
    EXPECT_NEAR(state.velocity.y(), joint.tip_speed_mm_s, 0.3);
    EXPECT_NEAR(state.turn.z(), joint.velocity[0] + joint.velocity[1], 1e-12);
  }
}

TEST(NozzleMotion, TwistsAreHowPosesChange) {
  EXPECT_TRUE(rc::check("differences of poses, at any rate, with and without jerk limited", [] {
    Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    toolpath.layers.resize(1);
    toolpath.layers[0].paths.resize(std::min<std::size_t>(toolpath.layers[0].paths.size(), 3));
    TimingSettings settings;
    settings.trajectory.jerk_ramp_s = *rc::gen::element(0.0, 0.01);
    const TiltingGantry gantry;
    const JointPath joints = test::jointPathBy(toolpath, [&](const Point3& tip) {
      return gantry.valuesAt(tip, 0.8 * std::sin(0.2 * tip.x()) * std::cos(0.1 * tip.y()));
    });
    const TimedPath timed(toolpath, joints, gantry, settings);
    const std::vector<NozzleState> states = statesOf(timed, gantry, *rc::gen::element(50.0, 125.0, 500.0));
    RC_ASSERT(states.front().time_s == 0.0 && states.back().time_s == timed.duration());
    RC_ASSERT(states.front().velocity.norm() < 1e-9 && states.back().velocity.norm() < 1e-6);
    const double h = 1e-5;
    for (std::size_t i = 1; i + 1 < states.size(); ++i) {
      const NozzleState& state = states[i];
      RC_ASSERT(state.orientation.dot(states[i - 1].orientation) >= 0.0);
      const NozzleState before = nozzleState(timed.at(state.time_s - h), gantry);
      const NozzleState after = nozzleState(timed.at(state.time_s + h), gantry);
      // Accelerations of the tip are below 20 m/s², of the tilt below 10 rad/s².
      RC_ASSERT(((after.tip - before.tip) / (2 * h) - state.velocity).norm() < 0.2);
      const Eigen::AngleAxisd turned(after.orientation * before.orientation.conjugate());
      const double angle = std::remainder(turned.angle(), 2.0 * M_PI);
      RC_ASSERT((angle / (2 * h) * turned.axis() - state.turn).norm() < 1e-3);
    }
  }));
}

TEST(NozzleMotion, OfAPlayedToolpathGoesAlongItsMotions) {
  // The part stands turned by a quarter about z: its x is the bed's y.
  Toolpath square = test::twoLayers();
  square.layers[0].paths[0].values = {{"wire_speed_mm_s", 60.0}};
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  bed_from_part.translation() = Point3(100, 50, 0);
  bed_from_part.linear() = Eigen::AngleAxisd(0.5 * M_PI, Point3::UnitZ()).toRotationMatrix();
  MotionLimits limits;
  limits.acceleration_mm_s2 = 1000.0;
  limits.junction_deviation_mm = 1e-9;  // stops at corners: 1/3 + 0.03 s a side
  ToolpathPlayer player(square, limits);
  const double side_s = 10.0 / 30.0 + 0.03;
  const std::vector<Point3> ways = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
  for (std::size_t side = 0; side < 4; ++side) {
    const double t = (static_cast<double>(side) + 0.5) * side_s;
    const NozzleState state = nozzleState(player.at(t), square, bed_from_part);
    EXPECT_LT((state.velocity - 30.0 * ways[side]).norm(), 1e-3) << side;
    EXPECT_NEAR(state.process.flow_mm3_s, 30.0 * crossSection({0.4, 0.2}), 1e-6);
    EXPECT_NEAR(state.process.levels[ProcessLevel::WireSpeed], 60.0, 1e-6);
    EXPECT_LT((state.orientation * Point3::UnitZ() + Point3::UnitZ()).norm(), 1e-9);
  }
  EXPECT_LT((nozzleState(player.at(0.5 * side_s), square, bed_from_part).tip - Point3(100, 55, 0.2)).norm(),
            1e-3);
  const NozzleState climbing = nozzleState(player.at(4.0 * side_s + 1e-3), square, bed_from_part);
  EXPECT_GT(climbing.velocity.z(), 0.0);
  EXPECT_EQ(climbing.process.flow_mm3_s, 0.0);
}

TEST(NozzleMotion, EvenTimesEndAtTheEnd) {
  EXPECT_EQ(evenTimes(1.0, 2.0, 0.5), (std::vector<double>{1.0, 1.5, 2.0}));
  EXPECT_EQ(evenTimes(0.0, 0.7, 0.5), (std::vector<double>{0.0, 0.5, 0.7}));
  EXPECT_EQ(evenTimes(3.0, 3.0, 0.5), (std::vector<double>{3.0}));
  // 0.1 is no binary fraction: no step of next to nothing before the end.
  EXPECT_EQ(evenTimes(0.0, 0.30000000000000004, 0.1).size(), 4U);
}

std::vector<std::vector<std::string>> tableIn(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string row; std::getline(lines, row);) {
    rows.emplace_back();
    std::istringstream fields(row);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

/// A bead of 1200 W, and a travel back.
Toolpath laserBead() {
  Toolpath bead = straightBead({0, 0, 0.2}, {60, 0, 0.2});
  bead.layers[0].paths[0].values = {{"laser_power_w", 1200.0}};
  Path back = test::straightPath({60, 0, 0.2}, {0, 0, 0.2});
  back.role = PathRole::Travel;
  back.bead = Bead{};
  bead.layers[0].paths.push_back(back);
  return bead;
}

TEST(NozzleCsv, HoldsPoseSpeedAndProcessOfEachInstant) {
  const Toolpath bead = laserBead();
  const TiltingGantry gantry;
  TimingSettings settings = pathLimits();
  settings.process.kind = ProcessKind::Powder;
  const TimedPath timed(bead, uprightPath(bead, gantry), gantry, settings);
  const test::ScratchFolder folder;
  writeNozzleCsv(folder.file("nozzle.csv"), timed, gantry, {100.0, levelsIn(bead)});
  const auto rows = tableIn(readFile(folder.file("nozzle.csv")));
  EXPECT_EQ(rows[0], (std::vector<std::string>{"t", "x", "y", "z", "qw", "qx", "qy", "qz", "v", "flow_mm3_s",
                                               "laser", "wire", "powder", "gas", "laser_power_w"}));
  const auto at = [&rows](double time_s) {
    const std::vector<std::string>& row = rows[1 + static_cast<std::size_t>(std::lround(100.0 * time_s))];
    std::vector<double> numbers;
    for (const std::string& field : row) numbers.push_back(std::stod(field));
    return numbers;
  };
  // 2.06 s along the bead, 30 mm/s from 0.06 s on, and 2.03 s back.
  EXPECT_EQ(at(0.0)[8], 0.0);
  const std::vector<double> amid = at(1.0);
  EXPECT_NEAR(amid[0], 1.0, 1e-6);
  EXPECT_NEAR(amid[1], 29.1, 1e-6);
  EXPECT_NEAR(amid[3], 0.2, 1e-6);
  EXPECT_NEAR(std::abs(amid[5]), 1.0, 1e-9);
  EXPECT_NEAR(amid[8], 30.0, 1e-6);
  EXPECT_NEAR(amid[9], 30.0 * crossSection({0.4, 0.2}), 1e-6);
  EXPECT_EQ((std::vector<double>{amid.begin() + 10, amid.end()}), (std::vector<double>{1, 0, 1, 1, 1200}));
  const std::vector<double> returning = at(3.0);
  EXPECT_NEAR(returning[8], 30.0, 1e-6);
  EXPECT_EQ((std::vector<double>{returning.begin() + 9, returning.end()}),
            (std::vector<double>{0, 0, 0, 1, 1}));  // no power is stated of travels
  EXPECT_EQ(rows.size(), 1U + evenTimes(0.0, timed.duration(), 0.01).size());
  EXPECT_NEAR(std::stod(rows.back()[1]), 0.0, 1e-6);
}

TEST(NozzleCsv, RefusesRatesOutOfBoundsAndWritesNothing) {
  const Toolpath bead = laserBead();
  const TiltingGantry gantry;
  const TimedPath timed(bead, uprightPath(bead, gantry), gantry, pathLimits());
  const test::ScratchFolder folder;
  for (const double rate_hz : {49.9, 500.1, std::nan("")}) {
    try {
      writeNozzleCsv(folder.file("nozzle.csv"), timed, gantry, {rate_hz, {}});
      FAIL() << rate_hz;
    } catch (const InvalidConfig& error) {
      EXPECT_NE(std::string(error.what()).find("expected 50 to 500 Hz"), std::string::npos) << error.what();
    }
    EXPECT_THROW(readFile(folder.file("nozzle.csv")), FileError);
  }
}

}  // namespace
}  // namespace lamina
