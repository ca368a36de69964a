// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/kinematic_model_run.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using Eigen::Isometry3d;

/// A bead of 100 mm over the bed of a head with axes A and C.
Toolpath longBead() { return {"bead", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {100, 0, 0.2})}}}}; }

KinematicModelRun runOver(const KinematicModel& model, const Point3& place) {
  NoProgress nobody;
  return runOn(model, longBead(), Isometry3d(Eigen::Translation3d(place)), {}, nobody);
}

TEST(KinematicModelRun, HasJointsThatBringTheNozzleToEveryStepOfTheDividedToolpath) {
  const auto machine = kinematicModelByName("five_axis_head_ac");
  const KinematicModelRun run = runOver(*machine, {100, 100, 0});
  ASSERT_TRUE(run.path.isRunnable());
  // Steps of 5 mm, and the start.
  ASSERT_EQ(run.path.at.size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    const Point3 tip = machine->bedFromNozzle(run.path.values[i]).translation();
    EXPECT_LT((tip - Point3(100.0 + 5.0 * static_cast<double>(i), 100, 0.2)).norm(), 1e-6) << i;
  }
}

/// The head of a gantry stands beside the nozzle of the second tool, by its offset.
TEST(KinematicModelRun, HasTheNozzleOfTheToolInUseAtTheBead) {
  const auto machine = kinematicModelByName("cartesian_gantry");
  Toolpath toolpath = longBead();
  toolpath.layers[0].paths.push_back(test::straightPath({0, 5, 0.2}, {100, 5, 0.2}));
  toolpath.layers[0].paths[1].tool = 1;
  JointPathSettings settings;
  settings.tool_offsets_mm = {Point3::Zero(), Point3(30, -2, 0.5)};
  NoProgress nobody;
  const KinematicModelRun run =
      runOn(*machine, toolpath, Isometry3d(Eigen::Translation3d(60, 60, 5)), settings, nobody);
  ASSERT_TRUE(run.path.isRunnable());
  for (std::size_t i = 0; i < run.path.at.size(); ++i) {
    const WaypointIndex& at = run.path.at[i];
    const Point3 tip = machine->bedFromNozzle(run.path.values[i]).translation();
    const Point3 planned = Point3(60, 60, 5) + run.toolpath().layers[0].paths[at.path].points[at.waypoint];
    const Point3 expected = at.path == 0 ? planned : Point3(planned - Point3(30, -2, 0.5));
    EXPECT_LT((tip - expected).norm(), 1e-6) << i;
  }
}

TEST(KinematicModelRun, TakesTheTimeOfItsMotionFromRestToRest) {
  const auto machine = kinematicModelByName("five_axis_head_ac");
  TimingSettings settings;
  settings.motion.acceleration_mm_s2 = 300.0;
  settings.trajectory.joint_ramp_s = 0.01;  // joints are brisker than the path
  const TimedRun timed = inTime(runOver(*machine, {100, 100, 0}), *machine, settings);
  // 100 mm at 30 mm/s, up to it and down from it within 0.1 s.
  EXPECT_NEAR(timed.time.total_s, 100.0 / 30.0 + 0.1, 1e-6);
  EXPECT_NEAR(timed.trajectory->duration(), timed.time.total_s, 1e-12);
}

TEST(KinematicModelRun, IsPlannedByFirmwareWhereLinearAxesAloneMove) {
  TimingSettings settings;
  settings.motion.acceleration_mm_s2 = 300.0;
  settings.trajectory.joint_ramp_s = 20.0;  // joints would take much longer
  for (const char* const name : {"cartesian_gantry", "five_axis_head_ac"}) {
    const auto machine = kinematicModelByName(name);
    const TimedRun timed = inTime(runOver(*machine, {100, 100, 0}), *machine, settings);
    const RunTime planned = plannedTime(timed, *machine, settings.motion);
    // 100 mm at 30 mm/s, up to it and down from it within 0.1 s; 95 % of it after 0.9025 * 1.5 mm.
    EXPECT_NEAR(planned.total_s, 100.0 / 30.0 + 0.1, 1e-9) << name;
    EXPECT_NEAR(planned.slow_bead_share, 2.0 * 0.9025 * 1.5 / 100.0, 1e-9) << name;
    EXPECT_GT(timed.figures.total_s, planned.total_s + 0.5) << name;
  }
}

