// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/multi_axis_machine.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <vector>

#include "kinematics/model/serial_chain.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

/// The rotary joints of a machine as they turn its tool axis: one or two axes, that next to the bed first.
/// The tool axis is R(axis 0, angle 0) R(axis 1, angle 1) at_zero. All of unit length [bed frame].
struct ToolAxisTurner {
  std::vector<Point3> axes;          ///< with the joints at zero; two are not parallel
  Point3 at_zero = Point3::UnitZ();  ///< tool axis with the joints at zero; not along the last axis
};

/// Angles of two joints; that of a second one is 0 where there is one only [rad].
struct ToolAxisTurn {
  int branch =
      0;  ///< 0 or 1: on which side of the plane of both axes the tool axis stands, seen from the first
  Eigen::Vector2d angles = Eigen::Vector2d::Zero();  ///< in (-pi, pi]; one that is free is the `near` one
};

using ToolAxisTurns = boost::container::static_vector<ToolAxisTurn, 2>;

double sineBetween(const Point3& a, const Point3& b);

constexpr double kToolAxisTolerance = toRadians(0.01);  // far below what a head is built to
constexpr double kOnAxis = 1e-10;                       // sine: less than any pose is known to

/// A direction as seen along an axis. The part across it is kept beside that along it, since near the axis
/// the cosine no longer determines the angle.
struct AxisView {
  double along;
  Eigen::Vector2d across;
};

/// Frame of two axes: the first, what of the second stands across it, and the normal of both.
struct AxisFrame {
  explicit AxisFrame(const Point3& first, const Point3& second)
      : axis(first), normal(first.cross(second).normalized()), side(normal.cross(first)) {}
  AxisView view(const Point3& direction) const {
    return {direction.dot(axis), {direction.dot(side), direction.dot(normal)}};
  }
  Point3 direction(const AxisView& view) const {
    return view.along * axis + view.across.x() * side + view.across.y() * normal;
  }

  Point3 axis;
  Point3 normal;
  Point3 side;
};

double wrapped(double angle) {
  const double turned = std::remainder(angle, 2.0 * M_PI);
  return turned > -M_PI ? turned : M_PI;
}

/// Angle by which a turn about the axis brings one direction nearest to another (subproblem 1).
double angleAbout(const Point3& axis, const Point3& from, const Point3& to) {
  const Point3 start = from - axis.dot(from) * axis;
  return wrapped(std::atan2(axis.dot(start.cross(to)), start.dot(to)));
}

double angleOf(const Eigen::Vector2d& direction) { return std::atan2(direction.y(), direction.x()); }

bool isNear(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) <= kToolAxisTolerance;
}

/// Part along `side` of the tool axis between both turns: its height over the second axis is that at zero,
/// its height over the first that of the wanted one.
double sidePart(const ToolAxisTurner& turner, double along, double across) {
  const double cosine = turner.axes[0].dot(turner.axes[1]);
  const double height = turner.at_zero.dot(turner.axes[1]);
  // height - along * cosine, where 1 - |along| is known better than along.
  const double sense = along < 0.0 ? -1.0 : 1.0;
  const double short_of_axis = across * across / (1.0 + std::abs(along));
  return (height - sense * cosine + sense * short_of_axis * cosine) /
         sineBetween(turner.axes[0], turner.axes[1]);
}

/// Both ways by two turns (subproblem 2).
ToolAxisTurns turnsOfTwo(const ToolAxisTurner& turner, const Point3& wanted, double near_first) {
  const AxisFrame frame(turner.axes[0], turner.axes[1]);
  const AxisView seen = frame.view(wanted);
  const double across = seen.across.norm();
  const double side = std::clamp(sidePart(turner, seen.along, across), -across, across);
  const double off_plane = std::sqrt((across - side) * (across + side));
  ToolAxisTurns turns;
  for (const int branch : {0, 1}) {
    const AxisView between{seen.along, {side, branch == 0 ? off_plane : -off_plane}};
    const double first =
        across < kOnAxis ? near_first : wrapped(angleOf(seen.across) - angleOf(between.across));
    const double second = angleAbout(turner.axes[1], turner.at_zero, frame.direction(between));
    turns.push_back({branch, {first, second}});
  }
  return turns;
}

