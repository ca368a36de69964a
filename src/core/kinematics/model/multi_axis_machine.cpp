// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/multi_axis_machine.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kinematics/model/serial_chain.hpp"
#include "kinematics/model/tool_axis_turner.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr double kLeastVolume = 1e-3;  // of the box that three axes of length 1 span
constexpr double kLeastSine = 1e-3;    // between what must not be parallel
constexpr std::size_t kMostRotaries = 2;

[[noreturn]] void refuse(const SerialChain& chain, const std::string& what) {
  throw InvalidConfig("machine '" + chain.name + "'" + what);
}

/// Indices of the rotary joints, that next to the bed first.
std::vector<int> rotariesOf(const SerialChain& chain) {
  std::vector<int> rotaries;
  for (const int j : chain.outward)
    if (chain.joints[static_cast<std::size_t>(j)].kind == JointKind::Rotary) rotaries.push_back(j);
  return rotaries;
}

ToolAxisTurner turnerOf(const SerialChain& chain) {
  ToolAxisTurner turner;
  for (const int j : rotariesOf(chain))
    turner.axes.push_back(chain.screws[static_cast<std::size_t>(j)].direction);
  turner.at_zero = chain.bed_from_nozzle_at_zero.linear().col(2);
  return turner;
}

/// The linear joints are the first.
Eigen::Matrix3d linearDirections(const SerialChain& chain, const JointValues& values) {
  return nozzleAndJoints(chain, values).directions.leftCols<3>();
}

/// Whether a rotary joint stands between linear ones, whose directions then change against each other.
bool turnsLinearAxes(const SerialChain& chain) {
  const auto is_rotary = [&](int j) {
    return chain.joints[static_cast<std::size_t>(j)].kind == JointKind::Rotary;
  };
  const auto first = std::find_if_not(chain.outward.begin(), chain.outward.end(), is_rotary);
  const auto last = std::find_if_not(chain.outward.rbegin(), chain.outward.rend(), is_rotary).base();
  return first < last && std::any_of(first, last, is_rotary);
}

JointValues zeroOf(const SerialChain& chain) {
  return JointValues::Zero(static_cast<Eigen::Index>(chain.joints.size()));
}

class MultiAxisMachine : public KinematicModel {
 public:
  explicit MultiAxisMachine(SerialChain chain)
      : chain_(std::move(chain)),
        rotaries_(rotariesOf(chain_)),
        turner_(turnerOf(chain_)),
        turns_linear_axes_(turnsLinearAxes(chain_)),
        volume_at_zero_(std::abs(linearDirections(chain_, zeroOf(chain_)).determinant())) {}

  const std::string& name() const override { return chain_.name; }
  const std::string& urdf() const override { return chain_.urdf; }
  const std::vector<DrivenJoint>& joints() const override { return chain_.joints; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Free; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& values) const override {
    return lamina::bedFromNozzle(chain_, values);
  }
  Jacobian jacobian(const JointValues& values) const override { return lamina::jacobian(chain_, values); }
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const override {
    return lamina::bedFromLinks(chain_, values);
  }
  std::map<std::string, double> urdfJoints(const JointValues& values) const override {
    return lamina::urdfJoints(chain_, values);
  }

  double singularityMargin(const JointValues& values) const override {
    const double margin = toolAxisMargin(turner_, anglesOf(values));
    if (!turns_linear_axes_) return margin;
    return std::min(margin, std::abs(linearDirections(chain_, values).determinant()) / volume_at_zero_);
  }

  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override {
    InverseSolutions found;
    for (const ToolAxisTurn& turn : toolAxisTurns(turner_, bed_from_nozzle.linear().col(2), anglesOf(near))) {
      // Both branches are the same where a joint is free, and planning asks for many values of it.
      if (!found.empty() && anglesOf(found.back().values) == turn.angles)
        found.push_back({turn.branch, JointValues(found.back().values)});
      else if (const auto values = turnedTo(turn.angles, bed_from_nozzle.translation()))
        found.push_back({turn.branch, *values});
    }
    return found;
  }

