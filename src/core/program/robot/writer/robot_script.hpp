// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/program/robot/robot_motion.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/program_stations.hpp"
#include "program/robot/robot_cell.hpp"
#include "program/robot/robot_statement.hpp"
#include "program/robot/writer/robot_paths.hpp"

namespace lamina {

/// A toolpath, its pose on the bed, and the robot that runs it.
struct RobotJob {
  const Toolpath& toolpath;
  const Eigen::Isometry3d& bed_from_part;
  const RobotMotion* robot = nullptr;  ///< may be null
};

/// The statements of a program in their order, independent of the language. The toolpath and the robot's
/// motion must outlive this object.
class RobotScript {
 public:
  /// @throws as `robotProgram`
  RobotScript(const RobotJob& job, const RobotProgramSettings& settings, const ControllerMap& map);

  /// Notes on the whole program: cell, outputs, counting of joints, position of the layers.
  std::vector<std::string> headNotes() const;

  std::vector<RobotStatement> approach() const;
  std::vector<RobotStatement> retract() const;
  /// Moves between two files that are started one by one: away from the part along the tool axis, and back to
  /// this posture, first by a joint move.
  /// @throws Unreachable if the arm cannot reach the pose away from the part
  std::vector<RobotStatement> retractFrom(const ArmPosture& posture) const;
  std::vector<RobotStatement> approachTo(const ArmPosture& posture) const;

  /// The joint move to a posture. Needs an arm.
  JointMove jointMoveTo(const ArmPosture& posture) const;

  const std::vector<RobotStretch>& stretches() const { return stretches_; }
  std::vector<RobotStatement> statements(const RobotStretch& stretch) const;
  /// Position of a stretch, for messages: "layer 3, path 0".
  std::string place(const RobotStretch& stretch) const;

  /// Posture of the arm at the start of a stretch; nothing without an arm.
  std::optional<ArmPosture> postureAtStart(const RobotStretch& stretch) const;

  /// The settings, with the load of the cell if they state none.
  const RobotProgramSettings& settings() const { return settings_; }
  const std::optional<ArmCell>& cell() const { return cell_; }
  /// Kinds of the external axes, in their order.
  std::vector<JointKind> externalKinds() const;

 private:
  class Stretch;
  TipMove moveTo(std::size_t path, std::size_t move) const;
  double feedOfApproach() const;
  bool restsAfter(std::size_t path, std::size_t move) const;
  const JointValues* jointsAt(std::size_t path, std::size_t move) const;
  std::optional<ArmPosture> postureOf(const JointValues* joints) const;
  JointMove jointMove(const JointValues& joints) const;
  TipMove passage(const Eigen::Isometry3d& pose, const JointValues& joints) const;

  RobotJob job_;
  RobotProgramSettings settings_;
  ControllerMap map_;
  std::vector<RobotLevel> levels_;
  std::vector<RobotPath> paths_;
  std::vector<RobotStretch> stretches_;
  std::optional<ProgramStations> stations_;
  std::optional<ArmCell> cell_;
  Eigen::Quaterniond turn_;  ///< bed_from_part
};

}  // namespace lamina
