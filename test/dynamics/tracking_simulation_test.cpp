// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/tracking_simulation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Stays at home.
class HoldReference final : public TrackingReference {
 public:
  explicit HoldReference(double duration_s) : duration_s_(duration_s) {
    home_.pose = huntPlatform().home;
    home_.cranks = crankAngles(huntPlatform(), home_.pose);
  }
  double duration() const override { return duration_s_; }
  ReferenceState at(double) const override { return home_; }

 private:
  double duration_s_;
  ReferenceState home_;
};

TrackingSettings withoutReach() {
  TrackingSettings settings;
  settings.gains.reach = 0.0;
  return settings;
}

/// The solution of e'' + k1 e' + k2 e + k3 int e = 0 from e = 1, e' = 0, int e = 0: a sum over the poles.
double errorAfter(double time_s) {
  const auto roots = poles({});
  // The integral i of e has i = 0, i' = 1, i'' = 0 at the start.
  Eigen::Matrix3cd powers;
  for (int p = 0; p < 3; ++p)
    powers.col(p) << 1.0, roots[static_cast<std::size_t>(p)], std::pow(roots[static_cast<std::size_t>(p)], 2);
  const Eigen::Vector3cd shares = powers.partialPivLu().solve(Eigen::Vector3cd(0.0, 1.0, 0.0));
  std::complex<double> error = 0.0;
  for (int p = 0; p < 3; ++p) {
    const std::complex<double> root = roots[static_cast<std::size_t>(p)];
    error += shares[p] * root * std::exp(root * time_s);
  }
  return error.real();
}

Toolpath square(const Eigen::Quaterniond& held) {
  Path path;
  path.role = PathRole::OuterWall;
  path.is_closed = true;
  path.points = {{50, 50, 20}, {70, 50, 20}, {70, 70, 20}, {50, 70, 20}};
  path.orientation = held;
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 50.0;
  Toolpath toolpath;
  toolpath.layers.push_back({20.0, 0.2, {path}});
  return toolpath;
}

RusDescription hunt() { return rusDescriptionFromUrdf(readFile("urdf/rus_platform.urdf")); }

TEST(TrackingSimulation, ErrorFadesAsThePolesSay) {
  const HoldReference reference(0.6);
  TrackingSimulation simulation(reference, huntPlatform(), Point3::Zero(), withoutReach());
  CrankAngles start = reference.at(0.0).cranks;
  start[0] += 0.02;
  start[3] -= 0.01;
  simulation.startAt(start);
  while (!simulation.isFinished()) {
    simulation.step();
    const CrankAngles error = simulation.sample().error;
    EXPECT_NEAR(error[0], -0.02 * errorAfter(simulation.time()), 1e-6);
    EXPECT_NEAR(error[3], 0.01 * errorAfter(simulation.time()), 1e-6);
    EXPECT_NEAR(error[1], 0.0, 1e-9) << "the cranks are decoupled";
  }
  EXPECT_DOUBLE_EQ(simulation.time(), 0.6);
}

TEST(TrackingSimulation, HoldingTakesTheGravityTorquesAllTheTime) {
  const HoldReference reference(0.1);
  TrackingSimulation simulation(reference, huntPlatform(), Point3::Zero(), {});
  const double squares = simulation.sample().torque.squaredNorm();
  NoProgress nobody;
  const TrackingFigures report = simulateTracking(simulation, nobody);
  EXPECT_NEAR(report.control_energy_nm2_s, 0.1 * squares, 1e-9);
  EXPECT_NEAR(report.linear_ise_mm2_s, 0.0, 1e-15);
  EXPECT_NEAR(report.rotational_ise_rad2_s, 0.0, 1e-15);
  EXPECT_NEAR(report.duration_s, 0.1, 1e-12);
}

TEST(TrackingSimulation, PlaneSquareIsFollowedWithHardlyATurn) {
  const Toolpath toolpath = square(nozzleDown());
  MotionLimits limits;
  limits.acceleration_mm_s2 = 1000.0;
  const RusDescription platform = hunt();
  const ToolpathReference reference(toolpath, Eigen::Isometry3d::Identity(), limits, platform);
  // Four times 20 mm at 50 mm/s and 1000 mm/s².
  EXPECT_NEAR(reference.duration(), 4.0 * (20.0 / 50.0 + 0.05), 1e-9);
  NoProgress nobody;
  const TrackingFigures report = simulateTracking(
      TrackingSimulation(reference, platform.platform, platform.platform_from_nozzle.translation(), {}),
      nobody);
  EXPECT_GT(report.linear_ise_mm2_s, 0.0);
  EXPECT_LT(report.greatest_tip_error_mm, 2.0);
  EXPECT_LT(report.rotational_ise_rad2_s, 1e-4);
}

TEST(TrackingSimulation, ReferencesRatesAreTheSlopeOfItsCranks) {
  Toolpath toolpath = square(nozzleDown());
  std::vector<Eigen::Quaterniond> held;
  for (const double tilt : {0.0, 0.3, -0.2, 0.4})
    held.push_back(nozzleDown() *
                   Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Point3(1, 0.5, 0).normalized())));
  toolpath.layers[0].paths[0].orientation = AlongPath<Eigen::Quaterniond>(held);
  const ToolpathReference reference(toolpath, Eigen::Isometry3d::Identity(), {}, hunt());
  const double step = 1e-5;
  for (const double time : {0.02, 0.2, 0.6, 1.0, 1.5}) {
    const ReferenceState before = reference.at(time - step);
    const ReferenceState after = reference.at(time + step);
    EXPECT_LT(((after.cranks - before.cranks) / (2.0 * step) - reference.at(time).rates).norm(), 1e-4)
        << time;
  }
}

TEST(TrackingSimulation, ToolpathOutsideTheWorkspaceNamesWaypointAndLegs) {
  Toolpath toolpath = square(nozzleDown());
  toolpath.layers[0].paths[0].points[2] = Point3(700, 70, 20);
  try {
    const ToolpathReference reference(toolpath, Eigen::Isometry3d::Identity(), {}, hunt());
    FAIL() << "expected Unreachable";
  } catch (const Unreachable& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("layer 0, path 0, waypoint 2: leg "), std::string::npos) << message;
  }
}

TEST(TrackingSimulation, LoadThatTheControllerDoesNotKnowIsCarriedWithAnError) {
  const HoldReference reference(0.5);
  TrackingSettings settings;
  settings.unknown_load_kg = 0.2;
  NoProgress nobody;
  const TrackingFigures report =
      simulateTracking(TrackingSimulation(reference, huntPlatform(), Point3::Zero(), settings), nobody);
  EXPECT_GT(report.greatest_tip_error_mm, 1e-3);
  EXPECT_LT(report.greatest_tip_error_mm, 5.0);
}

}  // namespace
}  // namespace lamina
