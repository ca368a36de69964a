// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "kinematics/arm/hunt_poses.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/platform/rus_from_urdf.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

std::string text() { return readFile("urdf/rus_platform.urdf"); }

std::unique_ptr<KinematicModel> kinematicModelOf(const std::string& urdf) {
  return kinematicModelFromUrdf(urdf);
}

std::string textWith(const std::string& what, const std::string& by) {
  std::string changed = text();
  const std::size_t at = changed.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return changed.replace(at, what.size(), by);
}

std::string refusal(const std::string& urdf) {
  try {
    kinematicModelOf(urdf);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

JointValues home(const KinematicModel& platform) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = nozzleDown().toRotationMatrix();
  pose.translation() = Point3(60, 60, 20);
  return platform.solutions(pose, JointValues::Zero(6)).at(0).values;
}

JointValues randomCranks(const KinematicModel& platform, Random& random) {
  JointValues values = home(platform);
  for (double& value : values) value += random.uniform(-0.3, 0.3);
  return values;
}

TEST(RusKinematicModel, DescriptionHasTheDimensionsOfTheHuntPlatform) {
  const auto model = parseMachine(text());
  const RusDescription read = rusDescription(*model, LinkTree(*model));
  const RusPlatform expected = huntPlatform();
  EXPECT_LT((read.platform.home.matrix() - expected.home.matrix()).norm(), 1e-9);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = read.platform.legs[i];
    EXPECT_LT((leg.motor - expected.legs[i].motor).norm(), 1e-9);
    EXPECT_LT((leg.axis - expected.legs[i].axis).norm(), 1e-9);
    EXPECT_LT((leg.rest - expected.legs[i].rest).norm(), 1e-9);
    EXPECT_LT((leg.ball - expected.legs[i].ball).norm(), 1e-9);
    EXPECT_LT((leg.socket - expected.legs[i].socket).norm(), 1e-9);
    EXPECT_NEAR(leg.crank_mm, 150.0, 1e-9);
    EXPECT_NEAR(leg.coupler_mm, 340.0, 1e-9);
    EXPECT_EQ(leg.branch, expected.legs[i].branch);
    EXPECT_DOUBLE_EQ(leg.low, expected.legs[i].low);
    EXPECT_DOUBLE_EQ(leg.high, expected.legs[i].high);
    EXPECT_DOUBLE_EQ(leg.greatest_lean, expected.legs[i].greatest_lean);
    EXPECT_DOUBLE_EQ(leg.greatest_swing, expected.legs[i].greatest_swing);
  }
}

TEST(RusKinematicModel, CarriesTheNozzleByItsCranksInAllSixDegrees) {
  const auto platform = kinematicModelByName("rus_platform");
  EXPECT_EQ(platform->name(), "rus_platform");
  EXPECT_EQ(platform->toolAxisSpin(), ToolAxisSpin::Given);
  ASSERT_EQ(platform->joints().size(), 6U);
  EXPECT_EQ(platform->joints()[5].name, "crank_6");
  EXPECT_EQ(platform->joints()[5].kind, JointKind::Rotary);
  EXPECT_DOUBLE_EQ(platform->joints()[0].max_speed, 6.0);
  const Eigen::Isometry3d pose = platform->bedFromNozzle(home(*platform));
  EXPECT_LT((pose.translation() - Point3(60, 60, 20)).norm(), 1e-9);
  EXPECT_TRUE(pose.linear().isApprox(nozzleDown().toRotationMatrix(), 1e-9));
}

