// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

/// A gantry x, y, z with a head that turns about z (joint c) and then tilts about x (joint a); if its tool
/// axis's spin is given, a last joint (spin) turns the nozzle about its tool axis. The tool axis is vertical
/// at a = 0, where c is free. The tip is `arm_mm` under the tilting axis.
class GantryHead : public KinematicModel {
 public:
  explicit GantryHead(ToolAxisSpin spin, double c_limit_deg = 200.0, double arm_mm = 0.0)
      : spin_(spin), arm_mm_(arm_mm) {
    for (const char* name : {"x", "y", "z"}) joints_.push_back({name, JointKind::Linear, -1000, 1000, 500});
    joints_.push_back(rotary("c", c_limit_deg));
    joints_.push_back(rotary("a", 100.0));
    if (spin == ToolAxisSpin::Given) joints_.push_back(rotary("spin", 400.0));
  }

  std::vector<DrivenJoint>& changedJoints() { return joints_; }

  const std::string& name() const override { return name_; }
  const std::string& urdf() const override { return name_; }
  const std::vector<DrivenJoint>& joints() const override { return joints_; }
  ToolAxisSpin toolAxisSpin() const override { return spin_; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& q) const override {
    Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
    const double spin = spin_ == ToolAxisSpin::Given ? q[5] : 0.0;
    bed_from_nozzle.linear() =
        (turn(q[3], 2) * turn(q[4], 0) * turn(spin, 2)) * nozzleDown().toRotationMatrix();
    const Point3 tool_axis = bed_from_nozzle.linear().col(2);
    bed_from_nozzle.translation() = Point3(q[0], q[1], q[2] + arm_mm_) + arm_mm_ * tool_axis;
    return bed_from_nozzle;
  }

  Jacobian jacobian(const JointValues& q) const override {
    Jacobian jacobian = Jacobian::Zero(6, q.size());
    jacobian.topLeftCorner<3, 3>().setIdentity();
    const Point3 lever = arm_mm_ * bedFromNozzle(q).linear().col(2);
    const std::vector<Point3> axes = {Point3::UnitZ(), turn(q[3], 2) * Point3::UnitX(),
                                      turn(q[3], 2) * turn(q[4], 0) * Point3::UnitZ()};
    for (Eigen::Index j = 3; j < q.size(); ++j) {
      const Point3& axis = axes[static_cast<std::size_t>(j - 3)];
      jacobian.col(j) << axis.cross(lever), axis;
    }
    return jacobian;
  }

  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override {
    const Eigen::Matrix3d head = bed_from_nozzle.linear() * nozzleDown().toRotationMatrix().transpose();
    const double sine = std::hypot(head(0, 2), head(1, 2));
    InverseSolutions found;
    for (int branch = 0; branch < 2; ++branch) {
      const double sign = branch == 0 ? 1.0 : -1.0;
      JointValues q = JointValues::Zero(near.size());
      const Point3 tool_axis = bed_from_nozzle.linear().col(2);
      q.head<3>() = bed_from_nozzle.translation() - arm_mm_ * tool_axis - Point3(0, 0, arm_mm_);
      q[3] = sine < 1e-12 ? near[3] : std::atan2(sign * head(0, 2), -sign * head(1, 2));
      q[4] = std::atan2(sign * sine, head(2, 2));
      const Eigen::Matrix3d last = (turn(q[3], 2) * turn(q[4], 0)).transpose() * head;
      if (spin_ == ToolAxisSpin::Given) q[5] = std::atan2(last(1, 0), last(0, 0));
      found.push_back({branch, q});
    }
    return found;
  }

  double singularityMargin(const JointValues& q) const override { return std::abs(std::sin(q[4])); }
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues&) const override { return {}; }
  std::map<std::string, double> urdfJoints(const JointValues&) const override { return {}; }

 private:
  static DrivenJoint rotary(const std::string& name, double limit_deg) {
    const double limit = limit_deg * M_PI / 180.0;
    return {name, JointKind::Rotary, -limit, limit, 3.0};
  }
  static Eigen::Matrix3d turn(double angle, int axis) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
  }

  std::string name_ = "gantry_head";
  ToolAxisSpin spin_;
  double arm_mm_;
  std::vector<DrivenJoint> joints_;
};

}  // namespace lamina::test
