// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/gravity_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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
    if (i <= 720) continue;  // a lean of 20 deg
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

constexpr double kPlateLimit = 200.0 * kDegree;

/// A positioner whose plate turns by 200 deg to either side, with the bed 50 mm above the middle of its
/// plate.
std::unique_ptr<KinematicModel> limitedTable() {
  std::string urdf = test::tiltingArm({"-2.3", "2.3", "3.490658503988659"});
  const std::string aside = "xyz=\"0.8 0.1 0.05\" rpy=\"0 0 0.3\"";
  urdf.replace(urdf.find(aside), aside.size(), "xyz=\"0 0 0.05\"");
  return kinematicModelFromUrdf(urdf);
}

// Seen along the tilt's axis the wall under the nozzle has to be on the side of the arm, which is at -x: at
// an azimuth a the plate is at 180 deg - a. A ring from 0 deg on turns it from 180 to -180 deg. Rings that
// lean by little more than the cone leave the plate room to lag by most of a turn, which later ones must not.
TEST(GravityTable, APlateWithLimitsIsTurnedBackBetweenRingsAndNeverOnOne) {
  const auto model = limitedTable();
  const std::vector<double> leans{0.0, 12.0, 14.0, 20.0, 45.0, 60.0};
  std::vector<Station> wall;
  for (const double lean : leans) {
    std::vector<Station> ring = ringLeaning(lean * kDegree, 0.0);
    ring.front().motion.way = StationWay::ClearTravel;
    wall.insert(wall.end(), ring.begin(), ring.end());
  }
  const std::vector<TableValues> values = tableValues(gravityTable(*model), wall, {kCone, 0.0});
  ASSERT_EQ(values.size(), 73 * leans.size());
  for (std::size_t i = 0; i < wall.size(); ++i) {
    EXPECT_LE(offDown(*model, wall[i], values[i]), kCone + 1e-9) << i;
    EXPECT_LE(std::abs(values[i].turn), kPlateLimit + 1e-9) << i;
    if (wall[i].motion.way == StationWay::ClearTravel) continue;
    EXPECT_LE(values[i].turn - values[i - 1].turn, 1e-9) << i;
  }
  for (const std::size_t ring : {3U, 4U, 5U}) {
    EXPECT_NEAR(toDegrees(values[73 * ring].turn), 180.0, 1e-6);
    EXPECT_NEAR(toDegrees(values[73 * ring + 72].turn), -180.0, 1e-6);
  }
}

// Half a ring that stands upright leaves the plate where it is, at -180 deg; the other half begins at 0 deg.
// The travel between them does not lift the nozzle off the part.
TEST(GravityTable, APlateWithLimitsIsTurnedBackOnLiftedTravelsWhereTheseAreEnough) {
  const auto model = limitedTable();
  std::vector<Station> wall;
  const auto addHalves = [&wall](double first_lean, double second_lean) {
    std::vector<Station> ring = ringLeaning(first_lean, 0.0);
    const std::vector<Station> second = ringLeaning(second_lean, 0.0);
    std::copy(second.begin() + 37, second.end(), ring.begin() + 37);
    ring[0].motion.way = ring[37].motion.way = StationWay::ClearTravel;
    ring[0].motion.lift_mm = 5.0;
    wall.insert(wall.end(), ring.begin(), ring.end());
  };
  for (const double lean : {0.0, 12.0, 14.0, 20.0, 45.0}) addHalves(lean * kDegree, lean * kDegree);
  addHalves(0.0, 45.0 * kDegree);
  const std::vector<TableValues> values = tableValues(gravityTable(*model), wall, {kCone, 0.0});
  for (std::size_t i = 0; i < wall.size(); ++i) {
    EXPECT_LE(offDown(*model, wall[i], values[i]), kCone + 1e-9) << i;
    EXPECT_LE(std::abs(values[i].turn), kPlateLimit + 1e-9) << i;
    if (wall[i].motion.lift_mm > 0.0) continue;
    EXPECT_LE(values[i].turn - values[i - 1].turn, 1e-9) << i;
  }
}

