// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/passages/run_passages.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "lamina/verification/collision/checked_machine.hpp"

namespace lamina {

/// A toolpath, and the joint values with which a machine or robot runs it.
struct KinematicModelRun {
  /// Toolpath with divided motions: between waypoints, joints at constant speed keep the nozzle on the
  /// motion.
  DividedToolpath divided;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< [mm]
  JointPath path;  ///< joint values along the divided toolpath
  /// Line of the program that states the joints, for each waypoint of `path`; empty if no program states
  /// them.
  std::vector<std::size_t> lines;
  std::vector<RunPassage> passages = {};  ///< motions beside the part
  /// A sentence on the unknown part of the motion to the part; empty if all is known.
  std::string unknown_way = {};

  const Toolpath& toolpath() const { return divided.toolpath; }
};

/// Plans the joint values of a toolpath. Links do not collide with each other, as far as `SelfCollisionGuard`
/// finds. Motions are divided to keep the nozzle within the tolerances; `inTime` divides further where that
/// is not enough.
/// @param progress  stage "joints"
/// @throws as `planJointPath`; InvalidConfig as `linkBodies`
KinematicModelRun runOn(const CheckedMachine& machine, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The same with joint values that a guard allows; model and guard are as those of a `CheckedMachine`.
KinematicModelRun runOn(const GuardedModel& guarded, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The same for a single run: the `CheckedMachine` is made for the call.
KinematicModelRun runOn(const KinematicModel& model, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// A range of consecutive layers of a toolpath.
struct LayerRange {
  std::size_t first = 0;
  std::size_t end = 0;  ///< index after the last layer
};

/// Some layers of a toolpath. The toolpath must outlive the value.
struct ToolpathExcerpt {
  const Toolpath& toolpath;
  std::vector<LayerRange> stretches;  ///< ascending, with at least one layer between each and the next
};

/// Plans the joint values for some of the layers. `path` holds these layers only. The other layers stay in
/// the toolpath undivided: their material still counts as an obstacle. Each range is planned as if it were
/// the whole toolpath: near its ends the joint values may differ from those of the whole.
/// @param progress  stage "joints"
/// @throws as the function above
KinematicModelRun runOn(const CheckedMachine& machine, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The same with joint values that a guard allows.
KinematicModelRun runOn(const GuardedModel& guarded, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The run of a program that states its joint values. The values are checked (`judged`), not planned. Where
/// the controller moves the nozzle along straight lines, as with arms, motions are divided
/// (`alongStraightMoves`).
KinematicModelRun runAsStated(const KinematicModel& model, StatedMotion motion,
                              const JointPathSettings& settings);

/// The run of such a program for its motions beside the part only: joint values along the part are taken as
/// stated, and motions are not divided.
KinematicModelRun passagesAsStated(const KinematicModel& model, StatedMotion motion,
                                   const JointPathSettings& settings);

/// Checks that the path has no faults.
/// @throws Unreachable otherwise, with the number of faults and the first fault
void requireRunnable(const KinematicModelRun& run, const KinematicModel& model);

/// Figures of a run within the limits of the joints.
struct RunTime {
  double total_s = 0.0;  ///< including motions beside the part stated by a program (`passageTime`)
  /// Share of the length of beads that is deposited at less than 95 % of the feed asked for
  /// (`slowBeadShare`).
  double slow_bead_share = 0.0;
};

/// A run with its trajectory over time.
struct TimedRun {
  KinematicModelRun run;
  std::unique_ptr<TimedPath> trajectory;
  ToolpathTime time;
  RunTime figures;
};

/// Times a run within the limits of the joints.
/// @throws Unreachable as `requireRunnable`; as `TimedPath`
TimedRun inTime(KinematicModelRun run, const KinematicModel& model, const TimingSettings& settings);

/// Figures of a timed run, as `lamina slice` states them. If only linear axes move and no program states
/// joints, a firmware plans the speeds: the time is that within `motion.*` (`estimateTime`). Otherwise the
/// figures are those within the limits of the joints.
RunTime plannedTime(const TimedRun& timed, const KinematicModel& model, const MotionLimits& limits);

}  // namespace lamina
