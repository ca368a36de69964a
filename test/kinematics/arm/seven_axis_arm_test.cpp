// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Arms of seven axes: all solutions for a pose and an arm angle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/description_files/robot_report.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

constexpr double kExact = 1e-9;        // m, rad
constexpr double kOffSingular = 0.02;  // sine: at least 1 deg from singular

JointValues sevenDegrees(std::initializer_list<double> degrees) {
  JointValues values(7);
  std::copy(degrees.begin(), degrees.end(), values.data());
  return values * (M_PI / 180.0);
}

double angleApart(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * M_PI)); }

/// How many of the poses of random configurations have the drawn one among their solutions.
struct Found {
  int poses = 0;
  int drawn = 0;
  std::map<std::size_t, int> by_count;
};

Found foundOf(const KinematicModel& arm, int poses) {
  const Redundancy& redundancy = *arm.redundancy();
  Found found;
  Random random(23);
  while (found.poses < poses) {
    const JointValues values = test::anyJointValues(arm, random);
    if (arm.singularityMargin(values) < kOffSingular) continue;
    ++found.poses;
    const Eigen::Isometry3d pose = arm.bedFromNozzle(values);
    const double angle = redundancy.angleAt(values);
    const InverseSolutions solutions = redundancy.solutionsWith(pose, JointValues::Zero(7), angle);
    std::set<int> branches;
    bool is_drawn = false;
    for (const auto& [branch, solution] : solutions) {
      EXPECT_LT(test::distance(arm.bedFromNozzle(solution), pose), kExact);
      EXPECT_LT(angleApart(redundancy.angleAt(solution), angle), kExact);
      EXPECT_TRUE(branches.insert(branch).second);
      EXPECT_LE(solution.maxCoeff(), M_PI);
      EXPECT_GT(solution.minCoeff(), -M_PI);
      is_drawn |= test::turnDistance(solution, values) < 1e-6;
    }
    ++found.by_count[solutions.size()];
    found.drawn += is_drawn ? 1 : 0;
  }
  return found;
}

TEST(SevenAxisArm, SphericalOnesHaveEightSolutionsForAnArmAngleAndNoneIsMissed) {
  const Found found = foundOf(*kinematicModelFromUrdf(test::sphericalSeven().urdf()), 10000);
  EXPECT_EQ(found.drawn, 10000);
  EXPECT_EQ(found.by_count, (std::map<std::size_t, int>{{8, 10000}}));
}

TEST(SevenAxisArm, AxesThatMeetWithinHalfAMillimetreAreRefined) {
  const Found found = foundOf(*kinematicModelFromUrdf(test::nearlySphericalSeven().urdf()), 10000);
  EXPECT_EQ(found.drawn, 10000);
}

TEST(SevenAxisArm, OthersAreFollowedFromOneWhoseAxesMeet) {
  const Found found = foundOf(*kinematicModelFromUrdf(test::offsetSeven().urdf()), 10000);
  // Some two in a hundred are the second solution with the same signs, or beyond what the start reaches.
  EXPECT_GE(found.drawn, 9500);
}

/// The elbow seen along the line from the shoulder to the wrist, from where the arm stands upright in a
/// plane.
double elbowTurn(const KinematicModel& arm, const JointValues& values) {
  const auto links = arm.bedFromLinks(values);
  const Point3 shoulder = links.at("axis_2_link").translation();
  const Point3 wrist = links.at("axis_6_link").translation();
  const Point3 elbow = links.at("axis_4_link").translation();
  const Point3 line = (wrist - shoulder).normalized();
  const auto across = [&](const Point3& vector) { return Point3(vector - line.dot(vector) * line); };
  const Point3 up = across(Point3::UnitZ());
  const Point3 out = across(elbow - shoulder);
  return std::atan2(line.dot(up.cross(out)), up.dot(out));
}

TEST(SevenAxisArm, TheArmAngleIsTheTurnOfTheElbowAboutTheLineToTheWrist) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const Redundancy& redundancy = *arm->redundancy();
  EXPECT_NEAR(redundancy.angleAt(sevenDegrees({25, 20, 0, -60, 0, 40, 0})), 0.0, 1e-12);
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    JointValues values = test::anyJointValues(*arm, random);
    if (arm->singularityMargin(values) < kOffSingular) continue;
    // An elbow bent the other way is below the line where the axis of the elbow has not turned.
    const double turn = elbowTurn(*arm, values) + (values[3] > 0.0 ? M_PI : 0.0);
    EXPECT_LT(angleApart(redundancy.angleAt(values), turn), 1e-9) << values.transpose();
  }
}

/// Steps of 1 deg of the arm angle, over a whole turn, in which a joint leaps to another solution.
int leapsAround(const KinematicModel& arm, const JointValues& start) {
  const Redundancy& redundancy = *arm.redundancy();
  const Eigen::Isometry3d pose = arm.bedFromNozzle(start);
  int leaps = 0;
  std::map<int, JointValues> before;
  for (int step = 0; step <= 360; ++step) {
    const double angle = redundancy.angleAt(start) + step * M_PI / 180.0;
    std::map<int, JointValues> now;
    for (const auto& [branch, values] : redundancy.solutionsWith(pose, start, angle)) {
      if (arm.singularityMargin(values) < 0.1) continue;
      now[branch] = values;
      if (before.count(branch) != 0 && test::turnDistance(values, before[branch]) > 0.25) ++leaps;
    }
    before = now;
  }
  // A whole turn leads back.
  EXPECT_TRUE(std::any_of(before.begin(), before.end(),
                          [&](const auto& each) { return test::turnDistance(each.second, start) < 1e-6; }));
  return leaps;
}

