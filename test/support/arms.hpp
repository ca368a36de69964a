// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lamina/base/random.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina::test {

/// A joint of a URDF and its child link; the parent is that of the joint before.
inline std::string rotaryJoint(const std::string& name, const std::string& parent, const std::string& origin,
                               const std::string& axis) {
  return "<link name=\"" + name + "_link\"/><joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" +
         parent + "\"/><child link=\"" + name + "_link\"/><origin " + origin + "/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-6.3\" upper=\"6.3\" velocity=\"3\" effort=\"1\"/></joint>";
}

inline std::string fixedJoint(const std::string& link, const std::string& parent, const std::string& origin) {
  return "<link name=\"" + link + "\"/><joint name=\"to_" + link + "\" type=\"fixed\"><parent link=\"" +
         parent + "\"/><child link=\"" + link + "\"/><origin " + origin + "/></joint>";
}

/// An arm of six joints, each as the origin and axis of its joint, with a bed and a nozzle.
struct ArmDescription {
  std::string origins[6];
  std::string axes[6];

  std::string urdf() const {
    std::string text = "<robot name=\"arm\"><link name=\"base_link\"/>";
    text += fixedJoint("bed", "base_link", "xyz=\"0.8 0.1 0.05\" rpy=\"0 0 0.3\"");
    std::string parent = "base_link";
    for (int j = 0; j < 6; ++j) {
      const std::string name = "joint_" + std::to_string(j + 1);
      text += rotaryJoint(name, parent, origins[j], axes[j]);
      parent = name + "_link";
    }
    return text + fixedJoint("nozzle", parent, "xyz=\"0.03 0.05 0.2\" rpy=\"0.3 0.5 0.1\"") + "</robot>";
  }
};

/// An arm whose axes 2, 3 and 4 are parallel; its last digits are rounded.
inline ArmDescription parallelAxesArm() {
  return {{"xyz=\"0 0 0.089159\"", "xyz=\"0 0.13585 0\" rpy=\"0 1.570796 0\"", "xyz=\"0 -0.1197 0.425\"",
           "xyz=\"0 0 0.39225\" rpy=\"0 1.570796 0\"", "xyz=\"0 0.093 0\"", "xyz=\"0 0 0.09465\""},
          {"0 0 1", "0 1 0", "0 1 0", "0 1 0", "0 0 1", "0 1 0"}};
}

/// An arm with a spherical wrist, as in urdf/irb_4600.urdf but with turned joints and rounded angles: axes
/// stand off by some 1e-5 rad.
inline ArmDescription roundedArm() {
  return {{"xyz=\"0 0 0.495\"", "xyz=\"0.175 0.02 0\" rpy=\"-1.5708 0 0\"", "xyz=\"0 -0.9 0\"",
           "xyz=\"0.3 -0.175 0.04\" rpy=\"0 1.5708 0\"", "xyz=\"0 0 0.66\" rpy=\"1.5708 0 0\"",
           "xyz=\"0 0 0\" rpy=\"-1.5708 0 0\""},
          {"0 0 1", "0 0 1", "0 0 -1", "0 0 1", "0 0 1", "0 0 -1"}};
}

/// The same without a rounded number.
inline ArmDescription exactParallelAxesArm() {
  return {{"xyz=\"0 0 0.1807\"", "xyz=\"0 0.176 0\"", "xyz=\"0.6127 -0.137 0\"", "xyz=\"0.57155 0 0\"",
           "xyz=\"0 0.135 0\"", "xyz=\"0 0 -0.12\""},
          {"0 0 1", "0 1 0", "0 1 0", "0 1 0", "0 0 -1", "0 1 0"}};
}

/// An arm whose axes 4 and 5 meet, and whose axis 6 is beside them along axis 5.
inline ArmDescription asideWristArm() {
  return {{"xyz=\"0 0 0.245\"", "xyz=\"0 0 0\"", "xyz=\"0 0 0.71\"", "xyz=\"0 0 0\"", "xyz=\"0.54 0 0\"",
           "xyz=\"0.16 -0.15 0\""},
          {"0 0 1", "0 1 0", "0 -1 0", "-1 0 0", "0 -1 0", "-1 0 0"}};
}

