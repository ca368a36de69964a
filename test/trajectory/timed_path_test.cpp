// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/timed_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "support/joint_paths.hpp"
#include "support/random_toolpath.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::PlanarArm;
using test::TiltingGantry;

/// Joint accelerations so great that the path's own limits govern.
TimingSettings briskJoints() {
  TimingSettings settings;
  settings.motion.acceleration_mm_s2 = 500.0;
  settings.motion.travel_acceleration_mm_s2 = 1000.0;
  settings.trajectory.joint_ramp_s = 1e-3;
  return settings;
}

Toolpath corner() {
  Path path = test::straightPath({0, 0, 0.2}, {30, 0, 0.2});
  path.points.push_back({30, 30, 0.2});
  return {"corner", {{0.2, 0.2, {path}}}};
}

double distanceToCorner(const Point3& p) {
  const double on_first = std::hypot(p.x() - std::clamp(p.x(), 0.0, 30.0), p.y());
  const double on_second = std::hypot(p.x() - 30.0, p.y() - std::clamp(p.y(), 0.0, 30.0));
  return std::min(on_first, on_second);
}

double mostDeviation(const TimedPath& timed, const KinematicModel& model) {
  double most = 0.0;
  for (double t = 0.0; t < timed.duration(); t += 1e-3)
    most = std::max(most, distanceToCorner(model.bedFromNozzle(timed.at(t).position).translation()));
  return most;
}

