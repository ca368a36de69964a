// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A note: a comment that states what the moves of a program do not: "path outer_wall closed 12".
struct NoteLine {
  std::string text;
};

/// Joint values as a controller counts them.
struct ControllerJoints {
  std::array<double, 6> arm_deg{};
  std::vector<double> external;  ///< [mm, deg]
};

/// Joint values and configuration of an arm at a pose.
struct ArmPosture {
  ControllerJoints joints;
  int branch =
      0;  ///< 4 with the wrist behind axis 1, plus 2 behind the lower arm, plus 1 with joint 5 negative
};

/// A straight move of the tip.
struct TipMove {
  Point3 point = Point3::Zero();                                    ///< [mm]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the nozzle
  /// Whether the pose is over the robot's base; otherwise over the bed, as in all programs written.
  bool is_over_base = false;
  std::vector<double> external;                      ///< [mm, deg]
  std::optional<ArmPosture> posture = std::nullopt;  ///< nothing if the joints are not known
  double feed_mm_s = 0.0;
  /// Whether the tip stops exactly at the point; otherwise the controller may round the corner.
  bool rests = false;
  bool lays = false;           ///< whether material is deposited
  double room_mm = 0.0;        ///< distance to the nearer of the points before and after; 0 if the tip rests
  std::size_t moves_left = 0;  ///< number of moves left of its path, this one included
};

/// A move of all joints.
struct JointMove {
  ControllerJoints joints;
  std::optional<TipMove> pose = std::nullopt;  ///< pose of the tip, for languages that cannot state joints
};

struct OutputSwitch {
  int output = 0;
  bool is_on = false;
};

/// Starts or ends the arc by statements of the controller.
struct ArcSwitch {
  bool is_on = false;
  int schedule = 1;  ///< number of the schedule kept on the controller
  int weave = 0;     ///< number of the weave schedule of the arc; 0 for none
};

/// Sets an analogue output, effective from the point before the next move.
struct LevelChange {
  int output = 0;
  double value = 0.0;
  bool is_on_the_way = false;  ///< whether it is set without the tip coming to rest
};

struct ProgramWait {
  double duration_s = 0.0;
};

/// Sets what the flange carries.
struct ToolStatement {
  std::optional<Eigen::Isometry3d> flange_from_tip;  ///< [mm]
  std::optional<double> mass_kg;
  Point3 centre_mm = Point3::Zero();  ///< centre of gravity, over the flange
};

struct FileCall {
  std::string name;
};

/// A statement of a robot's program, in any language.
using RobotStatement = std::variant<NoteLine, JointMove, TipMove, OutputSwitch, ArcSwitch, LevelChange,
                                    ProgramWait, ToolStatement, FileCall>;

/// A statement of a file, and its line.
struct ReadStatement {
  RobotStatement what;
  std::size_t line = 0;  ///< 1 based
};

}  // namespace lamina
