// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_motion.hpp"

#include <utility>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/cell_frame.hpp"
#include "program/led_joints.hpp"
#include "program/rapid/rapid_externals.hpp"

namespace lamina {
namespace {

[[noreturn]] void refuseCell(const std::string& what, const std::string& expected) {
  throw InvalidProgram(what + "; expected " + expected);
}

/// What is not declared is the controller's own, and not looked at.
void requireCell(const RapidSource& source, const KinematicModel& arm) {
  const ArmCell cell = armCell(arm);
  const std::string of_arm = ", that of '" + arm.name() + "'";
  if (const auto tool = source.tools.find(source.tool); tool != source.tools.end())
    if (!isSameCellFrame(tool->second.flange_from_tip, cell.flange_from_nozzle))
      refuseCell(
          "the tool '" + source.tool + "' is declared at " + shownCellFrame(tool->second.flange_from_tip),
          shownCellFrame(cell.flange_from_nozzle) + of_arm);
  const auto found = source.work_objects.find(source.work_object);
  if (found == source.work_objects.end()) return;
  const RapidWorkObject& object = found->second;
  if (object.is_fixed == cell.is_bed_carried)
    refuseCell("the work object '" + source.work_object + "' is " +
                   (object.is_fixed ? "fixed" : "carried by '" + object.carrier + "'"),
               cell.is_bed_carried ? "the mechanical unit that carries the bed" + of_arm
                                   : "a fixed one, as the bed" + of_arm);
  // Where a unit carries the work object, the controller has the user frame from the unit.
  const Eigen::Isometry3d bed = object.is_fixed ? object.user * object.object : object.object;
  if (!isSameCellFrame(bed, cell.carrier_from_bed))
    refuseCell("the work object '" + source.work_object + "' is declared at " + shownCellFrame(bed),
               shownCellFrame(cell.carrier_from_bed) + of_arm);
}

/// Follows the moves of a program with the joints of an arm.
class RapidFollower {
 public:
  RapidFollower(const KinematicModel& arm, const std::vector<RapidWay>& ways,
                const std::vector<RapidExternal>& externals)
      : arm_(arm),
        ways_(ways),
        externals_(externals),
        last_(JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()))) {}

  void add(const RapidStation& station, StatedMotion& motion) {
    followWays(station.index, motion);
    comeToPart(motion, station.move.feed_mm_s);
    const Eigen::Isometry3d pose = poseOf(station.move);
    const auto joints = jointsAt(station.move);
    motion.joints.at.push_back(station.at);
    motion.lines.push_back(station.move.line);
    motion.joints.values.push_back(joints.value_or(JointValues()));
    if (!joints) motion.joints.faults.push_back(faultOf(station, pose));
  }

  /// Those before this move of the part.
  void followWays(std::size_t move, StatedMotion& motion) {
    for (; next_ < ways_.size() && ways_[next_].before <= move; ++next_) follow(ways_[next_], motion);
  }

 private:
  static Eigen::Isometry3d poseOf(const RapidMove& move) {
    Eigen::Isometry3d pose(move.target.orientation);
    pose.translation() = move.target.point;
    return pose;
  }

  void follow(const RapidWay& way, StatedMotion& motion) {
    StatedWay stated;
    stated.line = way.line;
    if (way.joints) {
      SixJoints joints;
      for (std::size_t j = 0; j < way.joints->arm_deg.size(); ++j)
        joints[static_cast<Eigen::Index>(j)] = toRadians(way.joints->arm_deg[j]);
      last_ = withSixJoints(arm_, withExternal(last_, way.joints->external, way.line), joints);
      is_known_ = true;
      stated.by = StatedMove::Joints;
      stated.to = last_;
    } else {
      const auto joints = jointsAt(way.move);
      stated.to = joints.value_or(JointValues());
      if (!joints) stated.fault = "no joints reach the target";
      stated.feed_mm_s = way.move.feed_mm_s;
    }
    is_far_ = true;
    addWay(motion, std::move(stated));
  }

  std::optional<JointValues> jointsAt(const RapidMove& move) {
    const JointValues near = withExternal(last_, move.target.external, move.line);
    const Eigen::Isometry3d pose = poseOf(move);
    std::optional<JointValues> joints;
    if (move.is_heeded || !is_known_) {
      joints = configuredJoints(arm_, pose, move.target.configuration, near);
    } else {
      if (is_far_) joints = ledJoints(arm_, last_, pose, near);
      if (!joints) joints = followingJoints(arm_, pose, near);
    }
    last_ = joints.value_or(near);
    is_known_ |= joints.has_value();
    is_far_ = false;
    return joints;
  }

  JointValues withExternal(JointValues values, const std::vector<double>& external, std::size_t line) const {
    std::size_t next = 0;
    for (std::size_t j = 0; j < arm_.joints().size(); ++j) {
      const DrivenJoint& joint = arm_.joints()[j];
      if (!isExternal(joint.name)) continue;
      const RapidExternal axis = axisOf(joint, next++);
      if (axis.slot >= external.size() || external[axis.slot] >= kNoRapidAxis)
        throw InvalidProgram("line " + std::to_string(line) + ": a target has no value of " +
                             rapidAxisName(axis.slot) + "; expected one for joint '" + joint.name + "' of '" +
                             arm_.name() + "'");
      const double value = (external[axis.slot] - axis.zero) / axis.sign;
      values[static_cast<Eigen::Index>(j)] = joint.kind == JointKind::Linear ? value : toRadians(value);
    }
    return values;
  }

  /// By the notes, or, without any, in the order of joints.
  RapidExternal axisOf(const DrivenJoint& joint, std::size_t place) const {
    if (externals_.empty()) return {joint.name, place};
    for (const RapidExternal& each : externals_)
      if (each.joint == joint.name) return each;
    throw InvalidProgram("the program names no external axis for joint '" + joint.name + "' of '" +
                         arm_.name() + "'; expected one in a note at its head");
  }

  FaultyWaypoint faultOf(const RapidStation& station, const Eigen::Isometry3d& pose) const {
    const AbbConfiguration& c = station.move.target.configuration;
    if (arm_.solutions(pose, last_).empty())
      return {station.at, JointFault::OutOfReach, "there is no solution"};
    return {station.at, JointFault::Configuration,
            "no joints reach the target in its configuration [" + std::to_string(c.cf1) + "," +
                std::to_string(c.cf4) + "," + std::to_string(c.cf6) + "," + std::to_string(c.cfx) + "]"};
  }

  const KinematicModel& arm_;
  const std::vector<RapidWay>& ways_;
  const std::vector<RapidExternal>& externals_;
  std::size_t next_ = 0;  ///< way
  bool is_far_ = false;   ///< whether the arm comes from beside the part
  JointValues last_;
  bool is_known_ = false;  ///< where the arm stands
};

}  // namespace

StatedMotion rapidMotionOf(const RapidSource& source, RapidRunning running, const KinematicModel& arm) {
  requireControllerKind(arm.urdf(), "abb", "RAPID");
  requireCell(source, arm);
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  RapidFollower follower(arm, running.ways, source.externals);
  for (const RapidStation& station : running.stations) {
    goOnInFile(motion, source.files[station.move.module]);
    follower.add(station, motion);
  }
  follower.followWays(running.stations.back().index + 1, motion);
  motion.toolpath = std::move(running.toolpath);
  return motion;
}

}  // namespace lamina
