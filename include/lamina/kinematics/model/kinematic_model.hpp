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

/// How the nozzle moves with the joints: rows 0 to 2 its tip [mm], rows 3 to 5 its turn [rad], both over the
/// bed and in the bed frame; a column per joint, per mm or rad of it.
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

/// One way to bring the nozzle to a pose.
struct InverseSolution {
  /// Number of the way. Along a motion that passes no singularity, solutions of one branch are continuous,
  /// except for whole turns of rotary joints.
  int branch = 0;
  JointValues values;
};

/// Solutions of one pose, by branch. Up to eight, all that an arm has, take no memory from the heap.
using InverseSolutions = boost::container::small_vector<InverseSolution, 8>;

/// Whether a kinematic model determines the turn of the nozzle about its tool axis.
enum class ToolAxisSpin : std::uint8_t {
  Free,   ///< undefined: inverse solutions have the tip and the tool axis of the pose asked for
  Given,  ///< inverse solutions have the whole pose
};

/// What carries a nozzle over a bed: forward and inverse kinematics of a machine or robot. Values that never
/// change; all calls may be made from several threads.
class KinematicModel {
 public:
  virtual ~KinematicModel() = default;

  virtual const std::string& name() const = 0;
  virtual const std::string& urdf() const = 0;  ///< the text it was made from
  virtual const std::vector<DrivenJoint>& joints() const = 0;
  virtual ToolAxisSpin toolAxisSpin() const = 0;

  /// Where the nozzle is [mm].
  virtual Eigen::Isometry3d bedFromNozzle(const JointValues& values) const = 0;
  virtual Jacobian jacobian(const JointValues& values) const = 0;

  /// All solutions, one per branch at most, by branch. Rotary values lie in (-pi, pi]; limits of joints are
  /// not looked at. Empty if the pose is out of reach.
  /// @param near  values that joints keep where the pose does not determine them: a joint that is free at a
  ///   singularity, or an external axis
  virtual InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                     const JointValues& near) const = 0;

  /// Distance from a singularity: 0 at one, 1 at best. It is the least sine of the angles that vanish at
  /// singularities: of the tool axis to a rotary axis of a head or table, of a wrist, of an elbow from
  /// straight.
  virtual double singularityMargin(const JointValues& values) const = 0;

  /// Every link over the bed [mm].
  virtual std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const = 0;

  /// Values of all joints of the URDF that move, driven or not, by name [mm, rad].
  virtual std::map<std::string, double> urdfJoints(const JointValues& values) const = 0;
};

/// Names of all machines and robots that come with Lamina (`urdf/`).
std::vector<std::string> kinematicModelNames();

/// @throws InvalidConfig if there is none of that name; names those there are
std::unique_ptr<KinematicModel> kinematicModelByName(const std::string& name);

/// Reads a kinematic model from its URDF; its kind follows from its joints (docs/machines/kinematics.md).
/// @throws InvalidConfig if it is no URDF, a link `bed` or `nozzle` is missing, a joint has no limits, or its
///   joints are of no kind that is understood; names link or joint, and what was expected
std::unique_ptr<KinematicModel> kinematicModelFromUrdf(const std::string& text);

}  // namespace lamina
