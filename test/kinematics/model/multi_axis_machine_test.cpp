// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/multi_axis_machine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "support/any_machine.hpp"
#include "support/description_failure.hpp"

namespace lamina {
namespace {

constexpr double kTip = 1e-6;       // mm: 1e-9 m
constexpr double kToolAxis = 1e-9;  // rad
constexpr double kQuarter = M_PI_2;
const std::vector<std::string> kFiveAxes = {"five_axis_head_ac",    "five_axis_head_bc",
                                            "five_axis_head_table", "five_axis_table_ac",
                                            "five_axis_table_bc",   "fixed_nozzle_table"};

JointValues valuesOf(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

/// Linear values in mm, rotary ones in turns of the tool axis by up to 95 degrees.
JointValues multiAxisMachineAnyValues(Random& random, double most_turn) {
  JointValues values(5);
  for (int i = 0; i < 3; ++i) values[i] = random.uniform(-200.0, 200.0);
  for (int i = 3; i < 5; ++i) values[i] = random.uniform(-most_turn, most_turn);
  return values;
}

/// One that is not refused for axes that are nearly parallel.
std::unique_ptr<KinematicModel> anyUsableMachine(Random& random) {
  for (;;) {
    try {
      return kinematicModelFromUrdf(anyMachine(random));
    } catch (const InvalidConfig&) {
      continue;
    }
  }
}

bool isReached(const KinematicModel& machine, const JointValues& values, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d reached = machine.bedFromNozzle(values);
  return (reached.translation() - pose.translation()).norm() < kTip &&
         (reached.linear().col(2) - pose.linear().col(2)).norm() < kToolAxis;
}

/// Whether the values are the same but for whole turns.
bool isSame(const JointValues& a, const JointValues& b, double tolerance) {
  if ((a - b).head<3>().norm() > tolerance * 1e3) return false;
  for (Eigen::Index j = 3; j < a.size(); ++j)
    if (std::abs(std::remainder(a[j] - b[j], 2.0 * M_PI)) > tolerance) return false;
  return true;
}

TEST(MultiAxisMachine, HeadsTurnTheToolAxisAboutTheirPivot) {
  const auto head =
      kinematicModelByName("five_axis_head_ac");  // joints x, y, z, a, c; pivot 120 mm above the tip
  const Eigen::Isometry3d tilted = head->bedFromNozzle(valuesOf({100, 50, 20, kQuarter, 0}));
  EXPECT_TRUE(tilted.translation().isApprox(Point3(100, 170, 140), 1e-12));
  EXPECT_TRUE(tilted.linear().col(2).isApprox(Point3::UnitY(), 1e-12));
  const Eigen::Isometry3d turned = head->bedFromNozzle(valuesOf({100, 50, 20, kQuarter, kQuarter}));
  EXPECT_TRUE(turned.translation().isApprox(Point3(-20, 50, 140), 1e-12));
  EXPECT_TRUE(turned.linear().col(2).isApprox(-Point3::UnitX(), 1e-12));
}

TEST(MultiAxisMachine, AGimbalIsSingularAtTheLevelToolAxisOnly) {
  const auto gimbal = kinematicModelByName("five_axis_head_ab");
  for (const auto& [b, margin] : {std::pair(0.0, 1.0), std::pair(M_PI / 3.0, 0.5), std::pair(kQuarter, 0.0)})
    EXPECT_NEAR(gimbal->singularityMargin(valuesOf({1, 2, 3, 0.4, b})), margin, 1e-12);
  const JointValues upright =
      gimbal->solutions(gimbal->bedFromNozzle(JointValues::Zero(5)), JointValues::Zero(5))[1].values;
  EXPECT_TRUE(upright.isZero(1e-12));
}

TEST(MultiAxisMachine, TablesCountAgainstTheNozzle) {
  const auto turntable = kinematicModelByName("five_axis_head_table");  // x, y, z, b, c
  const Eigen::Isometry3d turned = turntable->bedFromNozzle(valuesOf({100, 0, 50, 0, kQuarter}));
  EXPECT_TRUE(turned.translation().isApprox(Point3(0, 100, 50), 1e-12));
  // The cradle's axis is 30 mm above the table.
  for (const char* name : {"five_axis_table_ac", "fixed_nozzle_table"}) {
    const Eigen::Isometry3d tilted =
        kinematicModelByName(name)->bedFromNozzle(valuesOf({0, 0, 0, kQuarter, 0}));
    EXPECT_TRUE(tilted.translation().isApprox(Point3(0, 30, 30), 1e-12)) << name;
    EXPECT_TRUE(tilted.linear().col(2).isApprox(Point3::UnitY(), 1e-12)) << name;
  }
}

TEST(MultiAxisMachine, BothBranchesReachThePoseAndOneIsWhereItCameFrom) {
  EXPECT_TRUE(rc::check("forward and inverse", [](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : kFiveAxes) {
      const auto machine = kinematicModelByName(name);
      const JointValues values = multiAxisMachineAnyValues(random, M_PI);
      const Eigen::Isometry3d pose = machine->bedFromNozzle(values);
      const auto solutions = machine->solutions(pose, values);
      RC_ASSERT(solutions.size() == 2U);
      int same = 0;
      for (const InverseSolution& solution : solutions) {
        RC_ASSERT(isReached(*machine, solution.values, pose));
        if (isSame(solution.values, values, 1e-6)) ++same;
      }
      RC_ASSERT(same == 1);
    }
  }));
}

TEST(MultiAxisMachine, AnyArrangementOfItsJointsIsSolved) {
  EXPECT_TRUE(rc::check("arbitrary axes, places and order", [](std::uint64_t seed) {
    Random random(seed);
    const auto machine = anyUsableMachine(random);
    const JointValues values = multiAxisMachineAnyValues(random, M_PI);
    RC_PRE(machine->singularityMargin(values) > 0.02);
    const Eigen::Isometry3d pose = machine->bedFromNozzle(values);
    bool is_found = false;
    for (const InverseSolution& solution : machine->solutions(pose, values)) {
      RC_ASSERT(isReached(*machine, solution.values, pose));
      is_found = is_found || isSame(solution.values, values, 1e-6);
    }
    RC_ASSERT(is_found);
  }));
}

TEST(MultiAxisMachine, NearItsSingularityItReachesThePoseAsWell) {
  EXPECT_TRUE(rc::check("tool axes ever nearer to the first axis", [](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : kFiveAxes) {
      const auto machine = kinematicModelByName(name);
      for (double tilt = 1e-3; tilt > 1e-17; tilt *= 0.1) {
        JointValues values = multiAxisMachineAnyValues(random, M_PI);
        values[3] = random.below(2) == 0 ? tilt : -tilt;
        const Eigen::Isometry3d pose = machine->bedFromNozzle(values);
        const auto solutions = machine->solutions(pose, values);
        RC_ASSERT(solutions.size() == 2U);
        for (const InverseSolution& solution : solutions)
          RC_ASSERT(isReached(*machine, solution.values, pose));
      }
    }
  }));
}

TEST(MultiAxisMachine, WhereTheToolAxisIsOnTheFirstAxisThatJointStays) {
  for (const std::string& name : kFiveAxes) {
    const auto machine = kinematicModelByName(name);
    const Eigen::Isometry3d pose = machine->bedFromNozzle(valuesOf({10, 20, 30, 0, 0}));
    const JointValues near = valuesOf({0, 0, 0, 0.3, 7.5});
    for (const InverseSolution& solution : machine->solutions(pose, near)) {
      EXPECT_EQ(solution.values[4], 7.5) << name;
      EXPECT_NEAR(solution.values[3], 0.0, kToolAxis) << name;
      EXPECT_TRUE(isReached(*machine, solution.values, pose)) << name;
    }
    EXPECT_NEAR(machine->singularityMargin(near), std::sin(0.3), 1e-12) << name;
    EXPECT_NEAR(machine->singularityMargin(valuesOf({1, 2, 3, 0, 2})), 0.0, 1e-12) << name;
    EXPECT_NEAR(machine->singularityMargin(valuesOf({1, 2, 3, -kQuarter, 2})), 1.0, 1e-12) << name;
  }
}

TEST(MultiAxisMachine, ABranchIsFollowedSteadily) {
  for (const std::string& name : kFiveAxes) {
    const auto machine = kinematicModelByName(name);
    for (const int branch : {0, 1}) {
      JointValues before =
          machine->solutions(machine->bedFromNozzle(valuesOf({0, 0, 0, 0.1, -3})), JointValues::Zero(5))
              .at(static_cast<std::size_t>(branch))
              .values;
      for (double way = 0.0; way < 1.0; way += 0.01) {
        const JointValues driven = valuesOf({100 * way, 0, 0, 0.1 + 2.0 * way, -3 + 6 * way});
        const auto solutions = machine->solutions(machine->bedFromNozzle(driven), before);
        const JointValues& values = solutions.at(static_cast<std::size_t>(branch)).values;
        EXPECT_TRUE(isSame(values, before, 0.11)) << name << " " << branch << " " << way;
        before = values;
      }
    }
  }
}

TEST(MultiAxisMachine, ANutatingHeadReachesAsFarAsTwiceItsAngle) {
  std::string text = kinematicModelByName("five_axis_head_table")->urdf();
  const std::string axis = "<axis xyz=\"0 1 0\"/>\n    <limit lower=\"-1.658063\"";
  text.replace(text.find(axis), 20, "<axis xyz=\"0 0.6 0.8\"/>");
  const auto machine = kinematicModelFromUrdf(text);
  const double rim = 2.0 * std::atan2(0.6, 0.8);
  const auto toolAxisTilted = [](double angle) {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(M_PI - angle, Point3(1, 2, 0).normalized()));
    pose.translation() = Point3(5, 6, 70);
    return pose;
  };
  for (const double angle : {0.0, 1e-9, 0.3, 1.0, rim - 1e-9, rim}) {
    const auto solutions = machine->solutions(toolAxisTilted(angle), JointValues::Zero(5));
    ASSERT_EQ(solutions.size(), 2U) << angle;
    for (const InverseSolution& solution : solutions)
      EXPECT_TRUE(isReached(*machine, solution.values, toolAxisTilted(angle))) << angle;
  }
  EXPECT_TRUE(machine->solutions(toolAxisTilted(rim + 0.001), JointValues::Zero(5)).empty());
  EXPECT_NEAR(
      machine->singularityMargin(machine->solutions(toolAxisTilted(rim), JointValues::Zero(5))[0].values),
      0.0, 1e-7);
}

