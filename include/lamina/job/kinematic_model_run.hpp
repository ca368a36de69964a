// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/timed_path.hpp"

namespace lamina {

/// A toolpath as the joints of a machine or robot run it.
struct KinematicModelRun {
  DividedToolpath divided;  ///< fine enough for joints at constant speed to keep the nozzle on its motions
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< [mm]
  JointPath path;                                                   ///< of the divided toolpath
  std::vector<std::size_t>
      lines;  ///< of the program that states the joints, by waypoint of the path; else empty

  const Toolpath& toolpath() const { return divided.toolpath; }
};

/// The joints that keep links out of each other, as far as `SelfCollisionGuard` finds. Where divisions do
/// not keep the nozzle within the tolerances, `inTime` goes on dividing.
/// @param progress  stage "joints"
/// @throws as `planJointPath`; InvalidConfig as `linkBodies`
KinematicModelRun runOn(const KinematicModel& model, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// Layers of a toolpath that follow each other.
struct LayerStretch {
  std::size_t first = 0;
  std::size_t end = 0;  ///< behind the last
};

/// Some of the layers of a toolpath, which must outlive the value.
struct ToolpathExcerpt {
  const Toolpath& toolpath;
  std::vector<LayerStretch> stretches;  ///< in turn, with a layer between each and the next
};

/// Leads the joints through some layers alone: `path` leaves the other ones out, which are in the toolpath
/// all the same, undivided, so that what they deposit stands in the way. Each stretch is led as if nothing
/// came before or after it: near its ends the joints may be others than those of the whole toolpath.
/// @param progress  stage "joints"
/// @throws as the one above
KinematicModelRun runOn(const KinematicModel& model, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress);

/// The joints that a program states, judged (`judged`) and not led.
KinematicModelRun runAsStated(const KinematicModel& model, StatedMotion motion,
                              const JointPathSettings& settings);

/// @throws Unreachable if the path has faults: how many, and the first
void requireRunnable(const KinematicModelRun& run, const KinematicModel& model);

/// What the limits of the joints make of a run.
struct RunTime {
  double total_s = 0.0;
  double slow_bead_share =
      0.0;  ///< of the length of beads, deposited below 95 % of the feed asked for (`slowBeadShare`)
};

/// A run in time.
struct TimedRun {
  KinematicModelRun run;
  std::unique_ptr<TimedPath> trajectory;
  ToolpathTime time;
  RunTime figures;
};

/// @throws Unreachable as `requireRunnable`; as `TimedPath`
TimedRun inTime(KinematicModelRun run, const KinematicModel& model, const TimingSettings& settings);

}  // namespace lamina