TEST(KinematicModelRun, IsPlannedWithinTheLimitsOfJointsWhereTheseTurnOrAreStated) {
  const auto machine = kinematicModelByName("five_axis_head_ac");
  KinematicModelRun stated = runOver(*machine, {100, 100, 0});
  stated.lines.assign(stated.path.at.size(), 7);
  Toolpath leaning = longBead();
  leaning.layers[0].paths[0].orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Point3::UnitY())) * nozzleDown();
  NoProgress nobody;
  KinematicModelRun turned =
      runOn(*machine, leaning, Isometry3d(Eigen::Translation3d(100, 100, 0)), {}, nobody);
  TimingSettings settings;
  settings.trajectory.joint_ramp_s = 2.0;
  for (KinematicModelRun* const run : {&stated, &turned}) {
    const TimedRun timed = inTime(std::move(*run), *machine, settings);
    const RunTime planned = plannedTime(timed, *machine, settings.motion);
    EXPECT_DOUBLE_EQ(planned.total_s, timed.figures.total_s);
    EXPECT_DOUBLE_EQ(planned.slow_bead_share, timed.figures.slow_bead_share);
  }
}

/// Squares of 30 mm over each other, with travels up.
Toolpath tower(std::size_t layers) {
  Toolpath toolpath;
  for (std::size_t l = 0; l < layers; ++l) {
    const double z = 0.25 * static_cast<double>(l + 1);  // to the last bit, whatever the sum
    Path wall = test::straightPath({0, 0, z}, {30, 0, z});
    wall.is_closed = true;
    wall.points.insert(wall.points.end(), {{30, 30, z}, {0, 30, z}});
    Path up = test::straightPath({0, 0, z}, {0, 0, z + 0.25});
    up.role = PathRole::Travel;
    up.bead = Bead{};
    toolpath.layers.push_back({z, 0.25, {wall, up}});
  }
  return toolpath;
}

TEST(KinematicModelRun, OfSomeLayersHasTheirJointsAndAllLayers) {
  const auto machine = kinematicModelByName("cartesian_gantry");
  const Toolpath toolpath = tower(9);
  const Isometry3d bed_from_part(Eigen::Translation3d(60, 60, 0));
  NoProgress nobody;
  const KinematicModelRun whole = runOn(*machine, toolpath, bed_from_part, {}, nobody);
  const ToolpathExcerpt excerpt{toolpath, {{1, 3}, {5, 6}}};
  const KinematicModelRun some = runOn(CheckedMachine(*machine), excerpt, bed_from_part, {}, nobody);
  JointPath expected;
  for (std::size_t i = 0; i < whole.path.at.size(); ++i) {
    const std::size_t layer = whole.path.at[i].layer;
    if (layer != 1 && layer != 2 && layer != 5) continue;
    expected.at.push_back(whole.path.at[i]);
    expected.values.push_back(whole.path.values[i]);
  }
  EXPECT_EQ(some.path.at, expected.at);
  EXPECT_EQ(some.path.values, expected.values);
  ASSERT_EQ(some.toolpath().layers.size(), 9U);
  for (std::size_t l = 0; l < 9; ++l) {
    const bool is_led = l == 1 || l == 2 || l == 5;
    EXPECT_EQ(some.toolpath().layers[l].paths[0].points.size(), is_led ? 24U : 4U) << l;
    EXPECT_EQ(some.divided.original[l][0].size(), is_led ? 24U : 4U) << l;
  }
}

TEST(KinematicModelRun, IsRefusedByTheFirstWaypointOutOfReach) {
  const auto machine = kinematicModelByName("five_axis_head_ac");
  const KinematicModelRun run = runOver(*machine, {1e5, 100, 0});
  EXPECT_FALSE(run.path.isRunnable());
  try {
    inTime(run, *machine, {});
    FAIL() << "expected it to be refused";
  } catch (const Unreachable& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find("layer 0, path 0, waypoint 0: "), 0U) << what;
    EXPECT_NE(what.find("out_of_limits, the first of 21 places that five_axis_head_ac cannot run"),
              std::string::npos)
        << what;
  }
}

}  // namespace
}  // namespace lamina