TEST(MultiAxisMachine, OfFourAxesReachesToolAxesOfOnePlaneOfTheBed) {
  std::string text = kinematicModelByName("five_axis_head_table")->urdf();
  const std::string turntable = "<joint name=\"c\" type=\"continuous\">";
  text.replace(text.find(turntable), turntable.size(), "<joint name=\"base_to_bed\" type=\"fixed\">");
  const auto machine = kinematicModelFromUrdf(text);
  const Eigen::Isometry3d pose = machine->bedFromNozzle(valuesOf({10, 20, 30, 0.7}));
  const auto solutions = machine->solutions(pose, JointValues::Zero(4));
  ASSERT_EQ(solutions.size(), 1U);
  EXPECT_TRUE(solutions[0].values.isApprox(valuesOf({10, 20, 30, 0.7}), 1e-12));
  const Eigen::Isometry3d aside = pose * Eigen::Isometry3d(Eigen::AngleAxisd(0.01, Point3::UnitX()));
  EXPECT_TRUE(machine->solutions(aside, JointValues::Zero(4)).empty());
}

TEST(MultiAxisMachine, ItsJointsHaveTheirLimits) {
  const auto machine = kinematicModelByName("five_axis_head_table");
  const std::vector<DrivenJoint>& joints = machine->joints();
  ASSERT_EQ(joints.size(), 5U);
  EXPECT_EQ(joints[0].high, 300.0);
  EXPECT_EQ(joints[0].max_speed, 500.0);
  EXPECT_NEAR(joints[3].low, -95.0 * M_PI / 180.0, 1e-6);
  EXPECT_EQ(joints[3].max_speed, 3.0);
  EXPECT_TRUE(std::isinf(joints[4].low) && std::isinf(joints[4].high));
  EXPECT_EQ(joints[4].kind, JointKind::Rotary);
}

