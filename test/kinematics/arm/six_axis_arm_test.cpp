// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"
#include "support/description_failure.hpp"

namespace lamina {
namespace {

constexpr double kRoundTrip = 1e-9;  // m and rad: what is asked for
const std::vector<std::string> kArms = {"irb_4400", "irb_4600", "irb_4600_turntable"};

JointValues joints(std::initializer_list<double> degrees) {
  JointValues values(static_cast<Eigen::Index>(degrees.size()));
  Eigen::Index j = 0;
  for (const double degree : degrees) values[j++] = degree * M_PI / 180.0;
  return values;
}

/// All solutions of where the values bring the nozzle; checks that each is one.
InverseSolutions solutionsAt(const KinematicModel& arm, const JointValues& values, double tolerance) {
  const Eigen::Isometry3d pose = arm.bedFromNozzle(values);
  InverseSolutions solutions = arm.solutions(pose, values);
  for (const InverseSolution& solution : solutions) {
    RC_ASSERT(test::distance(arm.bedFromNozzle(solution.values), pose) < tolerance);
    RC_ASSERT(solution.values.head<6>().maxCoeff() <= M_PI);
    RC_ASSERT(solution.values.head<6>().minCoeff() > -M_PI);
  }
  return solutions;
}

bool holds(const InverseSolutions& solutions, const JointValues& values, double tolerance) {
  return std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& solution) {
    return test::turnDistance(solution.values, values) < tolerance;
  });
}

TEST(SixAxisArm, TheFlangeIsWhereTheDimensionsPutIt) {
  // At zero the forearm is level: 175 + 960 + 135 mm to the front, 495 + 900 + 175 mm up.
  const auto arm = kinematicModelByName("irb_4600");
  const auto links = arm->bedFromLinks(joints({0, 0, 0, 0, 0, 0}));
  const Eigen::Isometry3d base_from_flange = links.at("base_link").inverse() * links.at("tool0");
  EXPECT_TRUE(base_from_flange.translation().isApprox(Point3(1270, 0, 1570), 1e-12));
  EXPECT_TRUE(base_from_flange.linear().col(2).isApprox(Point3::UnitX(), 1e-12));
}

TEST(SixAxisArm, EverySolutionLeadsBackToThePose) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : kArms) {
      const auto arm = kinematicModelByName(name);
      const JointValues values = test::anyJointValues(*arm, random);
      const auto solutions = solutionsAt(*arm, values, kRoundTrip);
      RC_ASSERT(arm->singularityMargin(values) < 1e-3 || holds(solutions, values, 1e-9));
    }
  }));
}

TEST(SixAxisArm, ItLeadsBackNearSingularitiesToo) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const auto arm = kinematicModelByName("irb_4600");
    JointValues values = test::anyJointValues(*arm, random);
    const double off = std::pow(10.0, random.uniform(-16.0, -2.0));
    const double straight = std::atan2(175.0, 960.0) - M_PI / 2.0;
    // Of the wrist over axis 1: the forearm leans back as far as the upper arm and axis 2 reach out.
    const double lean = std::asin(-(175.0 + 900.0 * std::sin(values[1])) / std::hypot(175.0, 960.0));
    const std::uint64_t kind = random.below(3);
    if (kind == 0) values[4] = off;
    if (kind == 1) values[2] = straight + off;
    if (kind == 2) values[2] = lean + straight - values[1] + off;
    if (kind == 2 && !(std::abs(175.0 + 900.0 * std::sin(values[1])) < 970.0)) return;
    // Seen from as near as 1 mm, some 1 m of forearm.
    RC_ASSERT(arm->singularityMargin(values) < 1e3 * off + 1e-12);
    RC_ASSERT(!solutionsAt(*arm, values, kRoundTrip).empty());
  }));
}

TEST(SixAxisArm, AtAStraightWristAxis4StaysWhereItIs) {
  const auto arm = kinematicModelByName("irb_4600");
  const JointValues values = joints({20, 10, 15, 40, 0, -70});
  const Eigen::Isometry3d pose = arm->bedFromNozzle(values);
  EXPECT_EQ(arm->singularityMargin(values), 0.0);
  for (const double fourth : {-120.0, 0.0, 40.0}) {
    const auto solutions = arm->solutions(pose, joints({20, 10, 15, fourth, 0, 0}));
    // The sum of joints 4 and 6 is what the pose gives.
    EXPECT_TRUE(holds(solutions, joints({20, 10, 15, fourth, 0, -30.0 - fourth}), 1e-9)) << fourth;
  }
}

TEST(SixAxisArm, WithTheWristOverAxis1Joint1StaysWhereItIs) {
  const auto arm = kinematicModelByName("irb_4600");
  JointValues values = joints({50, -30, 0, 20, 40, 60});
  const double reach = std::hypot(175.0, 960.0);
  const double forearm = std::asin(-(175.0 + 900.0 * std::sin(values[1])) / reach);
  values[2] = forearm - values[1] + std::atan2(175.0, 960.0) - M_PI / 2.0;
  EXPECT_NEAR(arm->singularityMargin(values), 0.0, 1e-12);
  const auto solutions = arm->solutions(arm->bedFromNozzle(values), values);
  ASSERT_EQ(solutions.size(), 8U);
  for (const InverseSolution& solution : solutions) EXPECT_NEAR(solution.values[0], values[0], 1e-12);
  EXPECT_TRUE(holds(solutions, values, 1e-7));
}

