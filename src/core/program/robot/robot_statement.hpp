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

/// A comment that states what the moves of a program do not: "path outer_wall closed 12".
struct NoteLine {
  std::string text;
};

/// Joints as a controller counts them.
struct ControllerJoints {
  std::array<double, 6> arm_deg{};
  std::vector<double> external;  ///< [mm, deg]
};

/// How an arm stands at a pose.
struct ArmPosture {
  ControllerJoints joints;
  int branch =
      0;  ///< 4 with the wrist behind axis 1, plus 2 behind the lower arm, plus 1 with joint 5 negative
};

/// A straight move of the tip.
struct TipMove {
  Point3 point = Point3::Zero();                                    ///< [mm]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the nozzle
  bool is_over_base = false;     ///< of the robot; else over the bed, as in all that is written
  std::vector<double> external;  ///< [mm, deg]
  std::optional<ArmPosture> posture = std::nullopt;  ///< where joints are known
  double feed_mm_s = 0.0;
  bool rests = false;          ///< comes to the very point; others may be rounded
  bool lays = false;           ///< material
  double room_mm = 0.0;        ///< to the nearer of the points before and after; 0 where the tip rests
  std::size_t moves_left = 0;  ///< of its path, this one included
};

/// A move of all joints.
struct JointMove {
  ControllerJoints joints;
  std::optional<TipMove> pose = std::nullopt;  ///< where they take the tip, for who cannot state joints
};

struct OutputSwitch {
  int output = 0;
  bool is_on = false;
};

/// The arc by statements of the controller's own.
struct ArcSwitch {
  bool is_on = false;
  int schedule = 1;  ///< kept on the controller
  int weave = 0;     ///< schedule of the weave while it burns; 0 for none
};

/// An analogue output that holds from the point before the next move.
struct LevelChange {
  int output = 0;
  double value = 0.0;
  bool is_on_the_way = false;  ///< the tip does not rest
};

struct ProgramWait {
  double duration_s = 0.0;
};

struct FileCall {
  std::string name;
};

/// What a robot's program is made of, in any language.
using RobotStatement =
    std::variant<NoteLine, JointMove, TipMove, OutputSwitch, ArcSwitch, LevelChange, ProgramWait, FileCall>;

/// A statement of a file, and where it stands.
struct ReadStatement {
  RobotStatement what;
  std::size_t line = 0;  ///< 1 based
};

}  // namespace lamina
