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
  /// Toolpath with motions divided so that joints at constant speed keep the nozzle on them.
  DividedToolpath divided;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< [mm]
  JointPath path;                                                   ///< of the divided toolpath
  /// Line of the program that states the joints, for each waypoint of `path`; empty if none does.
  std::vector<std::size_t> lines;
  std::vector<RunPassage> passages = {};  ///< ways beside the part
  std::string unknown_way = {};           ///< what of the way to the part is not known; empty for nothing

  const Toolpath& toolpath() const { return divided.toolpath; }
};

/// Plans the joint values of a toolpath such that, as far as `SelfCollisionGuard` finds, links do not collide
/// with each other. Motions are divided to keep the nozzle within the tolerances; `inTime` divides further
/// where that is not enough.
/// @param progress  stage "joints"
/// @throws as `planJointPath`; InvalidConfig as `linkBodies`
KinematicModelRun runOn(const CheckedMachine& machine, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The same, of a machine that nothing more is planned or checked on.
KinematicModelRun runOn(const KinematicModel& model, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// A range of consecutive layers of a toolpath.
struct LayerRange {
  std::size_t first = 0;
  std::size_t end = 0;  ///< index after the last layer
};

/// Some of the layers of a toolpath, which must outlive the value.
struct ToolpathExcerpt {
  const Toolpath& toolpath;
  std::vector<LayerRange> stretches;  ///< ascending, with at least one layer between each and the next
};

/// Plans the joint values for some of the layers. `path` holds these only; the other layers stay in the
/// toolpath undivided, so that what they deposit still counts as an obstacle. Each range is planned as if it
/// were the whole toolpath: near its ends the joint values may differ from those of the whole.
/// @param progress  stage "joints"
/// @throws as the function above
KinematicModelRun runOn(const CheckedMachine& machine, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The run of a program that states its joint values: these are checked (`judged`), not planned. Where a
/// controller leads the nozzle straight, as that of an arm does, motions are divided
/// (`alongStraightMoves`).
KinematicModelRun runAsStated(const KinematicModel& model, StatedMotion motion,
                              const JointPathSettings& settings);

/// The same program for its ways beside the part alone: the joints along the part are taken as they are, and
/// not led in between.
KinematicModelRun passagesAsStated(const KinematicModel& model, StatedMotion motion,
                                   const JointPathSettings& settings);

/// Checks that the path has no faults.
/// @throws Unreachable otherwise, with their number and the first of them
void requireRunnable(const KinematicModelRun& run, const KinematicModel& model);

/// Figures of a run within the limits of the joints.
struct RunTime {
  double total_s = 0.0;  ///< with the ways beside the part that a program states (`passageTime`)
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

/// Figures of a timed run by what will plan its speeds: the figures that `lamina slice` states as well. Where
/// linear axes alone move and no program states joints, that is a firmware, which knows `motion.*` and
/// nothing of joints (`estimateTime`). Otherwise they are those within the limits of the joints.
RunTime plannedTime(const TimedRun& timed, const KinematicModel& model, const MotionLimits& limits);

}  // namespace lamina
