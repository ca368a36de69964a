// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/machine_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const MachineBody& bodyOf(const std::vector<MachineBody>& bodies, const std::string& link) {
  const auto found =
      std::find_if(bodies.begin(), bodies.end(), [&](const MachineBody& body) { return body.link == link; });
  if (found == bodies.end()) throw InvalidInput("no body of link " + link);
  return *found;
}

/// Lowest point of a body over the bed when the nozzle tip is there [mm].
double lowest(const MachineBody& body, const CartesianMachine& machine, const Point3& tip) {
  const Point3 origin = body.bed_from_body_at_zero.translation() + body.motion * axisValues(machine, tip);
  const Point3 down = body.bed_from_body_at_zero.linear().transpose() * -Point3::UnitZ();
  return origin.z() - extent(body.shape, down);
}

/// A gantry whose nozzle has this collision element.
std::string machineWith(const std::string& collision) {
  std::string text = machineByName("cartesian_gantry").urdf;
  const std::string name = "<link name=\"nozzle\">";
  return text.insert(text.find(name) + name.size(), collision);
}

std::string failureOf(const std::string& urdf) {
  try {
    movingBodies(machineFromUrdf(urdf));
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

TEST(MachineBodies, EveryMachineHasAConeThatStandsOnItsTip) {
  for (const std::string& name : machineNames()) {
    const CartesianMachine machine = machineByName(name);
    std::size_t cones = 0;
    for (const MachineBody& body : movingBodies(machine)) {
      if (body.link != "nozzle" || !std::holds_alternative<ConeShape>(body.shape)) continue;
      ++cones;
      const double half_length = 0.5 * std::get<ConeShape>(body.shape).length_mm;
      for (const Point3& tip : {Point3(0, 0, 0), Point3(10, 20, 30)}) {
        const Eigen::Isometry3d bed_from_body =
            Eigen::Translation3d(body.motion * axisValues(machine, tip)) * body.bed_from_body_at_zero;
        EXPECT_LT((bed_from_body * Point3(0, 0, half_length) - tip).norm(), 1e-9) << name;
      }
    }
    EXPECT_EQ(cones, 1U) << name;
  }
}

TEST(MachineBodies, NoneReachesBelowTheTipWhereverItIs) {
  for (const std::string& name : machineNames()) {
    const CartesianMachine machine = machineByName(name);
    for (const MachineBody& body : movingBodies(machine))
      for (const Point3& tip : {Point3(0, 0, 0), Point3(100, 50, 100)})
        EXPECT_GT(lowest(body, machine, tip), tip.z() - 1e-9) << name << " " << body.link;
  }
}

TEST(MachineBodies, ALinkFollowsTheAxesThatCarryIt) {
  const std::vector<MachineBody> bodies = movingBodies(machineByName("cartesian_gantry"));
  Eigen::Matrix3d of_gantry = Eigen::Matrix3d::Zero();
  of_gantry(1, 1) = 1.0;
  EXPECT_TRUE(bodyOf(bodies, "gantry").motion.isApprox(of_gantry));
  EXPECT_TRUE(bodyOf(bodies, "head").motion.isApprox(Eigen::Matrix3d::Identity()));
  // Where the bed moves, what stands still moves over it.
  const std::vector<MachineBody> over_table = movingBodies(machineByName("drop_printer"));
  EXPECT_TRUE(bodyOf(over_table, "head").motion.isApprox(Eigen::Matrix3d::Identity()));
}

TEST(MachineBodies, ExtentsAreThoseOfTheSolids) {
  const Point3 slant = Point3(1, 0, 1).normalized();
  EXPECT_NEAR(extent(BoxShape{{2, 4, 6}}, Point3::UnitZ()), 3.0, 1e-12);
  EXPECT_NEAR(extent(BoxShape{{2, 4, 6}}, slant), 4.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(extent(CylinderShape{2, 6}, slant), 5.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(extent(SphereShape{2}, slant), 2.0, 1e-12);
  // Apex at (0, 0, 3), base of radius 2 at z = -3.
  EXPECT_NEAR(extent(ConeShape{2, 6}, slant), 3.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(extent(ConeShape{2, 6}, -slant), 5.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(extent(ConeShape{2, 6}, Point3::UnitX()), 2.0, 1e-12);
}

TEST(MachineBodies, ABoundingSphereReachesTheFarthestCorner) {
  EXPECT_NEAR(boundingRadius(BoxShape{{2, 4, 4}}), 3.0, 1e-12);
  EXPECT_NEAR(boundingRadius(ConeShape{3, 8}), std::sqrt(9.0 + 9.0 + 16.0), 1e-12);  // of the box round it
}

TEST(MachineBodies, AMeshOrASizeOfNothingIsRefused) {
  EXPECT_EQ(failureOf(machineWith("<collision><geometry><mesh filename=\"a.stl\"/></geometry></collision>")),
            "collision of link 'nozzle' is the mesh 'a.stl'; expected file:// and an absolute path");
  EXPECT_NE(failureOf(machineWith("<collision><geometry><sphere radius=\"0\"/></geometry></collision>"))
                .find("has a size of 0 m"),
            std::string::npos);
}

}  // namespace
}  // namespace lamina
