// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/cell_frame.hpp"
#include "program/led_joints.hpp"
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

/// A load that the cell file states is what the arm carries, whatever a program has.
void requireLoadOfCell(const std::string& what, const ToolLoad& load, const KinematicModel& arm) {
  const std::optional<ToolLoad> expected = controllerCell(arm).load;
  if (!expected || isSameLoad(load, *expected)) return;
  throw InvalidProgram(what + " " + shownLoad(load) + "; expected " + shownLoad(*expected) +
                       ", that of the cell of '" + arm.name() + "'");
}

/// A program goes on with whatever tool the controller was last told.
void requireToolStated(const RobotHeadNotes& head, const KinematicModel& arm) {
  if (head.untold_tool.empty()) return;
  throw InvalidProgram(head.untold_tool + ": the tip moves before set_tcp; expected set_tcp before it, of " +
                       shownCellFrame(controllerCell(arm).flange_from_nozzle) + ", the tool of '" +
                       arm.name() + "'");
}

/// Statements act on the controller, whatever the notes have.
void requireStatedTool(const StatedTool& stated, const RobotHeadNotes& head, const KinematicModel& arm) {
  const Eigen::Isometry3d expected = controllerCell(arm).flange_from_nozzle;
  const ToolStatement& tool = stated.what;
  if (tool.flange_from_tip && !isSameCellFrame(*tool.flange_from_tip, expected))
    throw InvalidProgram(stated.place + ": the tool is set to " + shownCellFrame(*tool.flange_from_tip) +
                         "; expected " + shownCellFrame(expected) + ", that of '" + arm.name() + "'");
  if (!tool.mass_kg) return;
  const ToolLoad load{*tool.mass_kg, tool.centre_mm};
  requireLoadOfCell(stated.place + ": the payload is set to", load, arm);
  if (head.load && isSameLoad(*head.load, load)) return;
  throw InvalidProgram(stated.place + ": the payload is set to " + shownLoad(load) + "; expected " +
                       (head.load ? shownLoad(*head.load) + ", that of the note" : "a note of this load"));
}

/// Follows the moves of a program with the joints of an arm.
class RobotFollower {
 public:
  RobotFollower(const RobotRunning& running, const KinematicModel& arm, StatedMotion& motion)
      : running_(running), arm_(arm), motion_(motion) {
    const std::string mismatch = externalMismatch(running.head.map, arm);
    if (!mismatch.empty()) throw InvalidProgram("the program's notes of external axes " + mismatch);
    last_ = JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()));
  }

  void add(const AssembledStation& station) {
    const RunMove& move = running_.moves[station.move.index];
    followWays(station.move.index);
    comeToPart(motion_, move.feed_mm_s);
    Eigen::Isometry3d pose(station.move.orientation);
    pose.translation() = station.move.point;
    const auto joints = jointsAt(pose, move.external, move.line);
    motion_.joints.at.push_back(station.at);
    goOnInFile(motion_, running_.files[move.file]);
    motion_.lines.push_back(move.line);
    motion_.joints.values.push_back(joints.value_or(JointValues()));
    if (!joints) motion_.joints.faults.push_back({station.at, JointFault::OutOfReach, kNoSolution});
  }

  /// Those before this move of the part.
  void followWays(std::size_t move) {
    for (; next_ < running_.ways.size() && running_.ways[next_].before <= move; ++next_)
      follow(running_.ways[next_]);
  }

 private:
  static constexpr const char* kNoSolution = "there is no solution";

  void follow(const RunWay& way) {
    StatedWay stated;
    stated.line = way.line;
    if (way.joints) {
      stated.by = StatedMove::Joints;
      stated.to = last_ = armJoints(running_.head.map, arm_, *way.joints);
    } else {
      const auto joints = jointsAt(way.pose, way.external, way.line);
      stated.to = joints.value_or(JointValues());
      if (!joints) stated.fault = kNoSolution;
      stated.feed_mm_s = way.feed_mm_s;
    }
    is_far_ = true;
    addWay(motion_, std::move(stated));
  }

  std::optional<JointValues> jointsAt(const Eigen::Isometry3d& pose, const std::vector<double>& external,
                                      std::size_t line) {
    const auto near = withControllerAxes(running_.head.map, arm_, last_, external);
    if (!near)
      throw InvalidProgram("line " + std::to_string(line) + ": a move has " +
                           std::to_string(external.size()) +
                           " external axes; expected one for each external joint of '" + arm_.name() + "'");
    std::optional<JointValues> joints;
    if (is_far_) joints = ledJoints(arm_, last_, pose, *near);
    if (!joints) joints = followingJoints(arm_, pose, *near);
    if (joints) last_ = *joints;
    is_far_ = false;
    return joints;
  }

  const RobotRunning& running_;
  const KinematicModel& arm_;
  StatedMotion& motion_;
  JointValues last_;
  bool is_far_ = false;   ///< whether the arm comes from beside the part
  std::size_t next_ = 0;  ///< way
};

}  // namespace

StatedMotion robotMotionOf(RobotRunning running, const KinematicModel& arm) {
  if (running.ways.empty() || running.ways.front().before > 0 || !running.ways.front().joints)
    throw InvalidProgram(
        "no move of the joints comes to the part; expected one behind a note of an approach");
  requireSameCell(running.head, arm);
  requireToolStated(running.head, arm);
  if (running.head.load) requireLoadOfCell("the program's notes have a load of", *running.head.load, arm);
  for (const StatedTool& stated : running.head.stated_tools) requireStatedTool(stated, running.head, arm);
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  RobotFollower follower(running, arm, motion);
  for (const AssembledStation& station : running.program.stations) follower.add(station);
  follower.followWays(running.moves.size());
  motion.toolpath = std::move(running.program.toolpath);
  return motion;
}

}  // namespace lamina