/// Sine of the angle between two directions of unit length.
double sineBetween(const Point3& a, const Point3& b) { return a.cross(b).norm(); }

/// The tool axis [bed frame].
Point3 toolAxisAt(const ToolAxisTurner& turner, const Eigen::Vector2d& angles) {
  Point3 tool_axis = turner.at_zero;
  for (std::size_t j = turner.axes.size(); j-- > 0;)
    tool_axis = Eigen::AngleAxisd(angles[static_cast<Eigen::Index>(j)], turner.axes[j]) * tool_axis;
  return tool_axis;
}

/// All angles that turn the tool axis to a direction (subproblems 1 and 2 of [Paden1986]). Where the
/// direction lies on the first of two axes, that joint is free and keeps its value of `near`; both branches
/// are the same there and at the rim of what can be reached.
/// @param wanted  of unit length [bed frame]
/// @return empty if the tool axis cannot come nearer than 0.01 deg
ToolAxisTurns toolAxisTurns(const ToolAxisTurner& turner, const Point3& wanted, const Eigen::Vector2d& near) {
  ToolAxisTurns turns(1);
  if (turner.axes.size() == 1) turns[0].angles[0] = angleAbout(turner.axes[0], turner.at_zero, wanted);
  if (turner.axes.size() == 2) turns = turnsOfTwo(turner, wanted, near[0]);
  const auto misses = [&](const ToolAxisTurn& turn) {
    return !isNear(toolAxisAt(turner, turn.angles), wanted);
  };
  turns.erase(std::remove_if(turns.begin(), turns.end(), misses), turns.end());
  return turns;
}

/// Least sine of what vanishes where two joints turn the tool axis along one line only: of the tool axis to
/// the first axis, and of the second joint's way to the plane of both axes. 1 with fewer joints.
double toolAxisMargin(const ToolAxisTurner& turner, const Eigen::Vector2d& angles) {
  if (turner.axes.size() < 2) return 1.0;
  const Point3 between = Eigen::AngleAxisd(angles[1], turner.axes[1]) * turner.at_zero;
  const Point3 normal = turner.axes[0].cross(turner.axes[1]).normalized();
  const double off_plane = std::abs(between.dot(normal)) / sineBetween(turner.at_zero, turner.axes[1]);
  return std::min(sineBetween(between, turner.axes[0]), std::min(off_plane, 1.0));
}

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
  return jacobian(chain, values).topLeftCorner<3, 3>();
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
    // Changes only where a rotary joint stands between linear ones.
    const double volume = std::abs(linearDirections(chain_, values).determinant()) / volume_at_zero_;
    return std::min(volume, toolAxisMargin(turner_, anglesOf(values)));
  }

  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override {
    InverseSolutions found;
    for (const ToolAxisTurn& turn : toolAxisTurns(turner_, bed_from_nozzle.linear().col(2), anglesOf(near))) {
      InverseSolution solution{turn.branch, zeroOf(chain_)};
      for (std::size_t r = 0; r < rotaries_.size(); ++r)
        solution.values[rotaries_[r]] = turn.angles[static_cast<Eigen::Index>(r)];
      const Eigen::Matrix3d directions = linearDirections(chain_, solution.values);
      if (!(std::abs(directions.determinant()) > kLeastVolume)) continue;
      const Point3 way = bed_from_nozzle.translation() - bedFromNozzle(solution.values).translation();
      solution.values.head<3>() = directions.inverse() * way;
      found.push_back(solution);
    }
    return found;
  }

 private:
  Eigen::Vector2d anglesOf(const JointValues& values) const {
    Eigen::Vector2d angles = Eigen::Vector2d::Zero();
    for (std::size_t r = 0; r < rotaries_.size(); ++r)
      angles[static_cast<Eigen::Index>(r)] = values[rotaries_[r]];
    return angles;
  }

  SerialChain chain_;
  std::vector<int> rotaries_;  ///< that next to the bed first
  ToolAxisTurner turner_;
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
