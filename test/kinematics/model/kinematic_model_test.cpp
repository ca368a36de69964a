// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/kinematic_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "support/description_failure.hpp"

namespace lamina {
namespace {

constexpr double kKinematicModelWide = 1e3;  // mm, rad: of joints without end
constexpr double kStep = 1e-4;
constexpr double kOfDifferences = 1e-6;  // of the Jacobian: the step's square, and rounding over the step

JointValues anyValues(const KinematicModel& model, Random& random) {
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    values[j] =
        random.uniform(std::max(joint.low, -kKinematicModelWide), std::min(joint.high, kKinematicModelWide));
  }
  return values;
}

/// Those that any values of the joints bring somewhere: the cranks of a platform may not be closed by its
/// legs.
std::vector<std::string> serialNames() {
  std::vector<std::string> names = kinematicModelNames();
  names.erase(std::remove(names.begin(), names.end(), "rus_platform"), names.end());
  return names;
}

/// Text of the gantry with one thing replaced wherever it stands.
std::string kinematicModelGantryWith(const std::string& what, const std::string& by) {
  std::string text = machineByName("cartesian_gantry").urdf;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

TEST(KinematicModel, EveryOneReachesWhereItsJointsBroughtIt) {
  EXPECT_TRUE(rc::check("the tip and the tool axis come back", [](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : serialNames()) {
      const auto model = kinematicModelByName(name);
      const JointValues values = anyValues(*model, random);
      const Eigen::Isometry3d pose = model->bedFromNozzle(values);
      const auto solutions = model->solutions(pose, values);
      RC_ASSERT(!solutions.empty());
      for (const InverseSolution& solution : solutions) {
        const Eigen::Isometry3d reached = model->bedFromNozzle(solution.values);
        RC_ASSERT((reached.translation() - pose.translation()).norm() < 1e-6);
        RC_ASSERT((reached.linear().col(2) - pose.linear().col(2)).norm() < 1e-9);
      }
    }
  }));
}

TEST(KinematicModel, TheJacobianIsWhatDifferencesGive) {
  EXPECT_TRUE(rc::check("Jacobian and central differences", [](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : serialNames()) {
      const auto model = kinematicModelByName(name);
      const JointValues values = anyValues(*model, random);
      const Jacobian jacobian = model->jacobian(values);
      for (Eigen::Index j = 0; j < values.size(); ++j) {
        const JointValues step = kStep * JointValues::Unit(values.size(), j);
        const Eigen::Isometry3d before = model->bedFromNozzle(values - step);
        const Eigen::Isometry3d after = model->bedFromNozzle(values + step);
        const Point3 moved = (after.translation() - before.translation()) / (2.0 * kStep);
        const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
        const Point3 turned = turn.angle() * turn.axis() / (2.0 * kStep);
        RC_ASSERT((jacobian.col(j).head<3>() - moved).norm() < kOfDifferences * (1.0 + moved.norm()));
        RC_ASSERT((jacobian.col(j).tail<3>() - turned).norm() < kOfDifferences);
      }
    }
  }));
}

TEST(KinematicModel, TheNozzleIsOneOfTheLinksAndTheBedStands) {
  Random random(7);
  for (const std::string& name : serialNames()) {
    const auto model = kinematicModelByName(name);
    const JointValues values = anyValues(*model, random);
    const auto links = model->bedFromLinks(values);
    EXPECT_TRUE(links.at("bed").matrix().isIdentity(1e-9)) << name;
    EXPECT_TRUE(links.at("nozzle").matrix().isApprox(model->bedFromNozzle(values).matrix(), 1e-12)) << name;
    for (Eigen::Index j = 0; j < values.size(); ++j)
      EXPECT_EQ(model->urdfJoints(values).at(model->joints()[static_cast<std::size_t>(j)].name), values[j])
          << name;
  }
}