TEST(SevenAxisArm, TheElbowTurnsOnWhileTheNozzleStands) {
  for (const auto& start :
       {sevenDegrees({10, 35, 15, 70, 20, 50, 30}), sevenDegrees({0, 40, 0, -80, 0, 60, 0})}) {
    EXPECT_EQ(leapsAround(*kinematicModelFromUrdf(test::sphericalSeven().urdf()), start), 0);
    // Two solutions with the same signs may change places.
    EXPECT_LE(leapsAround(*kinematicModelFromUrdf(test::offsetSeven().urdf()), start), 4);
  }
}

TEST(SevenAxisArm, SolutionsKeepTheArmAngleOfTheValuesNearby) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const JointValues near = sevenDegrees({10, 35, 40, 70, 20, 50, 30});
  const double angle = arm->redundancy()->angleAt(near);
  EXPECT_GT(std::abs(angle), 0.3);
  Eigen::Isometry3d pose = arm->bedFromNozzle(near);
  pose.translation() += Point3(0.0, 5.0, 0.0);
  const InverseSolutions solutions = arm->solutions(pose, near);
  EXPECT_EQ(solutions.size(), 8U);
  for (const InverseSolution& each : solutions)
    EXPECT_LT(angleApart(arm->redundancy()->angleAt(each.values), angle), kExact);
}

TEST(SevenAxisArm, OutOfReachThereIsNoSolution) {
  for (const auto& description : {test::sphericalSeven(), test::offsetSeven()}) {
    const auto arm = kinematicModelFromUrdf(description.urdf());
    Eigen::Isometry3d pose = arm->bedFromNozzle(JointValues::Constant(7, 0.4));
    pose.translation().z() += 5000.0;
    EXPECT_TRUE(arm->solutions(pose, JointValues::Zero(7)).empty());
  }
}

TEST(SevenAxisArm, TheMarginIsTheLeastSine) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const double degree = M_PI / 180.0;
  EXPECT_NEAR(arm->singularityMargin(sevenDegrees({0, 50, 0, 3, 0, 60, 0})), std::sin(3 * degree), 1e-9);
  EXPECT_NEAR(arm->singularityMargin(sevenDegrees({0, 2, 0, 70, 0, 60, 0})), std::sin(2 * degree), 1e-9);
  EXPECT_NEAR(arm->singularityMargin(sevenDegrees({0, 50, 0, 70, 0, -4, 0})), std::sin(4 * degree), 1e-9);
}

TEST(SevenAxisArm, IsReportedWithItsClassAndRedundancy) {
  const RobotReport spherical = robotReport(test::sphericalSeven().urdf());
  EXPECT_EQ(spherical.kinematic_class, "seven axes, spherical shoulder and wrist");
  EXPECT_NE(spherical.redundancy.find("arm angle"), std::string::npos);
  EXPECT_EQ(spherical.joints.size(), 7U);
  // Shoulder to elbow 410 mm, to the wrist 390 mm, to the flange and nozzle 350 mm.
  EXPECT_LT(spherical.reach_mm, 1150.0);
  EXPECT_GT(spherical.reach_mm, 1000.0);
  EXPECT_EQ(robotReport(test::nearlySphericalSeven().urdf()).kinematic_class, spherical.kinematic_class);
  EXPECT_EQ(robotReport(test::offsetSeven().urdf()).kinematic_class, "seven axes, any other, by iteration");
  EXPECT_EQ(robotReport(test::exactParallelAxesArm().urdf()).redundancy, "");
}

TEST(SevenAxisArm, IsNoArmOfSixAxes) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  EXPECT_FALSE(isSixAxisArm(*arm));
  EXPECT_THROW(abbConfiguration(*arm, JointValues::Zero(7)), InvalidConfig);
}

std::string refusalOf(const std::string& urdf) {
  try {
    kinematicModelFromUrdf(urdf);
  } catch (const InvalidConfig& refused) {
    return refused.what();
  }
  return "";
}

TEST(SevenAxisArm, NeighbouringAxesThatAreNotAtRightAnglesAreRefusedByName) {
  test::SevenAxisDescription description = test::sphericalSeven();
  description.fourth_axis = "0 0 1";
  const std::string refusal = refusalOf(description.urdf());
  EXPECT_NE(refusal.find("'axis_3' and 'axis_4' are at 0 deg"), std::string::npos) << refusal;
}

TEST(SevenAxisArm, EightJointsAreRefusedWithTheirNumber) {
  std::string text = test::sphericalSeven().urdf();
  const std::string fixed = "<joint name=\"to_nozzle\" type=\"fixed\">";
  text.replace(text.find(fixed), fixed.size(), "<joint name=\"to_nozzle\" type=\"revolute\">");
  const std::string end = "</joint></robot>";
  text.replace(text.find(end), end.size(),
               "<limit lower=\"-1\" upper=\"1\" velocity=\"1\" effort=\"1\"/>" + end);
  const std::string refusal = refusalOf(text);
  EXPECT_NE(refusal.find("has 8 rotary joints"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace lamina
