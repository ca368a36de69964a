// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/gravity_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "support/directions.hpp"
#include "support/tilting_arm.hpp"

namespace lamina {
namespace {

constexpr double kCone = 10.0 * kDegree;

Station stationAt(double azimuth, double lean, double duration_s = 0.5) {
  Station station;
  station.position = Point3(60.0 * std::cos(azimuth), 60.0 * std::sin(azimuth), 10.0);
  station.orientation = test::nozzleOnWall(azimuth, lean);
  station.motion.duration_s = duration_s;
  return station;
}

/// A wall that leans by an angle, once around.
std::vector<Station> ringLeaning(double lean, double first_azimuth = 0.4) {
  std::vector<Station> stations;
  for (int i = 0; i <= 72; ++i) stations.push_back(stationAt(first_azimuth + 5.0 * i * kDegree, lean));
  return stations;
}

/// By how much the nozzle points off straight down while the table stands so, as the chain says.
double offDown(const KinematicModel& model, const Station& station, const TableValues& values) {
  JointValues joints = JointValues::Zero(8);
  joints[6] = values.tilt;
  joints[7] = values.turn;
  const Eigen::Isometry3d root_from_bed = model.bedFromLinks(joints).at("base_link").inverse();
  const Point3 tool_axis = root_from_bed.linear() * (station.orientation * Point3::UnitZ());
  return std::atan2(tool_axis.head<2>().norm(), -tool_axis.z());
}

TEST(GravityTable, AWallThatLeansAlikeAllAroundTurnsThePlateOnceAtOneSpeed) {
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  const std::vector<Station> ring = ringLeaning(45.0 * kDegree);
  const std::vector<TableValues> values = tableValues(gravityTable(*model), ring, {kCone, 0.0});
  const double sense = values.back().turn > values.front().turn ? 1.0 : -1.0;
  EXPECT_NEAR(sense * (values.back().turn - values.front().turn), 2.0 * M_PI, 1e-9);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_NEAR(std::abs(values[i].tilt), 45.0 * kDegree, 1e-9);
    EXPECT_LT(offDown(*model, ring[i], values[i]), 1e-6);
    if (i > 0) {
      EXPECT_NEAR(sense * (values[i].turn - values[i - 1].turn), 5.0 * kDegree, 1e-9);
    }
  }
}

// A wall of 150 mm radius that leans out by 0 to 60 deg, laid at 8 mm/s: 8 / 150 rad/s are 3.056 deg/s of the
// plate, which never turns back and needs not turn while the lean is within the cone.
TEST(GravityTable, AWallThatLeansMoreAndMoreTurnsThePlateOneWayAtTheSpeedOfItsBead) {
  constexpr double kStepS = 150.0 * 5.0 * kDegree / 8.0;
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  std::vector<Station> wall;
  for (int i = 0; i <= 72 * 30; ++i)
    wall.push_back(stationAt(0.4 + 5.0 * i * kDegree, i / (72.0 * 30.0) * 60.0 * kDegree, kStepS));
  const std::vector<TableValues> values = tableValues(gravityTable(*model), wall, {kCone, 0.0});
  const double sense = values.back().turn > values.front().turn ? 1.0 : -1.0;
  for (std::size_t i = 1; i < wall.size(); ++i) {
    EXPECT_LT(offDown(*model, wall[i], values[i]), kCone + 1e-9);
    EXPECT_GE(sense * (values[i].turn - values[i - 1].turn), -1e-9) << i;
    if (i <= 72 * 10) continue;  // a lean of 20 deg
    EXPECT_NEAR(sense * toDegrees(values[i].turn - values[i - 1].turn) / kStepS, 3.056, 0.05) << i;
  }
}

TEST(GravityTable, NozzlesThatPointDownLeaveTheTableWhereItStood) {
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  for (const TableValues& values :
       tableValues(gravityTable(*model), ringLeaning(0.0), {kCone, 25.0 * kDegree})) {
    EXPECT_NEAR(values.tilt, 0.0, 1e-9);
    EXPECT_NEAR(values.turn, 25.0 * kDegree, 1e-12);
  }
}

TEST(GravityTable, LeansWithinHalfTheConeTiltTheTableSteadily) {
  // Leans swing by 4 deg about 30 deg; half of the cone is 5 deg, so the tilt stays at 30 deg between the
  // ends.
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  std::vector<Station> stations;
  for (int i = 0; i <= 40; ++i)
    stations.push_back(stationAt(0.1 * i, (30.0 + 4.0 * std::sin(M_PI * i / 4.0)) * kDegree));
  for (const TableValues& values : tableValues(gravityTable(*model), stations, {kCone, 0.0}))
    EXPECT_NEAR(std::abs(values.tilt), 30.0 * kDegree, 1e-6);
}

TEST(GravityTable, EveryNozzlePointsDownWithinTheCone) {
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  const GravityTable table = gravityTable(*model);
  EXPECT_TRUE(rc::check([&] {
    const double cone = test::anyNumber(0.5, 30.0) * kDegree;
    std::vector<Station> stations;
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i)
      stations.push_back(stationAt(test::anyNumber(-3.1, 3.1), test::anyNumber(0.0, 120.0) * kDegree,
                                   test::anyNumber(0.01, 2.0)));
    const std::vector<TableValues> values = tableValues(table, stations, {cone, 0.3});
    for (std::size_t i = 0; i < stations.size(); ++i)
      RC_ASSERT(offDown(*model, stations[i], values[i]) <= cone + 1e-6);
  }));
}