TEST(SixAxisArm, AllEightBranchesAreDistinct) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const auto arm = kinematicModelByName("irb_4600");
    const JointValues values = test::anyJointValues(*arm, random);
    RC_PRE(arm->singularityMargin(values) > 0.01);
    const auto solutions = solutionsAt(*arm, values, kRoundTrip);
    // Eight where the wrist can be reached backwards too, else four.
    RC_ASSERT(solutions.size() == 8U || solutions.size() == 4U);
    for (std::size_t i = 1; i < solutions.size(); ++i) {
      RC_ASSERT(solutions[i].branch > solutions[i - 1].branch);
      for (std::size_t k = 0; k < i; ++k)
        RC_ASSERT(test::turnDistance(solutions[i].values, solutions[k].values) > 1e-3);
    }
  }));
}

TEST(SixAxisArm, AlongASmoothMotionABranchIsSteady) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const auto arm = kinematicModelByName("irb_4600");
    const JointValues from = test::anyJointValues(*arm, random);
    const JointValues to = from + 0.3 * (test::anyJointValues(*arm, random) - from);
    constexpr int kSteps = 200;
    std::map<int, JointValues> before;
    for (int i = 0; i <= kSteps; ++i) {
      const JointValues values = from + double(i) / kSteps * (to - from);
      std::map<int, JointValues> now;
      for (const auto& [branch, found] : arm->solutions(arm->bedFromNozzle(values), values)) {
        if (arm->singularityMargin(found) < 0.05) continue;
        now[branch] = found;
        // A tip goes some 10 mm a step, joints by 0.3 rad at worst as near to a singularity as that.
        if (before.count(branch) != 0) RC_ASSERT(test::turnDistance(found, before[branch]) < 0.5);
      }
      before = now;
    }
  }));
}

TEST(SixAxisArm, OutOfReachThereIsNoSolution) {
  const auto arm = kinematicModelByName("irb_4600");
  const JointValues values = joints({0, 0, 0, 0, 30, 0});
  Eigen::Isometry3d pose = arm->bedFromNozzle(values);
  const auto links = arm->bedFromLinks(values);
  // Axis 2 to the wrist at most, with the elbow straight.
  const double reach = 900.0 + std::hypot(960.0, 175.0);
  const Point3 shoulder = links.at("link_2").translation();
  const Point3 wrist = links.at("link_5").translation();
  for (const double beyond : {-1e-5, 1e-5}) {
    const Point3 wanted = shoulder + (reach + beyond) * (wrist - shoulder).normalized();
    Eigen::Isometry3d moved = pose;
    moved.translation() += wanted - wrist;
    EXPECT_EQ(arm->solutions(moved, values).empty(), beyond > 0.0);
  }
  pose.translation() += Point3(0, 0, 1e5);
  EXPECT_TRUE(arm->solutions(pose, values).empty());
}

TEST(SixAxisArm, RoundedNumbersOfADescriptionAreMadeGood) {
  const auto arm = kinematicModelFromUrdf(test::roundedArm().urdf());
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const JointValues values = test::anyJointValues(*arm, random);
    RC_PRE(arm->singularityMargin(values) > 0.01);
    const auto solutions = solutionsAt(*arm, values, kRoundTrip);
    RC_ASSERT(solutions.size() >= 4U);
    RC_ASSERT(holds(solutions, values, 1e-8));
  }));
}

TEST(SixAxisArm, AnArmOfNoClassIsSolvedByIteration) {
  const auto arm = kinematicModelFromUrdf(test::scatteredWristArm().urdf());
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const JointValues values = test::anyJointValues(*arm, random);
    if (arm->singularityMargin(values) < 0.01) continue;
    const auto solutions = solutionsAt(*arm, values, kRoundTrip);
    EXPECT_TRUE(holds(solutions, values, 1e-7)) << i;
    EXPECT_GE(solutions.size(), 2U);  // of what can be reached, the elbow can be bent the other way
    for (std::size_t k = 1; k < solutions.size(); ++k)
      EXPECT_GT(solutions[k].branch, solutions[k - 1].branch);
  }
}

TEST(SixAxisArm, AnExternalAxisKeepsItsValue) {
  const auto arm = kinematicModelByName("irb_4600_turntable");
  const auto alone = kinematicModelByName("irb_4600");
  ASSERT_EQ(arm->joints().size(), 7U);
  EXPECT_EQ(arm->joints()[6].name, "external_1");
  JointValues values = joints({10, 20, 5, 30, 40, 50, 90});
  const Eigen::Isometry3d pose = arm->bedFromNozzle(values);
  // The table turned by a quarter sees the nozzle turned back by one.
  const Eigen::Isometry3d still = alone->bedFromNozzle(values.head<6>());
  EXPECT_LT(test::distance(Eigen::AngleAxisd(-M_PI / 2.0, Point3::UnitZ()) * still, pose), 1e-12);
  const auto solutions = arm->solutions(pose, joints({0, 0, 0, 0, 0, 0, 90}));
  EXPECT_TRUE(holds(solutions, values, 1e-9));
  for (const InverseSolution& solution : solutions) EXPECT_EQ(solution.values[6], values[6]);
}

TEST(SixAxisArm, AnArmOfFourJointsIsRefused) {
  std::string text = test::parallelAxesArm().urdf();
  for (const char* name : {"joint_5", "joint_6"}) {
    const std::string joint = "<joint name=\"" + std::string(name) + "\" type=\"";
    const std::string moving = joint + "revolute\"";
    text.replace(text.find(moving), moving.size(), joint + "fixed\"");
  }
  EXPECT_NE(test::descriptionFailure(text).find("4 rotary joints"), std::string::npos)
      << test::descriptionFailure(text);
}

}  // namespace
}  // namespace lamina
