// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {
namespace {

constexpr double kRadians = M_PI / 180.0;
constexpr double kBeltMachineRoundTrip = 1e-9;  // mm

/// The belt printer with its gantry at another angle.
CartesianMachine beltMachine(double angle_deg) {
  std::string text = machineByName("belt_45").urdf;
  const std::string angle = "rpy=\"0.785398163397448 0 0\"";
  char turned[64];
  std::snprintf(turned, sizeof turned, "rpy=\"%.17g 0 0\"", angle_deg * kRadians);
  return machineFromUrdf(text.replace(text.find(angle), angle.size(), turned));
}

TEST(BeltMachine, MovesUpTheInclineAndCarriesThePartAlongTheBelt) {
  const CartesianMachine machine = machineByName("belt_45");
  const Eigen::Isometry3d bed_from_nozzle = bedFromNozzle(machine, {10, 20, 30});
  EXPECT_TRUE(bed_from_nozzle.translation().isApprox(Point3(10, 20 * M_SQRT1_2 - 30, 20 * M_SQRT1_2), 1e-9));
  EXPECT_TRUE(bed_from_nozzle.linear().col(2).isApprox(Point3(0, M_SQRT1_2, -M_SQRT1_2), 1e-9));
}

TEST(BeltMachine, ShearsByTheCotangentOfItsAngle) {
  for (const double angle : {15.0, 30.0, 45.0, 60.0, 75.0}) {
    const Point3 point(12.0, -7.0, 5.0);
    const AxisValues values = axesFromBed(beltMachine(angle)) * point;
    EXPECT_NEAR(values.x(), 12.0, 1e-9) << angle;
    EXPECT_NEAR(values.y(), 5.0 / std::sin(angle * kRadians), 1e-9) << angle;
    EXPECT_NEAR(values.z(), 7.0 + 5.0 / std::tan(angle * kRadians), 1e-9) << angle;
  }
}

TEST(BeltMachine, CoordinatesComeBackAtAnyAngle) {
  EXPECT_TRUE(rc::check("bed to axes and back", [](std::uint64_t seed) {
    Random random(seed);
    const Eigen::Affine3d axes_from_bed = programFromBed(beltMachine(random.uniform(15.0, 75.0)));
    const Point3 point(random.uniform(0.0, 300.0), random.uniform(-1e4, 0.0), random.uniform(0.0, 200.0));
    RC_ASSERT((axes_from_bed.inverse() * (axes_from_bed * point) - point).norm() < kBeltMachineRoundTrip);
  }));
}

TEST(BeltMachine, TheBeltStandsStillInPlanesOfTheGantry) {
  EXPECT_TRUE(rc::check("one value of the belt for a plane", [](std::uint64_t seed) {
    Random random(seed);
    const double angle = random.uniform(15.0, 75.0);
    const CartesianMachine machine = beltMachine(angle);
    const Point3 up_the_incline(random.uniform(-100.0, 100.0), std::cos(angle * kRadians),
                                std::sin(angle * kRadians));
    const Point3 start(0.0, random.uniform(-1e3, 0.0), 0.0);
    const double there = axisValues(machine, start + up_the_incline).z();
    RC_ASSERT(std::abs(there - axisValues(machine, start).z()) < kBeltMachineRoundTrip);
  }));
}

TEST(BeltMachine, ItsBeltHasNoEnd) {
  const CartesianMachine machine = machineByName("belt_45");
  EXPECT_TRUE(isEndless(machine.axes[2]));
  EXPECT_FALSE(isEndless(machine.axes[0]));
  const Eigen::Isometry3d far = bedFromNozzle(machine, {10, 20, 5e6});
  EXPECT_NEAR(axisValues(machine, far.translation()).z(), 5e6, 1e-6);
}

}  // namespace
}  // namespace lamina
