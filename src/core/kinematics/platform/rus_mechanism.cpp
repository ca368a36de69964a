// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/dense_solvers.hpp"
#include "kinematics/platform/rus_from_urdf.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"
#include "lamina/kinematics/platform/rus_workspace.hpp"

namespace lamina {
namespace {

/// A 6-RUS platform that carries the nozzle over a bed that stands.
class RusKinematicModel final : public KinematicModel {
 public:
  RusKinematicModel(const urdf::ModelInterface& model, std::string text)
      : name_(model.getName()),
        urdf_(std::move(text)),
        links_(model),
        description_(rusDescription(model, links_)) {}

  const std::string& name() const override { return name_; }
  const std::string& urdf() const override { return urdf_; }
  const std::vector<DrivenJoint>& joints() const override { return description_.cranks; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Given; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& values) const override {
    return description_.base_from_bed.inverse() * pose(values) * description_.platform_from_nozzle;
  }

  Jacobian jacobian(const JointValues& values) const override {
    const Eigen::Isometry3d at = pose(values);
    const VelocityEquation equation = velocityEquation(description_.platform, at, values);
    const Matrix6 rates = solutionOf(equation.pose_rates, Matrix6(equation.crank_rates.asDiagonal()));
    const Eigen::Matrix3d bed_from_base = description_.base_from_bed.linear().transpose();
    const Point3 tip = at.linear() * description_.platform_from_nozzle.translation();
    Jacobian columns(6, 6);
    for (Eigen::Index j = 0; j < 6; ++j) {
      const Point3 turn = rates.col(j).tail<3>();
      columns.col(j) << bed_from_base * (rates.col(j).head<3>() + turn.cross(tip)), bed_from_base * turn;
    }
    return columns;
  }

  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& /*near*/) const override {
    const Eigen::Isometry3d at =
        description_.base_from_bed * bed_from_nozzle * description_.platform_from_nozzle.inverse();
    const auto cranks = crankAnglesIfReached(description_.platform, at);
    if (!cranks || !arePassiveJointsWithin(description_.platform, at, *cranks)) return {};
    return {InverseSolution{0, *cranks}};
  }

  double singularityMargin(const JointValues& values) const override {
    return singularityMargins(description_.platform, pose(values), values).least();
  }

  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const override {
    auto poses = links_.rootFromLinks(urdfJoints(values));
    const Eigen::Isometry3d bed_from_root = poses.at("bed").inverse();
    for (auto& [link, at] : poses) at = bed_from_root * at;
    return poses;
  }

  std::map<std::string, double> urdfJoints(const JointValues& values) const override {
    const RusPlatform& platform = description_.platform;
    const Eigen::Isometry3d at = pose(values);
    const Eigen::Isometry3d home_from_platform = platform.home.inverse() * at;
    const PlatformAngles angles = platformAngles(home_from_platform.linear());
    std::map<std::string, double> joints = {{"platform_x", home_from_platform.translation().x()},
                                            {"platform_y", home_from_platform.translation().y()},
                                            {"platform_z", home_from_platform.translation().z()},
                                            {"platform_a", angles.alpha},
                                            {"platform_b", angles.beta},
                                            {"platform_c", angles.gamma}};
    for (std::size_t i = 0; i < kLegs; ++i) {
      const std::string number = std::to_string(i + 1);
      const double crank = values[static_cast<Eigen::Index>(i)];
      const PassiveAngles passive = passiveAngles(platform.legs[i], at, crank);
      joints["crank_" + number] = crank;
      joints["universal_" + number + "_a"] = passive.fold;
      joints["universal_" + number + "_b"] = passive.lean;
    }
    return joints;
  }

 private:
  Eigen::Isometry3d pose(const JointValues& values) const {
    if (values.size() != 6)
      throw InvalidInput("platform '" + name_ + "' was given " + std::to_string(values.size()) +
                         " joint values; it has 6 cranks");
    return poseFromHome(description_.platform, values);
  }

  std::string name_;
  std::string urdf_;
  LinkTree links_;
  RusDescription description_;
};

}  // namespace

std::unique_ptr<KinematicModel> rusKinematicModel(const urdf::ModelInterface& model,
                                                  const std::string& text) {
  return std::make_unique<RusKinematicModel>(model, text);
}

}  // namespace lamina
