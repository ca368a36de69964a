// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina::test {

/// A kinematic model written down by hand, without inverse kinematics.
class HandMadeModel : public KinematicModel {
 public:
  explicit HandMadeModel(std::vector<DrivenJoint> joints) : joints_(std::move(joints)) {}
  const std::string& name() const override { return name_; }
  const std::string& urdf() const override { return name_; }
  const std::vector<DrivenJoint>& joints() const override { return joints_; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Free; }
  InverseSolutions solutions(const Eigen::Isometry3d& /*pose*/, const JointValues& /*near*/) const override {
    return {};
  }
  double singularityMargin(const JointValues& /*values*/) const override { return 1.0; }
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& /*values*/) const override {
    return {};
  }
  std::map<std::string, double> urdfJoints(const JointValues& /*values*/) const override { return {}; }

 private:
  std::string name_ = "hand-made";
  std::vector<DrivenJoint> joints_;
};

/// Linear axes x, y, z [mm] and a head that tilts about x [rad], `tip_mm` above the tip.
class TiltingGantry final : public HandMadeModel {
 public:
  explicit TiltingGantry(double tip_mm = 100.0)
      : HandMadeModel({{"x", JointKind::Linear, -1e3, 1e3, 200.0},
                       {"y", JointKind::Linear, -1e3, 1e3, 150.0},
                       {"z", JointKind::Linear, -1e3, 1e3, 50.0},
                       {"a", JointKind::Rotary, -2.0, 2.0, 3.0}}),
        tip_mm_(tip_mm) {}
  Eigen::Isometry3d bedFromNozzle(const JointValues& q) const override {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() =
        (Eigen::AngleAxisd(q[3], Point3::UnitX()) * Eigen::Quaterniond(0, 1, 0, 0)).toRotationMatrix();
    pose.translation() = q.head<3>() + tip_mm_ * Point3(0, std::sin(q[3]), 1 - std::cos(q[3]));
    return pose;
  }
  Jacobian jacobian(const JointValues& q) const override {
    Jacobian j = Jacobian::Zero(6, 4);
    j.topLeftCorner<3, 3>().setIdentity();
    j.block<3, 1>(0, 3) = tip_mm_ * Point3(0, std::cos(q[3]), std::sin(q[3]));
    j(3, 3) = 1.0;
    return j;
  }
  /// Joints with the tip at a position and the head tilted.
  JointValues valuesAt(const Point3& tip, double tilt) const {
    JointValues q(4);
    q << tip - tip_mm_ * Point3(0, std::sin(tilt), 1 - std::cos(tilt)), tilt;
    return q;
  }

 private:
  double tip_mm_;
};

/// Two arms of 200 mm that turn in the plane, and a linear z.
class PlanarArm final : public HandMadeModel {
 public:
  PlanarArm()
      : HandMadeModel({{"j1", JointKind::Rotary, -3.0, 3.0, 2.0},
                       {"j2", JointKind::Rotary, -3.0, 3.0, 2.0},
                       {"z", JointKind::Linear, -500, 500, 100.0}}) {}
  Eigen::Isometry3d bedFromNozzle(const JointValues& q) const override {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() =
        (Eigen::AngleAxisd(q[0] + q[1], Point3::UnitZ()) * Eigen::Quaterniond(0, 1, 0, 0)).toRotationMatrix();
    pose.translation() << kArm * (std::cos(q[0]) + std::cos(q[0] + q[1])),
        kArm * (std::sin(q[0]) + std::sin(q[0] + q[1])), q[2];
    return pose;
  }
  Jacobian jacobian(const JointValues& q) const override {
    Jacobian j = Jacobian::Zero(6, 3);
    const Point3 tip = bedFromNozzle(q).translation();
    const Point3 elbow(kArm * std::cos(q[0]), kArm * std::sin(q[0]), q[2]);
    j.block<3, 1>(0, 0) = Point3::UnitZ().cross(tip);
    j.block<3, 1>(0, 1) = Point3::UnitZ().cross(tip - elbow);
    j(5, 0) = j(5, 1) = j(2, 2) = 1.0;
    return j;
  }
  JointValues valuesAt(const Point3& tip) const {
    const double reach2 = tip.head<2>().squaredNorm();
    JointValues q(3);
    q[1] = std::acos(reach2 / (2 * kArm * kArm) - 1.0);
    q[0] = std::atan2(tip.y(), tip.x()) - 0.5 * q[1];
    q[2] = tip.z();
    return q;
  }

 private:
  static constexpr double kArm = 200.0;
};

/// The joint path of a toolpath by an inverse of the tip's positions.
inline JointPath jointPathBy(const Toolpath& toolpath,
                             const std::function<JointValues(const Point3& tip)>& valuesAt) {
  JointPath path;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& run = toolpath.layers[l].paths[p];
      for (std::size_t w = 0; w <= run.motionCount(); ++w) {
        path.at.push_back({l, p, w % run.points.size()});
        path.values.push_back(valuesAt(run.points[w % run.points.size()]));
      }
    }
  return path;
}

/// That of a tilting gantry held upright.
inline JointPath uprightPath(const Toolpath& toolpath, const TiltingGantry& gantry) {
  return jointPathBy(toolpath, [&](const Point3& tip) { return gantry.valuesAt(tip, 0.0); });
}

}  // namespace lamina::test