TEST(KinematicModel, MachinesAreThoseOfTheSlicerWithRotaryJointsAtZero) {
  Random random(1);
  for (const std::string& name : machineNames()) {
    const CartesianMachine machine = machineByName(name);
    const auto model = kinematicModelByName(name);
    JointValues values = anyValues(*model, random);
    values.tail(values.size() - 3).setZero();
    EXPECT_TRUE(model->bedFromNozzle(values).isApprox(bedFromNozzle(machine, values.head<3>()), 1e-12))
        << name;
    EXPECT_EQ(model->joints().size(), 3 + machine.rotary_joints.size()) << name;
  }
}

TEST(KinematicModel, AFixedHeadReachesNoOtherToolAxis) {
  const auto machine = kinematicModelByName("gantry_45");
  const JointValues values = JointValues::Constant(3, 50.0);
  const auto turnedBy = [&](double degrees) {
    return Eigen::Isometry3d(machine->bedFromNozzle(values) *
                             Eigen::AngleAxisd(degrees * M_PI / 180.0, Point3::UnitX()));
  };
  EXPECT_TRUE(machine->solutions(turnedBy(0.0099), values)[0].values.isApprox(values));
  EXPECT_TRUE(machine->solutions(turnedBy(0.0101), values).empty());
}

TEST(KinematicModel, ABeltHasNoEnd) {
  const auto belt = kinematicModelByName("belt_45");
  EXPECT_EQ(belt->joints()[2].name, "z");
  EXPECT_EQ(belt->joints()[2].low, 0.0);
  EXPECT_TRUE(std::isinf(belt->joints()[2].high));
}

TEST(KinematicModel, RefusesDescriptionsByWhatIsWrongWithThem) {
  EXPECT_EQ(test::descriptionFailure(kinematicModelGantryWith("\"nozzle\"", "\"tip\"")),
            "machine 'cartesian_gantry' has no link 'nozzle'");
  EXPECT_EQ(
      test::descriptionFailure(kinematicModelGantryWith("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 2\"/>")),
      "machine 'cartesian_gantry': the axis of joint 'z' is 2 long; expected 1");
  EXPECT_EQ(
      test::descriptionFailure(kinematicModelGantryWith("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"1 0 0\"/>")),
      "machine 'cartesian_gantry': the axes x, y and z do not span space");
  EXPECT_EQ(test::descriptionFailure(kinematicModelGantryWith("upper=\"0.25\"", "upper=\"-1\"")),
            "machine 'cartesian_gantry': joint 'z' has limits 0 to -1; the lower must be the "
            "lesser");
  EXPECT_EQ(test::descriptionFailure(kinematicModelGantryWith("velocity=\"0.2\"", "velocity=\"0\"")),
            "machine 'cartesian_gantry': joint 'z' has a velocity of 0; must be positive");
  EXPECT_EQ(test::descriptionFailure(kinematicModelGantryWith("<joint name=\"z\" type=\"prismatic\">",
                                                              "<joint name=\"z\" type=\"fixed\">")),
            "machine 'cartesian_gantry' has 2 linear axes between bed and nozzle; expected x, y and z");
  const std::string unknown =
      test::descriptionFailure(kinematicModelGantryWith("<joint name=\"x\"", "<joint name=\"left\""));
  EXPECT_EQ(
      unknown.find(
          "machine 'cartesian_gantry' is of no kind that is recognised; expected a joint x, a joint crank_1"),
      0U);
}

TEST(KinematicModel, NamesTheJointThatHasNoLimits) {
  const std::string limit = "<limit lower=\"0\" upper=\"0.25\" velocity=\"0.2\" effort=\"100\"/>";
  EXPECT_NE(test::descriptionFailure(kinematicModelGantryWith(limit, "")).find("is no URDF: Joint [z]"),
            std::string::npos)
      << test::descriptionFailure(kinematicModelGantryWith(limit, ""));
}

TEST(KinematicModel, RefusesAnUnknownName) { EXPECT_THROW(kinematicModelByName("delta"), InvalidConfig); }

}  // namespace
}  // namespace lamina
