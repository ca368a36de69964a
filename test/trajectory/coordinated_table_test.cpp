// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An arm of meshes over a positioner that tilts and turns: the cell of examples/robots/tilting_cell.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "support/tilting_arm.hpp"

namespace lamina {
namespace {

constexpr double kFeed = 8.0;     // mm/s
constexpr double kRadius = 60.0;  // mm
constexpr int kSides = 72;

/// Rings above each other, each leaning out by 15 deg more than the one below, deposited without a travel.
Toolpath leaningRings(int count) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = kFeed;
  path.bead = Bead{3.0, 1.0};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= count * kSides; ++i) {
    const double azimuth = 2.0 * M_PI * i / kSides;
    const double lean = 15.0 * kDegree * i / kSides;
    path.points.emplace_back(kRadius * std::cos(azimuth), kRadius * std::sin(azimuth),
                             1.0 + 2.0 * i / kSides);
    nozzles.push_back(test::nozzleOnWall(azimuth, lean));
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return {"rings", {{1.0, 1.0, {path}}}};
}

std::unique_ptr<KinematicModel> tiltingCell() {
  return kinematicModelFromUrdf(
      readMachineDescription(std::string(LAMINA_SOURCE_DIR) + "/examples/robots/tilting_cell/cell.yaml"));
}

class CoordinatedTable : public testing::Test {
 protected:
  CoordinatedTable() : model_(tiltingCell()) {
    settings_.external = ExternalChoice::Gravity;
    settings_.external_cone_deg = 10.0;
    settings_.yaw_samples = 36;
  }

  DividedJointPath planned() const {
    NoProgress nobody;
    return planDividedJointPath(leaningRings(4), Eigen::Isometry3d::Identity(), *model_, settings_, nobody);
  }

  /// How far the tool axis is from straight down in the room.
  double offDown(const JointValues& values) const {
    const Eigen::Isometry3d root_from_bed = model_->bedFromLinks(values).at("cell_world").inverse();
    const Point3 tool_axis = root_from_bed.linear() * model_->bedFromNozzle(values).linear().col(2);
    return std::atan2(tool_axis.head<2>().norm(), -tool_axis.z());
  }

  std::unique_ptr<KinematicModel> model_;
  JointPathSettings settings_;
};

/// When the process is on and the tip sets out [s].
double firstMotion(const TimedPath& timed) {
  double time_s = 0.0;
  while (timed.at(time_s).tip_speed_mm_s < 0.1 && time_s < timed.duration()) time_s += 0.01;
  return time_s;
}

TEST_F(CoordinatedTable, NozzlesPointDownAndThePlateTurnsOneWayOnly) {
  const DividedJointPath planned = this->planned();
  ASSERT_TRUE(planned.joints.isRunnable()) << planned.joints.faults.front().reason;
  const auto& values = planned.joints.values;
  const double sense = values.back()[7] > values.front()[7] ? 1.0 : -1.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_LE(offDown(values[i]), 10.0 * kDegree + 1e-6);
    if (i > 0) {
      EXPECT_GE(sense * (values[i][7] - values[i - 1][7]), -1e-9);
    }
  }
  EXPECT_NEAR(std::abs(values.back()[6]), 60.0 * kDegree, 1e-6);
}

TEST_F(CoordinatedTable, TheTipGoesAtItsFeedOverThePartThatTurns) {
  const DividedJointPath planned = this->planned();
  ASSERT_TRUE(planned.joints.isRunnable()) << planned.joints.faults.front().reason;
  const TimedPath timed(planned.divided.toolpath, planned.joints, *model_, TimingSettings());
  // By forward kinematics, away from the ramps at both ends; 0.05 s are 0.4 mm of the way.
  constexpr double kStep = 0.05;
  const auto tipAt = [&](double t) -> Point3 {
    return model_->bedFromNozzle(timed.at(t).position).translation();
  };
  const double begin_s = firstMotion(timed) + 2.0;
  const double end_s = timed.stationTimes().back() - 2.0;
  double turned = 0.0;
  for (double t = begin_s; t + kStep < end_s; t += kStep) {
    EXPECT_NEAR((tipAt(t + kStep) - tipAt(t)).norm() / kStep, kFeed, 0.005 * kFeed) << "at " << t << " s";
    turned += std::abs(timed.at(t + kStep).position[7] - timed.at(t).position[7]);
  }
  // Where the wall leans by more than the cone the plate follows it: some three of four rings.
  EXPECT_GT(turned, 5.0 * M_PI);
}

TEST_F(CoordinatedTable, WithTheTableHeldTheNozzleLeavesTheCone) {
  settings_.external = ExternalChoice::Held;
  const DividedJointPath planned = this->planned();
  double furthest = 0.0;
  for (const JointValues& values : planned.joints.values)
    if (values.size() > 0) furthest = std::max(furthest, offDown(values));
  EXPECT_TRUE(!planned.joints.isRunnable() || furthest > 50.0 * kDegree);
}

}  // namespace
}  // namespace lamina