TEST(GravityTable, TiltsToTheSideThatItsLimitsAllow) {
  const auto towards = kinematicModelFromUrdf(test::tiltingArm({"-0.2", "2.3"}));
  const auto away = kinematicModelFromUrdf(test::tiltingArm({"-2.3", "0.2"}));
  for (const TableValues& values :
       tableValues(gravityTable(*towards), ringLeaning(40.0 * kDegree), {kCone, 0.0}))
    EXPECT_NEAR(values.tilt, 40.0 * kDegree, 1e-9);
  for (const TableValues& values :
       tableValues(gravityTable(*away), ringLeaning(40.0 * kDegree), {kCone, 0.0}))
    EXPECT_NEAR(values.tilt, -40.0 * kDegree, 1e-9);
}

TEST(GravityTable, TiltsToTheSideOnWhichTheTipIsNearerToTheArm) {
  // The table stands before the arm, which is at x = 0: the tip of a wall that leans stays on that side.
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  const std::vector<Station> ring = ringLeaning(40.0 * kDegree);
  const std::vector<TableValues> values = tableValues(gravityTable(*model), ring, {kCone, 0.0});
  JointValues joints = JointValues::Zero(8);
  joints[6] = values[9].tilt;
  joints[7] = values[9].turn;
  const auto links = model->bedFromLinks(joints);
  const Eigen::Isometry3d base_from_bed = links.at("base_link").inverse();
  EXPECT_LT((base_from_bed * ring[9].position).head<2>().norm(),
            base_from_bed.translation().head<2>().norm());
}

TEST(GravityTable, OtherTablesAreRefusedByName) {
  EXPECT_THROW(gravityTable(*kinematicModelByName("irb_4600_turntable")), InvalidConfig);
  EXPECT_THROW(gravityTable(*kinematicModelByName("five_axis_head_table")), InvalidConfig);
  try {
    gravityTable(*kinematicModelFromUrdf(test::tiltingArm({}, "0 1 0")));
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("parallel"), std::string::npos) << error.what();
  }
}

/// A bead once around.
Toolpath ringToolpath(double lean) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 10.0;
  path.bead = Bead{3.0, 1.0};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 36; ++i) {
    const Station station = stationAt(10.0 * i * kDegree, lean);
    path.points.push_back(station.position);
    nozzles.push_back(station.orientation);
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return {"ring", {{10.0, 1.0, {path}}}};
}

TEST(GravityTable, LimitsThatNoSideKeepsAreReportedByTheJoint) {
  const auto model = kinematicModelFromUrdf(test::tiltingArm({"-0.3", "0.3"}));
  JointPathSettings settings;
  settings.external = ExternalChoice::Gravity;
  NoProgress nobody;
  const JointPath path =
      planJointPath(ringToolpath(40.0 * kDegree), Eigen::Isometry3d::Identity(), *model, settings, nobody);
  ASSERT_FALSE(path.faults.empty());
  EXPECT_EQ(path.faults.front().fault, JointFault::OutOfLimits);
  EXPECT_NE(path.faults.front().reason.find("external_1"), std::string::npos) << path.faults.front().reason;
}

TEST(GravityTable, HeldAxesStandAtTheirValue) {
  const auto model = kinematicModelFromUrdf(test::tiltingArm());
  JointPathSettings settings;
  settings.external_deg = 10.0;
  std::vector<Station> stations = ringLeaning(0.3);
  setExternalAxes(stations, *model, settings);
  ASSERT_FALSE(stations.empty());
  for (const Station& station : stations) {
    EXPECT_NEAR(station.external[0], 10.0 * kDegree, 1e-12);
    EXPECT_NEAR(station.external[1], 10.0 * kDegree, 1e-12);
    EXPECT_EQ(station.external[2], 0.0);
  }
}

}  // namespace
}  // namespace lamina
