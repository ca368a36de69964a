// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/kinematic_model_run.hpp"

#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/stated_joints.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "lamina/trajectory/kept_feed.hpp"
#include "lamina/verification/collision/self_collision_guard.hpp"

namespace lamina {

KinematicModelRun runOn(const KinematicModel& model, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  const SelfCollisionGuard guard(model, linkBodies(model.urdf()));
  DividedJointPath planned =
      planDividedJointPath(std::move(toolpath), bed_from_part, {model, guard}, settings, progress);
  return {std::move(planned.divided), bed_from_part, std::move(planned.joints), {}};
}

KinematicModelRun runAsStated(const KinematicModel& model, StatedMotion motion,
                              const JointPathSettings& settings) {
  KinematicModelRun run;
  run.path = judged(std::move(motion.joints), motion.toolpath, model, settings);
  run.divided = undivided(std::move(motion.toolpath));
  run.lines = std::move(motion.lines);
  return run;
}

void requireRunnable(const KinematicModelRun& run, const KinematicModel& model) {
  if (run.path.isRunnable()) return;
  const FaultyWaypoint& first = run.path.faults.front();
  throw Unreachable(toText(run.divided.originalOf(first.at)) + ": " + first.reason + " (" +
                    toString(first.fault) + ", the first of " + std::to_string(run.path.faults.size()) +
                    " places that " + model.name() + " cannot run)");
}

TimedRun inTime(KinematicModelRun run, const KinematicModel& model, const TimingSettings& settings) {
  requireRunnable(run, model);
  TimedRun timed;
  timed.trajectory = std::make_unique<TimedPath>(run.toolpath(), run.path, model, settings);
  timed.time = trajectoryTime(*timed.trajectory, run.path, run.toolpath().layers.size());
  timed.figures = {timed.time.total_s, slowBeadShare(*timed.trajectory, run.path, run.toolpath())};
  timed.run = std::move(run);
  return timed;
}

}  // namespace lamina