TEST(TimedPath, AStraightLineTakesTheTimeFromRestToRest) {
  const Toolpath line{"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {60, 0, 0.2})}}}};
  const TiltingGantry gantry;
  const TimedPath timed(line, uprightPath(line, gantry), gantry, briskJoints());
  EXPECT_NEAR(timed.duration(), 60.0 / 30.0 + 30.0 / 500.0, 1e-9);
  EXPECT_NEAR(timed.at(1.0).tip_speed_mm_s, 30.0, 1e-9);
  EXPECT_NEAR(timed.at(1.0).position[0], 30.0 * (1.0 - 0.03), 1e-9);
  EXPECT_NEAR(timed.at(-1.0).position[0], 0.0, 1e-12);
  EXPECT_NEAR(timed.at(99.0).position[0], 60.0, 1e-12);
  EXPECT_EQ(timed.at(99.0).velocity.norm(), 0.0);
}

TEST(TimedPath, AJointsRampBoundsItsAcceleration) {
  Path path = test::straightPath({0, 0, 0.2}, {100, 0, 0.2});
  path.feed_mm_s = 1000.0;
  const Toolpath line{"line", {{0.2, 0.2, {path}}}};
  TimingSettings settings = briskJoints();
  settings.motion.acceleration_mm_s2 = 1e6;
  settings.trajectory.joint_ramp_s = 0.25;
  const TiltingGantry gantry;
  // x runs at 200 mm/s at most, reached in 0.25 s.
  EXPECT_NEAR(TimedPath(line, uprightPath(line, gantry), gantry, settings).duration(), 100.0 / 200.0 + 0.25,
              1e-9);
}

PathEvent dwellBeforeMotion(std::size_t motion, double duration_s) {
  PathEvent event;
  event.motion = motion;
  event.event.emplace<Dwell>(Dwell{duration_s});
  return event;
}

TEST(TimedPath, WaitsForDwellsAtRest) {
  Toolpath line{"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {60, 0, 0.2})}}}};
  Path& path = line.layers[0].paths[0];
  path.points.insert(path.points.begin() + 1, {15, 0, 0.2});
  path.events = {dwellBeforeMotion(0, 1.0), dwellBeforeMotion(1, 2.0), dwellBeforeMotion(2, 0.25)};
  line.events_at_end.emplace_back(Dwell{0.5});
  const TiltingGantry gantry;
  const TimedPath timed(line, uprightPath(line, gantry), gantry, briskJoints());
  // Two motions from rest to rest at 30 mm/s and 500 mm/s², and 3.75 s of waiting.
  const double first_s = 15.0 / 30.0 + 30.0 / 500.0;
  EXPECT_NEAR(timed.duration(), first_s + 45.0 / 30.0 + 30.0 / 500.0 + 3.75, 1e-9);
  EXPECT_NEAR(timed.stationTimes()[1], 1.0 + first_s, 1e-9);
  EXPECT_EQ(timed.at(0.9).velocity.norm(), 0.0);
  EXPECT_EQ(timed.at(1.0 + first_s + 1.0).velocity.norm(), 0.0);
  EXPECT_NEAR(timed.at(1.0 + first_s + 1.0).position[0], 15.0, 1e-9);
}

TEST(TimedPath, StopsAtCornersWithoutTolerance) {
  const TiltingGantry gantry;
  TimingSettings settings = briskJoints();
  settings.trajectory.blend_tolerance_mm = 0.0;
  const TimedPath timed(corner(), uprightPath(corner(), gantry), gantry, settings);
  EXPECT_NEAR(timed.duration(), 2 * (30.0 / 30.0 + 30.0 / 500.0), 1e-9);
  EXPECT_NEAR(timed.stationTimes()[1], 1.06, 1e-9);
  EXPECT_LT(mostDeviation(timed, gantry), 1e-9);
}

TEST(TimedPath, RoundsCornersByTheTolerance) {
  const TiltingGantry gantry;
  TimingSettings settings = briskJoints();
  settings.trajectory.blend_tolerance_mm = 0.1;
  const TimedPath timed(corner(), uprightPath(corner(), gantry), gantry, settings);
  // The rounding leaves the corner by the tolerance, which lies on its bisector: 0.1 / sqrt(2) off the legs.
  EXPECT_NEAR(mostDeviation(timed, gantry), 0.1 / std::sqrt(2.0), 2e-3);
  const Point3 nearest = gantry.bedFromNozzle(timed.at(timed.stationTimes()[1]).position).translation();
  EXPECT_NEAR((nearest - Point3(30, 0, 0.2)).norm(), 0.1, 1e-9);
  // The bend at the corner is 1.5 sqrt(2) / (2 b), b = 16 / 3 0.1 / sqrt(2), and 500 mm/s² leave v² of 178:
  // the way to rest and back from 13.3 mm/s is saved, which takes 2 v / a less its length over the feed.
  const double v = std::sqrt(500.0 * 2.0 * (16.0 / 3.0 * 0.1 / std::sqrt(2.0)) / (1.5 * std::sqrt(2.0)));
  EXPECT_LT(timed.duration(), 2.12 - v * v / (500.0 * 30.0));
}

TEST(TimedPath, HoldsTheToleranceWithJerkLimited) {
  const TiltingGantry gantry;
  TimingSettings settings = briskJoints();
  settings.trajectory.blend_tolerance_mm = 0.1;
  settings.trajectory.jerk_ramp_s = 0.02;
  const TimedPath timed(corner(), uprightPath(corner(), gantry), gantry, settings);
  const double most = mostDeviation(timed, gantry);
  EXPECT_LT(most, 0.1);
  EXPECT_GT(most, 0.02);
}

TEST(TimedPath, TurnsInPlaceTakeTheTimeTheJointsNeed) {
  const TiltingGantry gantry(0.0);
  Toolpath toolpath{"turn", {{0.2, 0.2, {test::straightPath({0, 0, 0}, {30, 0, 0})}}}};
  toolpath.layers[0].paths.push_back(test::straightPath({30, 0, 0}, {60, 0, 0}));
  JointPath path = uprightPath(toolpath, gantry);
  path.values[2][3] = path.values[3][3] = 1.5;
  const TimedPath timed(toolpath, path, gantry, briskJoints());
  // 1.5 rad at 3 rad/s, reached in 1 ms; before and after it the tip comes to rest.
  const double line_s = 30.0 / 30.0 + 30.0 / 500.0;
  EXPECT_NEAR(timed.duration(), 2 * line_s + 0.5 + 1e-3, 1e-9);
  EXPECT_NEAR(timed.stationTimes()[2] - timed.stationTimes()[1], 0.501, 1e-9);
  EXPECT_EQ(timed.at(line_s + 0.25).tip_speed_mm_s, 0.0);
  EXPECT_NEAR(timed.at(line_s + 0.25).velocity[3], 3.0, 1e-9);
}

TEST(TimedPath, AnArmKeepsTheTipOnItsLine) {
  const PlanarArm arm;
  Path path = test::straightPath({250, -150, 10}, {250, 150, 10});
  const Toolpath line{"line", {{0.2, 0.2, {path}}}};
  const JointPath joints = test::jointPathBy(line, [&](const Point3& tip) { return arm.valuesAt(tip); });
  TimingSettings settings = briskJoints();
  settings.trajectory.joint_ramp_s = 0.2;
  settings.trajectory.blend_tolerance_mm = 0.0;
  const TimedPath timed(line, joints, arm, settings);
  for (double t = 0.0; t < timed.duration(); t += 5e-3) {
    const JointState state = timed.at(t);
    const Point3 tip = arm.bedFromNozzle(state.position).translation();
    ASSERT_LE(std::abs(tip.x() - 250.0), settings.trajectory.line_tolerance_mm) << t;
    const Jacobian jacobian = arm.jacobian(state.position);
    const double speed = (jacobian.topRows<3>() * state.velocity).norm();
    ASSERT_NEAR(speed, state.tip_speed_mm_s, 0.01 * 30.0) << t;
  }
  EXPECT_NEAR(timed.at(0.5 * timed.duration()).tip_speed_mm_s, 30.0, 1e-6) << "no stop on the line";
}

/// What is deposited, by the flow summed over time.
double volumeByFlow(const TimedPath& timed) {
  // Flow is linear in time within pieces shorter than this but for kinks; Simpson's rule is exact there.
  const double step_s = 2e-5;
  double volume = 0.0;
  const auto steps = static_cast<std::size_t>(timed.duration() / step_s) + 1;
  for (std::size_t i = 0; i < steps; ++i)
    volume += step_s * timed.at((static_cast<double>(i) + 0.5) * step_s).process.flow_mm3_s;
  return volume;
}

TEST(TimedPath, NamesTravelsThatCannotBeKeptStraightAndRefusesSuchBeads) {
  const PlanarArm arm;
  Path path = test::straightPath({250, -150, 10}, {250, 150, 10});
  Toolpath line{"line", {{0.2, 0.2, {path}}}};
  JointPath joints = test::jointPathBy(line, [&](const Point3& tip) { return arm.valuesAt(tip); });
  // The elbow on the other side at the end: the arm would have to be straight in between, out of reach.
  joints.values[1][0] += joints.values[1][1];
  joints.values[1][1] = -joints.values[1][1];
  EXPECT_THROW(TimedPath(line, joints, arm, {}), Unreachable);
  line.layers[0].paths[0].role = PathRole::Travel;
  const TimedPath timed(line, joints, arm, {});
  ASSERT_EQ(timed.looseTravels().size(), 1U);
  EXPECT_EQ(timed.looseTravels()[0].waypoint, 1U);
}

TEST(TimedPath, LaysTheVolumeOfTheToolpath) {
  const TiltingGantry gantry;
  const Toolpath toolpath = test::twoLayers();
  for (const double jerk_ramp_s : {0.0, 0.01}) {
    TimingSettings settings = briskJoints();
    settings.trajectory.jerk_ramp_s = jerk_ramp_s;
    const TimedPath timed(toolpath, uprightPath(toolpath, gantry), gantry, settings);
    const double asked = totals(toolpath).deposited_mm3;
    EXPECT_NEAR(volumeByFlow(timed) / asked, 1.0, 1e-6) << jerk_ramp_s;
  }
}

/// Greatest of speed / limit and acceleration / limit over all joints, found by differences of positions.
struct Greatest {
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
  double stated = 0.0;  ///< difference of stated velocities and accelerations from those found [of the limit]
};

Greatest differentiated(const TimedPath& timed, const KinematicModel& model, const TimingSettings& settings) {
  JointValues speed(model.joints().size());
  for (Eigen::Index j = 0; j < speed.size(); ++j) speed[j] = model.joints()[j].max_speed;
  const JointValues acceleration = speed / settings.trajectory.joint_ramp_s;
  const double h = 5e-4;
  Greatest greatest;
  const auto steps = static_cast<std::size_t>(timed.duration() / h) + 2;
  JointState here = timed.at(0.0);
  for (std::size_t i = 1; i < steps; ++i) {
    const JointState after = timed.at(static_cast<double>(i) * h);
    const JointValues moved = (after.position - here.position) / h;
    const JointValues bent = (after.velocity - here.velocity) / h;
    const JointValues jerked = (after.acceleration - here.acceleration) / h;
    greatest.speed = std::max(greatest.speed, moved.cwiseQuotient(speed).cwiseAbs().maxCoeff());
    greatest.acceleration =
        std::max(greatest.acceleration, bent.cwiseQuotient(acceleration).cwiseAbs().maxCoeff());
    greatest.jerk = std::max(greatest.jerk, jerked.cwiseQuotient(acceleration).cwiseAbs().maxCoeff());
    const JointValues mean = 0.5 * (after.velocity + here.velocity);
    greatest.stated = std::max(greatest.stated, (moved - mean).cwiseQuotient(speed).cwiseAbs().maxCoeff());
    here = after;
  }
  return greatest;
}

/// A toolpath with a tilt of the head that changes along it.
JointPath swayingPath(const Toolpath& toolpath, const TiltingGantry& gantry) {
  return test::jointPathBy(toolpath, [&](const Point3& tip) {
    return gantry.valuesAt(tip, 0.8 * std::sin(0.2 * tip.x()) * std::cos(0.1 * tip.y()));
  });
}

TEST(TimedPath, RespectsEveryLimitEverywhere) {
  EXPECT_TRUE(rc::check("joint speeds, accelerations and jerks found by differences", [] {
    Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    toolpath.layers.resize(1);
    toolpath.layers[0].paths.resize(std::min<std::size_t>(toolpath.layers[0].paths.size(), 3));
    TimingSettings settings;
    settings.trajectory.blend_tolerance_mm = *rc::gen::element(0.0, 0.01, 0.5);
    settings.trajectory.joint_ramp_s = *rc::gen::element(0.05, 0.3);
    settings.trajectory.jerk_ramp_s = *rc::gen::element(0.0, 0.01);
    const TiltingGantry gantry;
    const TimedPath timed(toolpath, swayingPath(toolpath, gantry), gantry, settings);
    const Greatest greatest = differentiated(timed, gantry, settings);
    RC_ASSERT(greatest.speed <= 1.0 + 1e-6);
    RC_ASSERT(greatest.acceleration <= 1.0 + 1e-6);
    RC_ASSERT(greatest.acceleration > 0.9);
    RC_ASSERT(greatest.stated < 1e-2);
    if (settings.trajectory.jerk_ramp_s > 0.0)
      RC_ASSERT(greatest.jerk <= (1.0 + 1e-6) / settings.trajectory.jerk_ramp_s);
  }));
}

TEST(TimedPath, RunsNoFasterThanItsFeeds) {
  const Toolpath toolpath = test::randomToolpath(7);
  const TiltingGantry gantry;
  const TimedPath timed(toolpath, uprightPath(toolpath, gantry), gantry, TimingSettings{});
  for (double t = 0.0; t < timed.duration(); t += 1e-3) {
    const JointState state = timed.at(t);
    const Path& path = toolpath.layers[state.heading_for.layer].paths[state.heading_for.path];
    ASSERT_LE(state.tip_speed_mm_s, path.feed_mm_s.at(state.heading_for.waypoint) + 1e-9);
  }
}

TEST(TimedPath, PassesStationsAtTheirTimes) {
  const Toolpath toolpath = test::randomToolpath(11);
  const TiltingGantry gantry;
  for (const double jerk_ramp_s : {0.0, 0.01}) {
    TimingSettings settings;
    settings.trajectory.jerk_ramp_s = jerk_ramp_s;
    const JointPath path = uprightPath(toolpath, gantry);
    const TimedPath timed(toolpath, path, gantry, settings);
    ASSERT_EQ(timed.stationTimes().size(), path.at.size());
    for (std::size_t i = 0; i < path.at.size(); ++i) {
      ASSERT_GE(timed.stationTimes()[i], timed.stationTimes()[std::max<std::size_t>(i, 1) - 1]);
      // Averaging may leave a corner along the path by a T²/24 of tangential acceleration besides.
      ASSERT_LT((timed.at(timed.stationTimes()[i]).position - path.values[i]).norm(), 0.05 + 0.1) << i;
    }
  }
}

TEST(TimedPath, GivesTheTimeOfEachLayer) {
  const Toolpath toolpath = test::twoLayers();
  const TiltingGantry gantry;
  TimingSettings settings = briskJoints();
  settings.trajectory.blend_tolerance_mm = 0.0;
  const ToolpathTime time = estimateJointTime(toolpath, uprightPath(toolpath, gantry), gantry, settings);
  const double line = 10.0 / 30.0 + 30.0 / 500.0;
  const double rise = std::sqrt(4 * 0.2 / 1000.0);
  ASSERT_EQ(time.layer_start_s.size(), 2U);
  EXPECT_NEAR(time.layer_start_s[1], 4 * line + rise, 1e-9);
  EXPECT_NEAR(time.total_s, 5 * line + rise, 1e-9);
}

TEST(TimedPath, RefusesWhatDoesNotFit) {
  const Toolpath toolpath = test::twoLayers();
  const TiltingGantry gantry;
  const JointPath path = uprightPath(toolpath, gantry);
  JointPath shorter = path;
  shorter.at.pop_back();
  EXPECT_THROW(TimedPath(toolpath, shorter, gantry, {}), InvalidInput);
  JointPath faulty = path;
  faulty.faults.push_back({{0, 0, 1}, JointFault::OutOfReach, "x at 300 mm"});
  EXPECT_THROW(TimedPath(toolpath, faulty, gantry, {}), Unreachable);
  EXPECT_THROW(TimedPath(toolpath, path, PlanarArm(), {}), InvalidInput);
  EXPECT_THROW(TimedPath(Toolpath{}, JointPath{}, gantry, {}), InvalidInput);
  TimingSettings no_ramp;
  no_ramp.trajectory.joint_ramp_s = 0.0;
  EXPECT_THROW(TimedPath(toolpath, path, gantry, no_ramp), InvalidConfig);
  Toolpath drops = toolpath;
  drops.layers[0].paths[0].deposit = Deposit::Drops;
  EXPECT_THROW(TimedPath(drops, path, gantry, {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
