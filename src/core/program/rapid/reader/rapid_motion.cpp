// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_motion.hpp"

#include <utility>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/cell_frame.hpp"

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
  RapidFollower(const KinematicModel& arm, const std::optional<RapidJoints>& start)
      : arm_(arm), last_(JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()))) {
    if (!start) return;
    SixJoints joints;
    for (std::size_t j = 0; j < start->arm_deg.size(); ++j)
      joints[static_cast<Eigen::Index>(j)] = toRadians(start->arm_deg[j]);
    last_ = withSixJoints(arm, withExternal(last_, start->external, 0), joints);
    is_known_ = true;
  }

  void add(const RapidStation& station, StatedMotion& motion) {
    const RapidTarget& target = station.move.target;
    last_ = withExternal(std::move(last_), target.external, station.move.line);
    Eigen::Isometry3d pose(target.orientation);
    pose.translation() = target.point;
    const bool is_heeded = station.move.is_heeded || !is_known_;
    const auto joints = is_heeded ? configuredJoints(arm_, pose, target.configuration, last_)
                                  : followingJoints(arm_, pose, last_);
    motion.joints.at.push_back(station.at);
    motion.lines.push_back(station.move.line);
    motion.joints.values.push_back(joints.value_or(JointValues()));
    if (!joints) return addFault(station, pose, motion);
    last_ = *joints;
    is_known_ = true;
  }

 private:
  JointValues withExternal(JointValues values, const std::vector<double>& external, std::size_t line) const {
    std::size_t next = 0;
    for (std::size_t j = 0; j < arm_.joints().size(); ++j) {
      const DrivenJoint& joint = arm_.joints()[j];
      if (!isExternal(joint.name)) continue;
      if (next == external.size())
        throw InvalidProgram("line " + std::to_string(line) + ": a target has " +
                             std::to_string(external.size()) + " external axes; expected one for joint '" +
                             joint.name + "' of '" + arm_.name() + "'");
      const double value = external[next++];
      values[static_cast<Eigen::Index>(j)] = joint.kind == JointKind::Linear ? value : toRadians(value);
    }
    return values;
  }

  void addFault(const RapidStation& station, const Eigen::Isometry3d& pose, StatedMotion& motion) const {
    const AbbConfiguration& c = station.move.target.configuration;
    if (arm_.solutions(pose, last_).empty()) {
      motion.joints.faults.push_back({station.at, JointFault::OutOfReach, "there is no solution"});
      return;
    }
    motion.joints.faults.push_back({station.at, JointFault::Configuration,
                                    "no joints reach the target in its configuration [" +
                                        std::to_string(c.cf1) + "," + std::to_string(c.cf4) + "," +
                                        std::to_string(c.cf6) + "," + std::to_string(c.cfx) + "]"});
  }

  const KinematicModel& arm_;
  JointValues last_;
  bool is_known_ = false;  ///< where the arm stands
};

}  // namespace

StatedMotion rapidMotionOf(const RapidSource& source, RapidRunning running, const KinematicModel& arm) {
  requireCell(source, arm);
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  RapidFollower follower(arm, running.start);
  for (const RapidStation& station : running.stations) {
    goOnInFile(motion, source.files[station.move.module]);
    follower.add(station, motion);
  }
  motion.toolpath = std::move(running.toolpath);
  return motion;
}

}  // namespace lamina
