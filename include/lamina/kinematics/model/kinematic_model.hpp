// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamina {

/// Greatest number of joints of a kinematic model.
constexpr int kMostJoints = 9;

/// Values of a kinematic model's joints in the order of `KinematicModel::joints` [mm, rad].
using JointValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostJoints, 1>;

/// Derivative of the nozzle's pose by the joint values, a column for each joint, per mm or rad of it: rows 0
/// to 2 are the translation of the tip [mm], rows 3 to 5 the rotation [rad], both relative to the bed and in
/// the bed frame.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostJoints>;

enum class JointKind : std::uint8_t { Linear, Rotary };

/// A joint that is driven.
struct DrivenJoint {
  std::string name;  ///< in the URDF
  JointKind kind = JointKind::Linear;
  double low = 0.0;  ///< [mm, rad]
  double high = 0.0;
  double max_speed = 0.0;  ///< [mm/s, rad/s]
};

/// One solution of the inverse kinematics: joint values that bring the nozzle to a pose.
struct InverseSolution {
  /// Number of the branch. Along a motion that passes no singularity, solutions of one branch are continuous,
  /// except for whole turns of rotary joints.
  int branch = 0;
  JointValues values;
};

/// Solutions for one pose, in order of their branches. Up to eight, the most that an arm has, need no memory
/// from the heap.
using InverseSolutions = boost::container::small_vector<InverseSolution, 8>;

/// Whether a kinematic model controls the rotation of the nozzle about its tool axis.
enum class ToolAxisSpin : std::uint8_t {
  Free,   ///< no: inverse solutions agree with the tip and the tool axis of the pose only
  Given,  ///< yes: inverse solutions agree with the whole pose
};

/// The angle that a pose of the nozzle leaves free in a redundant model, beside what `near` states. The angle
/// is periodic: joint values are continuous from pi to -pi.
class Redundancy {
 public:
  virtual ~Redundancy() = default;
  /// The angle at joint values [rad], in (-pi, pi].
  virtual double angleAt(const JointValues& values) const = 0;
  /// As `KinematicModel::solutions`, for one value of the angle.
  virtual InverseSolutions solutionsWith(const Eigen::Isometry3d& bed_from_nozzle, const JointValues& near,
                                         double angle) const = 0;
};

/// Forward and inverse kinematics of a machine or robot that moves a nozzle relative to a bed. Models are
/// immutable; all calls may be made from several threads.
class KinematicModel {
 public:
  virtual ~KinematicModel() = default;

  virtual const std::string& name() const = 0;
  virtual const std::string& urdf() const = 0;  ///< the text it was made from
  virtual const std::vector<DrivenJoint>& joints() const = 0;
  virtual ToolAxisSpin toolAxisSpin() const = 0;

  /// Pose of the nozzle [mm].
  virtual Eigen::Isometry3d bedFromNozzle(const JointValues& values) const = 0;
  virtual Jacobian jacobian(const JointValues& values) const = 0;

  /// All inverse solutions, at most one per branch, in order of the branches. Rotary values lie in (-pi, pi];
  /// limits of joints are not checked. Empty if the pose is out of reach.
  /// @param near  values for joints that the pose does not determine: one that is free at a singularity, or
  ///   an external axis; a redundant model keeps the angle that it has at these values
  virtual InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                     const JointValues& near) const = 0;

  /// Distance from a singularity: 0 at one, 1 at best. It is the least sine of the angles that vanish at
  /// singularities: between the tool axis and a rotary axis of head or table, of the bend of a wrist, of the
  /// bend of an elbow.
  virtual double singularityMargin(const JointValues& values) const = 0;

  /// Pose of every link relative to the bed, by name [mm].
  virtual std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const = 0;

  /// Values of all joints of the URDF that move, driven or not, by name [mm, rad].
  virtual std::map<std::string, double> urdfJoints(const JointValues& values) const = 0;

  /// The redundancy of the model; null if it has none.
  virtual const Redundancy* redundancy() const { return nullptr; }
};

/// Names of all machines and robots that come with Lamina (`urdf/`).
std::vector<std::string> kinematicModelNames();

/// The model of one of `kinematicModelNames`.
/// @throws InvalidConfig if there is no model of that name; lists the available names
std::unique_ptr<KinematicModel> kinematicModelByName(const std::string& name);

/// Reads a kinematic model from its URDF; its kind follows from its joints (docs/machines/kinematics.md).
/// @throws InvalidConfig if it is no URDF, a link `bed` or `nozzle` is missing, a joint has no limits, or its
///   joints form none of the kinds that are supported; names link or joint, and what was expected
std::unique_ptr<KinematicModel> kinematicModelFromUrdf(const std::string& text);

}  // namespace lamina
