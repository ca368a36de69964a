// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

class Unheard final : public Progress {
 public:
  void report(const std::string& /*stage*/, double /*fraction*/) override {}
  bool isCancelled() const override { return false; }
};

Eigen::Quaterniond leaning(double tilt, double heading) {
  return Eigen::AngleAxisd(heading, Point3::UnitZ()) * Eigen::AngleAxisd(tilt, Point3::UnitY()) *
         nozzleDown();
}

/// A bead of 60 mm along x whose tool axis leans by `tilt` and goes around the vertical by 0.6 rad on the
/// way.
Toolpath leaningLine(double tilt) {
  Path path = test::straightPath({-30, 5, 0.2}, {30, 5, 0.2});
  path.orientation = AlongPath<Eigen::Quaterniond>({leaning(tilt, 0.0), leaning(tilt, 0.6)});
  return {"line", {{0.2, 0.2, {path}}}};
}

void expectKept(const std::string& name, double tilt) {
  const auto machine = kinematicModelByName(name);
  const Toolpath toolpath = leaningLine(tilt);
  JointPathSettings joints;
  joints.max_slowdown = 100.0;
  Unheard progress;
  const JointPath path = planJointPath(toolpath, Eigen::Isometry3d::Identity(), *machine, joints, progress);
  ASSERT_TRUE(path.isRunnable()) << path.faults.front().reason;
  TimingSettings settings;
  const TimedPath timed(toolpath, path, *machine, settings);
  const double h = 1e-3;
  JointState before = timed.at(0.0);
  for (double t = h; t < timed.duration() + h; t += h) {
    const JointState state = timed.at(t);
    for (std::size_t j = 0; j < machine->joints().size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      const double speed = machine->joints()[j].max_speed;
      ASSERT_LE(std::abs(state.velocity[i]), speed * (1 + 1e-9));
      ASSERT_LE(std::abs(state.velocity[i] - before.velocity[i]) / h,
                speed / settings.trajectory.joint_ramp_s * (1 + 1e-6));
    }
    const Point3 tip = machine->bedFromNozzle(state.position).translation();
    const double off = std::hypot(tip.y() - 5.0, tip.z() - 0.2);
    ASSERT_LE(off, 2.0 * settings.trajectory.line_tolerance_mm + settings.trajectory.blend_tolerance_mm);
    before = state;
  }
  const Point3 end = machine->bedFromNozzle(before.position).translation();
  EXPECT_LT((end - Point3(30, 5, 0.2)).norm(), 1e-6);
}

class EveryMachine : public testing::TestWithParam<const char*> {};

TEST_P(EveryMachine, KeepsItsLimitsAndTheLine) { expectKept(GetParam(), 0.35); }

TEST_P(EveryMachine, PassesBesideTheSingularityOfAnUprightToolAxis) { expectKept(GetParam(), 0.01); }

INSTANTIATE_TEST_SUITE_P(Trajectory, EveryMachine,
                         testing::Values("five_axis_head_table", "five_axis_table_ac", "five_axis_table_bc",
                                         "irb_4600"));

}  // namespace
}  // namespace lamina