// From an azimuth of 30 deg on the plate would have to turn from 150 to -210 deg, which is 10 deg beyond its
// limit. At a lean of 45 deg that is acos(1/2 + 1/2 cos 10 deg) = 7.07 deg off straight down.
TEST(GravityTable, APlateAtItsLimitLagsWithinTheCone) {
  const auto model = limitedTable();
  const std::vector<Station> ring = ringLeaning(45.0 * kDegree, 30.0 * kDegree);
  const std::vector<TableValues> values = tableValues(gravityTable(*model), ring, {kCone, 0.0});
  EXPECT_NEAR(toDegrees(values.front().turn), 150.0, 1e-6);
  EXPECT_NEAR(toDegrees(values.back().turn), -200.0, 1e-6);
  EXPECT_NEAR(toDegrees(offDown(*model, ring.back(), values.back())), 7.066, 1e-3);
  for (std::size_t i = 1; i < ring.size(); ++i) EXPECT_LT(values[i].turn, values[i - 1].turn) << i;
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
Path ringPath(double lean, double first_azimuth = 0.0) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 10.0;
  path.bead = Bead{3.0, 1.0};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 36; ++i) {
    const Station station = stationAt(first_azimuth + 10.0 * i * kDegree, lean);
    path.points.push_back(station.position);
    nozzles.push_back(station.orientation);
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return path;
}

Toolpath ringToolpath(double lean) { return {"ring", {{10.0, 1.0, {ringPath(lean)}}}}; }

/// Rings of growing lean that begin at an azimuth, each a layer, with travels 20 mm above between them.
Toolpath wallToolpath(const std::vector<double>& leans_deg, double first_azimuth) {
  Toolpath wall{"wall", {}};
  for (const double lean : leans_deg) {
    Path ring = ringPath(lean * kDegree, first_azimuth);
    const double z = 1.0 + static_cast<double>(wall.layers.size());
    for (Point3& point : ring.points) point.z() = z;
    ToolpathLayer layer{z, 1.0, {}};
    if (!wall.layers.empty()) {
      const Path& before = wall.layers.back().paths.back();
      Path travel;
      travel.role = PathRole::Travel;
      travel.feed_mm_s = 50.0;
      const Point3 up(0.0, 0.0, 20.0);
      travel.points = {before.points.back(), before.points.back() + up, ring.points.front() + up,
                       ring.points.front()};
      const Eigen::Quaterniond from = before.orientation.at(0);
      const Eigen::Quaterniond to = ring.orientation.at(0);
      travel.orientation = AlongPath<Eigen::Quaterniond>({from, from, to, to});
      layer.paths.push_back(std::move(travel));
    }
    layer.paths.push_back(std::move(ring));
    wall.layers.push_back(std::move(layer));
  }
  return wall;
}

JointPath jointsOfWall(double first_azimuth_deg) {
  JointPathSettings settings;
  settings.external = ExternalChoice::Gravity;
  NoProgress nobody;
  const Toolpath wall = wallToolpath({0.0, 12.0, 20.0, 40.0}, first_azimuth_deg * kDegree);
  return planJointPath(wall, Eigen::Isometry3d::Identity(), *limitedTable(), settings, nobody);
}

TEST(GravityTable, AWallIsLaidWithinTheLimitsOfItsPlate) {
  const JointPath path = jointsOfWall(0.0);
  ASSERT_TRUE(path.isRunnable()) << path.faults.front().reason;
  EXPECT_GE(path.rewinds, 1U);
  for (std::size_t i = 1; i < path.at.size(); ++i) {
    EXPECT_LE(std::abs(path.values[i][7]), kPlateLimit + 1e-9) << i;
    const bool is_bead = path.at[i].path == (path.at[i].layer == 0 ? 0U : 1U) && path.at[i].waypoint > 0;
    if (is_bead) {
      EXPECT_LE(path.values[i][7] - path.values[i - 1][7], 1e-9) << i;
    }
  }
}

// From 180 deg on the plate would have to turn from 180 to -180 deg on one side, and from 0 to -360 deg on
// the other: one of them fits, as from 0 deg.
TEST(GravityTable, AWallThatFitsTiltedToTheOtherSideIsLaid) {
  const JointPath path = jointsOfWall(180.0);
  ASSERT_TRUE(path.isRunnable()) << path.faults.front().reason;
  for (const JointValues& values : path.values) EXPECT_LE(std::abs(values[7]), kPlateLimit + 1e-9);
}

// From 90 deg on the plate would have to turn from 90 to -270 deg. The ring that leans by 40 deg lets it lag
// by acos((cos 10 - cos² 40) / sin² 40) = 15.6 deg. It fits if it begins 70 to 110 deg higher.
TEST(GravityTable, AWallThatBeginsWhereItDoesNotFitIsRefusedWithWhereItFits) {
  const JointPath path = jointsOfWall(90.0);
  ASSERT_FALSE(path.isRunnable());
  EXPECT_EQ(path.faults.front().fault, JointFault::JointUnwinding);
  EXPECT_NE(path.faults.front().reason.find("fits if it begins 70 deg to 110 deg higher"), std::string::npos)
      << path.faults.front().reason;
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
