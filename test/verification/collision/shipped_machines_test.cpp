// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kShippedMachinesDegree = M_PI / 180.0;

/// Heights of the tip over the bed [mm].
const std::vector<double> kHeights = {0.2, 20.0, 100.0};

bool isWithinLimits(const JointValues& values, const std::vector<DrivenJoint>& joints) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    if (value < joints[j].low || value > joints[j].high) return false;
  }
  return true;
}

/// Of the first branch within the limits; none if it does not reach there.
JointValues usualJoints(const KinematicModel& model, const Eigen::Isometry3d& pose) {
  const JointValues zero = JointValues::Zero(static_cast<Eigen::Index>(model.joints().size()));
  for (const InverseSolution& solution : model.solutions(pose, zero))
    if (isWithinLimits(solution.values, model.joints())) return solution.values;
  return {};
}

/// Poses over a bed, each by itself: waypoints without joints stand between them.
struct Walk {
  Toolpath toolpath;
  JointPath joints;
  std::size_t reached = 0;
};

/// Over the bed, the nozzle held as with all joints at zero, straight down by robots, and a little turned.
Walk walkOverBed(const KinematicModel& model) {
  Walk walk;
  Path path;
  path.role = PathRole::Travel;
  const BuildSpace space = buildSpaceFromUrdf(model.urdf());
  const Eigen::Quaterniond held(space.bed_from_nozzle);
  const Box3 room = boundingBox(space);
  const Point3 half = 0.4 * (room.high - room.low);
  const auto add = [&](const Eigen::Isometry3d& pose) {
    walk.joints.at.push_back({0, 0, path.points.size()});
    walk.joints.values.push_back(usualJoints(model, pose));
    walk.reached += walk.joints.values.back().size() > 0 ? 1 : 0;
    path.points.emplace_back(pose.translation());
    walk.joints.at.push_back({0, 0, path.points.size()});
    walk.joints.values.emplace_back();
    path.points.emplace_back(pose.translation());
  };
  for (const double height : kHeights)
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
      for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0})
        for (const double turn : {-15.0, 0.0, 15.0}) {
          const Point3 tip(room.centre().x() + x * half.x(), room.centre().y() + y * half.y(), height);
          add(Eigen::Translation3d(tip) * Eigen::AngleAxisd(turn * kShippedMachinesDegree, Point3::UnitZ()) *
              held);
        }
  walk.toolpath = {"walk", {{0.2, 0.2, {path}}}};
  return walk;
}

class ShippedMachine : public testing::TestWithParam<std::string> {};

TEST_P(ShippedMachine, RunsIntoNothingOverItsBed) {
  const auto model = kinematicModelByName(GetParam());
  const Walk walk = walkOverBed(*model);
  EXPECT_GT(walk.reached, 0U);
  NoProgress nobody;
  const JointClearanceReport report =
      checkJointClearance({walk.toolpath, Eigen::Isometry3d::Identity(), *model, walk.joints},
                          linkBodies(model->urdf()), {}, nobody);
  for (const Collision& collision : report.collisions)
    ADD_FAILURE() << collision.link << " is in "
                  << (collision.obstacle == Obstacle::Bed ? "the bed" : collision.other)
                  << " with the tip at " << collision.tip.transpose();
}

INSTANTIATE_TEST_SUITE_P(Each, ShippedMachine, testing::ValuesIn(kinematicModelNames()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace lamina