/// An arm whose axes 4 and 5 meet, and whose axis 6 is above them.
inline ArmDescription raisedWristArm() {
  return {{"xyz=\"0 0 0.265\"", "xyz=\"0 0 0\"", "xyz=\"0 0 0.444\"", "xyz=\"0 0 0.11\"", "xyz=\"0.47 0 0\"",
           "xyz=\"0.101 0 0.08\""},
          {"0 0 1", "0 1 0", "0 1 0", "1 0 0", "0 1 0", "1 0 0"}};
}

/// An arm of no class: its axes 4 and 5 are apart.
inline ArmDescription scatteredWristArm() {
  return {{"xyz=\"0 0 0.3\"", "xyz=\"0.1 0 0\"", "xyz=\"0 0 0.5\"", "xyz=\"0.1 0 0.1\"", "xyz=\"0.4 0 0.06\"",
           "xyz=\"0.1 0 0.08\""},
          {"0 0 1", "0 1 0", "0 1 0", "1 0 0", "0 1 0", "1 0 0"}};
}

/// An arm of seven joints that stands upright at zero, with a bed in front of it and a nozzle along axis 7.
/// Axes are z, y, z, -y, z, y, z.
struct SevenAxisDescription {
  std::array<std::string, 7> origins;  ///< "x y z" of each joint over the one before [m]
  std::array<double, 7> limits_deg = {170, 120, 170, 130, 170, 120, 175};
  std::string fourth_axis = "0 -1 0";
  std::string nozzle = "0 0 0.25";

  std::string urdf() const {
    std::string text = "<robot name=\"seven\"><link name=\"base_link\"/>";
    text += fixedJoint("bed", "base_link", "xyz=\"0.55 0 0.05\"");
    std::string parent = "base_link";
    for (std::size_t j = 0; j < origins.size(); ++j) {
      const std::string name = "axis_" + std::to_string(j + 1);
      const std::string limit = std::to_string(limits_deg[j] * M_PI / 180.0);
      text += "<link name=\"" + name + "_link\"/><joint name=\"" + name +
              "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" + name +
              "_link\"/><origin xyz=\"" + origins[j] + "\"/><axis xyz=\"" + axisOf(j) +
              "\"/><limit lower=\"-" + limit + "\" upper=\"" + limit +
              "\" velocity=\"2\" effort=\"1\"/></joint>";
      parent = name + "_link";
    }
    return text + fixedJoint("nozzle", parent, "xyz=\"" + nozzle + "\"") + "</robot>";
  }

 private:
  std::string axisOf(std::size_t joint) const {
    if (joint == 3) return fourth_axis;
    return joint % 2 == 0 ? "0 0 1" : "0 1 0";
  }
};

/// Axes 1 to 3 meet in the shoulder, axes 5 to 7 in the wrist, axes 3 and 5 in the elbow.
inline SevenAxisDescription sphericalSeven() {
  return {{"0 0 0.1", "0 0 0.24", "0 0 0.2", "0 0 0.21", "0 0 0.19", "0 0 0.2", "0 0 0.1"}};
}

/// The same over a plate, 300 mm square, on which parts are placed.
inline std::string sphericalSevenOverPlate() {
  std::string text = sphericalSeven().urdf();
  const std::string bed = "<link name=\"bed\"/>";
  return text.replace(text.find(bed), bed.size(),
                      "<link name=\"bed\"><collision><origin xyz=\"0 0 -0.01\"/><geometry><box size=\"0.3 "
                      "0.3 0.02\"/></geometry></collision></link>");
}

/// The same with its axes 2, 5 and 7 beside the points where they should meet, by up to 0.4 mm.
inline SevenAxisDescription nearlySphericalSeven() {
  return {{"0 0 0.1", "0.0004 0 0.24", "-0.0004 0 0.2", "0 0 0.21", "0.0002 0.0003 0.19", "0 0 0.2",
           "0 0.0003 0.1"}};
}

