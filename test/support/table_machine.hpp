// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

/// A machine whose table tilts about x and turns on that about z, under a nozzle that points straight down:
/// the place of the nozzle is Rx(a) Rz(c) times that over the bed.
class TableMachine : public KinematicModel {
 public:
  const std::string& name() const override { return name_; }
  const std::string& urdf() const override { return urdf_; }
  const std::vector<DrivenJoint>& joints() const override { return joints_; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Free; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& values) const override {
    Eigen::Isometry3d place(nozzleDown());
    place.translation() = Point3(values[0], values[1], values[2]);
    return machineFromBed(values[3], values[4]).inverse() * place;
  }
  /// Of the linear joints alone.
  Jacobian jacobian(const JointValues& values) const override {
    Jacobian columns = Jacobian::Zero(6, values.size());
    columns.topLeftCorner<3, 3>() = machineFromBed(values[3], values[4]).linear().transpose();
    return columns;
  }

  InverseSolutions solutions(const Eigen::Isometry3d& pose, const JointValues& near) const override {
    const Point3 up = -pose.linear().col(2);
    const double tilt = std::atan2(std::hypot(up.x(), up.y()), up.z());
    const bool is_upright = tilt < 1e-9;
    InverseSolutions found;
    for (const int branch : {0, 1}) {
      const double a = branch == 0 ? tilt : -tilt;
      const double c = is_upright ? near[4] : (branch == 0 ? 0.5 : -0.5) * M_PI - std::atan2(up.y(), up.x());
      JointValues values(5);
      values << machineFromBed(a, c) * pose.translation(), a, std::remainder(c, 2.0 * M_PI);
      if (branch == 0 || !is_upright) found.push_back({branch, values});
    }
    return found;
  }
  double singularityMargin(const JointValues& values) const override { return std::abs(std::sin(values[3])); }
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues&) const override { return {}; }
  std::map<std::string, double> urdfJoints(const JointValues&) const override { return {}; }

 private:
  static Eigen::Isometry3d machineFromBed(double a, double c) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(a, Point3::UnitX()) * Eigen::AngleAxisd(c, Point3::UnitZ()));
  }

  std::string name_ = "table";
  std::string urdf_;
  std::vector<DrivenJoint> joints_ = {{"x", JointKind::Linear, -500, 500, 200},
                                      {"y", JointKind::Linear, -500, 500, 200},
                                      {"z", JointKind::Linear, -500, 500, 200},
                                      {"a", JointKind::Rotary, -2, 2, 1},
                                      {"c", JointKind::Rotary, -50, 50, 2}};
};

/// The nearest joints at each waypoint, the table tilted one way.
inline JointPath jointsAlong(const Toolpath& toolpath, const KinematicModel& machine) {
  JointPath joints;
  JointValues last = JointValues::Zero(static_cast<Eigen::Index>(machine.joints().size()));
  const auto add = [&](const Path& path, const WaypointIndex& at) {
    Eigen::Isometry3d pose(path.orientation.at(at.waypoint));
    pose.translation() = path.points[at.waypoint];
    JointValues values = machine.solutions(pose, last)[0].values;
    for (Eigen::Index j = 3; j < values.size(); ++j)
      values[j] += 2.0 * M_PI * std::round((last[j] - values[j]) / (2.0 * M_PI));
    joints.at.push_back(at);
    joints.values.push_back(values);
    last = values;
  };
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      add(path, {l, p, 0});
      for (std::size_t m = 0; m < path.motionCount(); ++m) add(path, {l, p, path.motionEnd(m)});
    }
  return joints;
}

}  // namespace lamina::test