TEST(RusKinematicModel, InverseAnswersForward) {
  EXPECT_TRUE(rc::check("cranks come back from the pose they give", [](std::uint64_t seed) {
    Random random(seed);
    const auto platform = kinematicModelOf(text());
    const JointValues values = randomCranks(*platform, random);
    const auto found = platform->solutions(platform->bedFromNozzle(values), values);
    RC_ASSERT(found.size() == 1U);
    RC_ASSERT((found[0].values - values).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(RusKinematicModel, JacobianIsTheSlopeOfTheForwardKinematics) {
  EXPECT_TRUE(rc::check("differences of the nozzle's pose", [](std::uint64_t seed) {
    Random random(seed);
    const auto platform = kinematicModelOf(text());
    const JointValues values = randomCranks(*platform, random);
    const Jacobian columns = platform->jacobian(values);
    const double step = 1e-5;
    for (int j = 0; j < 6; ++j) {
      JointValues low = values;
      JointValues high = values;
      low[j] -= step;
      high[j] += step;
      const Eigen::Isometry3d before = platform->bedFromNozzle(low);
      const Eigen::Isometry3d after = platform->bedFromNozzle(high);
      const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
      const Point3 speed = (after.translation() - before.translation()) / (2.0 * step);
      RC_ASSERT((speed - columns.col(j).head<3>()).norm() < 1e-5);
      RC_ASSERT((turn.angle() / (2.0 * step) * turn.axis() - columns.col(j).tail<3>()).norm() < 1e-7);
    }
  }));
}

TEST(RusKinematicModel, EveryLegOfTheTreeIsClosed) {
  EXPECT_TRUE(rc::check("each coupler ends at its ball, within 1e-9 m", [](std::uint64_t seed) {
    Random random(seed);
    const auto platform = kinematicModelOf(text());
    const JointValues values = randomCranks(*platform, random);
    const auto links = platform->bedFromLinks(values);
    for (int leg = 1; leg <= 6; ++leg) {
      const Point3 end = links.at("coupler_end_" + std::to_string(leg)).translation();
      RC_ASSERT((end - links.at("ball_" + std::to_string(leg)).translation()).norm() < 1e-6);
    }
    RC_ASSERT(links.at("nozzle").isApprox(platform->bedFromNozzle(values), 1e-9));
    RC_ASSERT(links.at("bed").isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  }));
}

TEST(RusKinematicModel, PosesThatAPassiveJointForbidsHaveNoSolution) {
  const std::string stiff = textWith("lower=\"0\" upper=\"1.31\"", "lower=\"0\" upper=\"0.1\"");
  const auto platform = kinematicModelOf(stiff);
  Eigen::Isometry3d pose = platform->bedFromNozzle(home(*platform));
  pose.rotate(Eigen::AngleAxisd(0.5, Point3::UnitX()));
  EXPECT_TRUE(platform->solutions(pose, JointValues::Zero(6)).empty());
  EXPECT_EQ(kinematicModelOf(text())->solutions(pose, JointValues::Zero(6)).size(), 1U);
  pose.translation().z() += 500.0;
  EXPECT_TRUE(kinematicModelOf(text())->solutions(pose, JointValues::Zero(6)).empty()) << "out of reach";
}

TEST(RusKinematicModel, MarginIsTheLesserOfBothKinds) {
  const auto platform = kinematicModelOf(text());
  const RusPlatform hunt = huntPlatform();
  const SingularityMargins margins = singularityMargins(hunt, hunt.home, crankAngles(hunt, hunt.home));
  EXPECT_NEAR(platform->singularityMargin(home(*platform)), std::min(margins.unheld, margins.stretched),
              1e-9);
}

TEST(RusKinematicModel, ValuesOfAnotherCountAreRefused) {
  EXPECT_THROW(kinematicModelOf(text())->bedFromNozzle(JointValues::Zero(5)), InvalidInput);
}

TEST(RusKinematicModel, DescriptionsThatAreNoPlatformSayWhatIsWrong) {
  const std::pair<std::string, std::string> changes[] = {
      {"<joint name=\"crank_6\"", "<joint name=\"crank_7\""},
      {"<link name=\"coupler_end_3\">", "<link name=\"coupler_end_7\">"},
      {"<origin xyz=\"0.34 0 0\"/>", "<origin xyz=\"0.34 0.01 0\"/>"},
      {"<axis xyz=\"0 -1 0\"/>", "<axis xyz=\"0 1 0\"/>"},
      {"<joint name=\"platform_b\" type=\"revolute\">", "<joint name=\"platform_b\" type=\"fixed\">"},
      {"lower=\"-1.2\" upper=\"1.4\"", "lower=\"1.3\" upper=\"1.4\""},
      {"lower=\"0\" upper=\"1.31\"", "lower=\"0\" upper=\"0\""},
      {"velocity=\"6\"", "velocity=\"0\""},
      {"<joint name=\"mobile_platform_to_nozzle\" type=\"fixed\">\n    <parent link=\"mobile_platform\"/>",
       "<joint name=\"mobile_platform_to_nozzle\" type=\"fixed\">\n    <parent link=\"crank_1\"/>"},
  };
  const char* expected[] = {"'crank_6'", "coupler_end", "universal_1_b", "universal_1_b", "platform_b",
                            "crank_1",   "spherical_1", "crank_1",       "'nozzle'"};
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    std::string urdf = textWith(changes[i].first, changes[i].second);
    const std::size_t child = urdf.find("<child link=\"coupler_end_3\"/>");
    if (i == 1) urdf.replace(child, 29, "<child link=\"coupler_end_7\"/>");
    EXPECT_NE(refusal(urdf).find(expected[i]), std::string::npos) << refusal(urdf);
  }
}

}  // namespace
}  // namespace lamina
