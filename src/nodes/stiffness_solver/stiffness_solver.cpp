// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness_solver.hpp"

#include <ros/ros.h>
#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/stiffness_job.hpp"
#include "lamina/stiffness/stiffness.hpp"
#include "lamina/stiffness/surface_points.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "progress/action_end.hpp"
#include "progress/action_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

lamina_msgs::ComputeStiffnessResult toMessage(const StiffnessResult& result) {
  lamina_msgs::ComputeStiffnessResult message;
  message.force = result.force_n;
  message.modulus = toPascals(result.modulus_mpa);
  message.greatest_stress = toPascals(static_cast<double>(result.greatest_stress_mpa));
  message.elements = static_cast<std::uint64_t>(result.model.lattice.elementCount());
  for (const DroppedPart& part : result.dropped)
    message.elements_left_out += static_cast<std::uint64_t>(part.elements);
  message.iterations = static_cast<std::uint32_t>(result.iterations);
  message.residual = result.residual;
  return message;
}

/// The nodes on the surface where they were before the load, in frame `bed`, with the fields
/// `displacement_x`, `_y`, `_z` [m] and `von_mises` [Pa].
sensor_msgs::PointCloud2 stiffnessCloud(const StiffnessResult& result) {
  const SurfacePoints surface = surfacePoints(result);
  std::vector<Point3> places;
  std::vector<CloudField> fields{
      {"displacement_x", {}}, {"displacement_y", {}}, {"displacement_z", {}}, {"von_mises", {}}};
  for (std::size_t i = 0; i < surface.place.size(); ++i) {
    places.emplace_back(surface.place[i].cast<double>());
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      fields[static_cast<std::size_t>(axis)].values.push_back(
          static_cast<float>(toMetres(static_cast<double>(surface.displacement[i][axis]))));
    fields[3].values.push_back(static_cast<float>(toPascals(static_cast<double>(surface.von_mises[i]))));
  }
  sensor_msgs::PointCloud2 cloud = toCloudMessage(places, fields);
  cloud.header.stamp = ros::Time::now();
  cloud.header.frame_id = names::kBedFrame;
  return cloud;
}

}  // namespace

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
