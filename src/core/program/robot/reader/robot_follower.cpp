// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/cell_frame.hpp"
#include "program/external_axes.hpp"
#include "program/robot/reader/robot_run.hpp"

namespace lamina {
namespace {

/// Where the program states none, that of the cell would be as good a guess as any other.
void requireSameFrame(const std::string& what, const std::optional<Eigen::Isometry3d>& stated,
                      const Eigen::Isometry3d& expected, const KinematicModel& arm) {
  if (!stated)
    throw InvalidProgram("the program has no note of its " + what + "; expected one, of " +
                         shownCellFrame(expected) + ", that of '" + arm.name() + "'");
  if (!isSameCellFrame(*stated, expected))
    throw InvalidProgram("the program's notes have the " + what + " at " + shownCellFrame(*stated) +
                         "; expected " + shownCellFrame(expected) + ", that of '" + arm.name() + "'");
}

void requireSameCell(const RobotHeadNotes& head, const KinematicModel& arm) {
  const ArmCell cell = controllerCell(arm);
  requireSameFrame("tool", head.tool, cell.flange_from_nozzle, arm);
  if (head.bed && head.is_bed_carried != cell.is_bed_carried)
    throw InvalidProgram(std::string("the program's notes have a bed that ") +
                         (head.is_bed_carried ? "an external axis carries" : "stands still") +
                         "; expected the other way round, as of '" + arm.name() + "'");
  requireSameFrame("bed", head.bed, cell.carrier_from_bed, arm);
}

}  // namespace

StatedMotion robotMotionOf(RobotRunning running, const KinematicModel& arm) {
  if (!running.start)
    throw InvalidProgram(
        "no move of the joints comes to the part; expected one behind a note of an approach");
  requireSameCell(running.head, arm);
  JointValues last = armJoints(running.head.map, arm, *running.start);
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  for (const AssembledStation& station : running.program.stations) {
    const RunMove& move = running.moves[station.move.index];
    const auto near = withExternalAxes(arm, last, move.external);
    if (!near)
      throw InvalidProgram("line " + std::to_string(move.line) + ": a move has " +
                           std::to_string(move.external.size()) +
                           " external axes; expected one for each external joint of '" + arm.name() + "'");
    Eigen::Isometry3d pose(station.move.orientation);
    pose.translation() = station.move.point;
    const auto joints = followingJoints(arm, pose, *near);
    motion.joints.at.push_back(station.at);
    goOnInFile(motion, running.files[move.file]);
    motion.lines.push_back(move.line);
    motion.joints.values.push_back(joints.value_or(JointValues()));
    if (joints)
      last = *joints;
    else
      motion.joints.faults.push_back({station.at, JointFault::OutOfReach, "there is no solution"});
  }
  motion.toolpath = std::move(running.program.toolpath);
  return motion;
}

}  // namespace lamina
