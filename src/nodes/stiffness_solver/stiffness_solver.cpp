// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness_solver.hpp"

#include <ros/ros.h>

#include "lamina/base/error.hpp"
#include "lamina/job/stiffness_job.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "progress/action_end.hpp"
#include "progress/action_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"
#include "stiffness_messages.hpp"

namespace lamina {

StiffnessSolver::StiffnessSolver(ros::NodeHandle node, const JobSettings& settings)
    : settings_(settings),
      points_(node.advertise<sensor_msgs::PointCloud2>(names::kStiffnessPoints, 1, true)),
      action_(
          node, names::kComputeStiffness,
          [this](const lamina_msgs::ComputeStiffnessGoalConstPtr& goal) { onGoal(*goal); }, false) {
  action_.start();
}

void StiffnessSolver::onGoal(const Goal& goal) {
  ActionProgress<lamina_msgs::ComputeStiffnessAction> progress(action_);
  Result result;
  try {
    result = compute(goal, progress);
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"put under load", goal.part, goal.output}, failure));
    result = {};
    result.status = toMessage(failure);
  }
  endGoal(action_, result);
}

StiffnessSolver::Result StiffnessSolver::compute(const Goal& goal, Progress& progress) {
  StiffnessJob job;
  job.input = goal.part;
  job.solid = goal.is_printed ? PartSolid::AsDeposited : PartSolid::AsDrawn;
  job.output = goal.output;
  job.deck = goal.deck;
  job.settings = settings_;
  SettingsSchema schema;
  describe(schema, job.settings);
  applyRequest(schema, goal.settings);
  ROS_INFO_STREAM("putting '" << job.input << "' under load");
  const LoadedPart part = runStiffnessJob(job, progress);
  publishLatched(points_, stiffnessCloud(part.result));
  ROS_INFO("'%s' bears %g N, as a solid body of %g MPa would; %d iterations in %.1f s", job.input.c_str(),
           part.result.force_n, part.result.modulus_mpa, part.result.iterations, part.solve_s);
  return toMessage(part.result);
}

}  // namespace lamina