 private:
  /// The values that bring the tip to a point; nothing if the linear axes do not span space then.
  std::optional<JointValues> turnedTo(const Eigen::Vector2d& angles, const Point3& tip) const {
    JointValues values = zeroOf(chain_);
    for (std::size_t r = 0; r < rotaries_.size(); ++r)
      values[rotaries_[r]] = angles[static_cast<Eigen::Index>(r)];
    const NozzleAndJoints turned = nozzleAndJoints(chain_, values);
    const Eigen::Matrix3d directions = turned.directions.leftCols<3>();
    if (!(std::abs(directions.determinant()) > kLeastVolume)) return std::nullopt;
    const Point3 way = tip - turned.bed_from_nozzle.translation();
    values.head<3>() = directions.inverse() * way;
    return values;
  }

  Eigen::Vector2d anglesOf(const JointValues& values) const {
    Eigen::Vector2d angles = Eigen::Vector2d::Zero();
    for (std::size_t r = 0; r < rotaries_.size(); ++r)
      angles[static_cast<Eigen::Index>(r)] = values[rotaries_[r]];
    return angles;
  }

  SerialChain chain_;
  std::vector<int> rotaries_;  ///< that next to the bed first
  ToolAxisTurner turner_;
  bool turns_linear_axes_;
  double volume_at_zero_;
};

void requireKnownJoints(const SerialChain& chain) {
  for (const DrivenJoint& joint : chain.joints) {
    const std::string letters = joint.kind == JointKind::Linear ? "xyz" : "abc";
    if (joint.name.size() == 1 && letters.find(joint.name) != std::string::npos) continue;
    refuse(chain,
           ": joint '" + joint.name +
               "' moves; only prismatic joints x, y and z and rotary joints a, b and c are understood");
  }
}

void requireLinearAxes(const SerialChain& chain) {
  const auto linear = std::count_if(chain.joints.begin(), chain.joints.end(),
                                    [](const DrivenJoint& joint) { return joint.kind == JointKind::Linear; });
  if (linear != 3)
    refuse(chain,
           " has " + std::to_string(linear) + " linear axes between bed and nozzle; expected x, y and z");
  if (!(std::abs(linearDirections(chain, zeroOf(chain)).determinant()) > kLeastVolume))
    refuse(chain, ": the axes x, y and z do not span space");
}

void requireRotaryAxes(const SerialChain& chain) {
  const std::vector<int> rotaries = rotariesOf(chain);
  const auto nameOf = [&](std::size_t r) {
    return "'" + chain.joints[static_cast<std::size_t>(rotaries[r])].name + "'";
  };
  if (rotaries.empty()) return;
  if (rotaries.size() > kMostRotaries)
    refuse(chain, " has " + std::to_string(rotaries.size()) + " rotary joints; at most two are understood");
  const ToolAxisTurner turner = turnerOf(chain);
  if (rotaries.size() == 2 && sineBetween(turner.axes[0], turner.axes[1]) < kLeastSine)
    refuse(chain, ": the axes of joints " + nameOf(0) + " and " + nameOf(1) +
                      " are parallel; expected two that tilt the tool axis to any side");
  if (sineBetween(turner.axes.back(), turner.at_zero) < kLeastSine)
    refuse(chain, ": joint " + nameOf(rotaries.size() - 1) +
                      " turns about the tool axis; expected an axis that tilts it");
}

}  // namespace

std::unique_ptr<KinematicModel> multiAxisMachine(const urdf::ModelInterface& model, const std::string& text) {
  SerialChain chain = serialChain(model, text);
  requireKnownJoints(chain);
  requireLinearAxes(chain);
  requireRotaryAxes(chain);
  return std::make_unique<MultiAxisMachine>(std::move(chain));
}

}  // namespace lamina