/// An arm whose elbow stands off axes 3 and 5, and whose axis 7 stands off the wrist.
inline SevenAxisDescription offsetSeven() {
  return {{"0 0 0.12", "0 0 0.2", "0 0 0.31", "0.07 0 0", "-0.07 0 0.36", "0 0 0", "0.06 0 -0.04"}};
}

/// An arm with a spherical wrist and a reach of 2050 mm (shoulder 150, 950 and 950 mm) on a rail along x
/// (external_1, 1500 mm/s) that begins at zero. Its nozzle is 300 mm from the wrist, along axis 6. The bed
/// is 700 mm beside the rail, with axes as the room's.
/// @param rail_end_m  upper limit of the rail
inline std::string carriedArm(const std::string& carriages, const std::string& tool = "") {
  std::string text = "<robot name=\"rail_arm\"><link name=\"room\"/>" +
                     fixedJoint("bed", "room", "xyz=\"0 0.7 0\"") + "<link name=\"base_link\"/>" + carriages;
  const std::string origins[6] = {"0 0 0.5", "0.15 0 0", "0 0 0.95", "0 0 0.5", "0 0 0.45", "0 0 0.1"};
  const std::string axes[6] = {"0 0 1", "0 1 0", "0 1 0", "0 0 1", "0 1 0", "0 0 1"};
  std::string parent = "base_link";
  for (int j = 0; j < 6; ++j) {
    const std::string name = "joint_" + std::to_string(j + 1);
    text += rotaryJoint(name, parent, "xyz=\"" + origins[j] + "\"", axes[j]);
    parent = name + "_link";
  }
  return text + tool + fixedJoint("nozzle", parent, "xyz=\"0 0 0.2\"") + "</robot>";
}

inline std::string linearJoint(const std::string& name, const std::string& parent_and_child,
                               const std::string& axis, const std::string& range) {
  return "<joint name=\"" + name + "\" type=\"prismatic\">" + parent_and_child + "<axis xyz=\"" + axis +
         "\"/><limit " + range + " velocity=\"1.5\" effort=\"1\"/></joint>";
}

inline std::string railArm(const std::string& rail_end_m = "6") {
  return carriedArm(linearJoint("external_1", "<parent link=\"room\"/><child link=\"base_link\"/>", "1 0 0",
                                "lower=\"0\" upper=\"" + rail_end_m + "\""));
}

/// The same arm on the trolley of a bridge, which runs along x, as the trolley does along y. It has a flange.
inline std::string gantryArm(const std::string& trolley = "0 1 0") {
  return carriedArm("<link name=\"bridge\"/>" +
                        linearJoint("external_1", "<parent link=\"room\"/><child link=\"bridge\"/>", "1 0 0",
                                    "lower=\"0\" upper=\"6\"") +
                        linearJoint("external_2", "<parent link=\"bridge\"/><child link=\"base_link\"/>",
                                    trolley, "lower=\"-1\" upper=\"4\""),
                    fixedJoint("tool0", "joint_6_link", "xyz=\"0 0 0\""));
}

/// Values in the ranges of the joints, and at most a turn.
inline JointValues anyJointValues(const KinematicModel& model, Random& random) {
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    values[j] = random.uniform(std::max(joint.low, -M_PI), std::min(joint.high, M_PI));
  }
  return values;
}

/// Distance of two poses: of the tips [m] or the turn [rad], whichever is greater.
inline double distance(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const double turn = (a.linear() - b.linear()).norm() / std::sqrt(2.0);
  return std::max(1e-3 * (a.translation() - b.translation()).norm(), turn);
}

/// Greatest difference of joint values but for whole turns.
inline double turnDistance(const JointValues& a, const JointValues& b) {
  return (a - b)
      .unaryExpr([](double angle) { return std::abs(std::remainder(angle, 2.0 * M_PI)); })
      .maxCoeff();
}

}  // namespace lamina::test