TEST(MultiAxisMachine, RefusesOtherJointsAndMoreOfThem) {
  Random random(5);
  const auto failureWith = [&](const char* name) {
    MachineParts parts = anyParts(random);
    parts.push_back({name, Point3::UnitZ(), Point3::Zero(), Point3::Zero()});
    return test::descriptionFailure(urdfOf(parts, 2));
  };
  EXPECT_EQ(failureWith("c"), "machine 'any' has 3 rotary joints; at most two are understood");
  EXPECT_EQ(
      failureWith("w"),
      "machine 'any': joint 'w' moves; only prismatic joints x, y and z and rotary joints a, b and c are "
      "understood");
  MachineParts four = anyParts(random);
  four.erase(four.begin() + 1);
  EXPECT_EQ(test::descriptionFailure(urdfOf(four)),
            "machine 'any' has 2 linear axes between bed and nozzle; expected x, y and z");
}

TEST(MultiAxisMachine, RefusesRotaryJointsThatTiltNoToolAxis) {
  Random random(3);
  MachineParts parts = anyParts(random);
  parts[3].axis = parts[4].axis = Point3::UnitX();
  parts[4].rpy.setZero();
  EXPECT_NE(test::descriptionFailure(urdfOf(parts))
                .find("are parallel; expected two that tilt the tool axis to any side"),
            std::string::npos);
  std::string about_tool_axis = kinematicModelByName("five_axis_table_ac")->urdf();
  const std::string tilting = "<joint name=\"a\" type=\"revolute\">";
  about_tool_axis.replace(about_tool_axis.find(tilting), tilting.size(),
                          "<joint name=\"base_to_cradle\" type=\"fixed\">");
  EXPECT_EQ(
      test::descriptionFailure(about_tool_axis),
      "machine 'five_axis_table_ac': joint 'c' turns about the tool axis; expected an axis that tilts it");
}

}  // namespace
}  // namespace lamina
