// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposition_simulator.hpp"

#include <ros/ros.h>

#include <utility>
#include <vector>

#include "conversions.hpp"
#include "deposit_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "progress/action_end.hpp"
#include "progress/action_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// What a goal asks to be deposited.
struct AskedToolpath {
  std::string id;
  Toolpath toolpath;  ///< in coordinates of the bed
};

std::vector<SettingText> typedIn(const lamina_msgs::SimulateDepositionGoal& goal) {
  std::vector<SettingText> typed;
  typed.reserve(goal.settings.size());
  for (const lamina_msgs::Setting& setting : goal.settings) typed.push_back({setting.key, setting.value});
  return typed;
}

AskedToolpath fromProgram(const std::string& program, const SimulationSettings& settings) {
  AskedToolpath asked;
  asked.toolpath = readToolpathFile(program, settings.reading, settings.machine);
  asked.id = toolpathId(asked.toolpath);
  return asked;
}

AskedToolpath fromLatched(const lamina_msgs::ToolpathConstPtr& latched, const std::string& id) {
  if (!latched) throw InvalidInput("no toolpath has come yet; expected one on 'toolpath', or a program");
  if (!id.empty() && id != latched->id)
    throw InvalidInput("toolpath_id is '" + id + "'; the toolpath that is there is '" + latched->id + "'");
  const MachineToolpath read = fromMessage(*latched);
  return {read.id, placed(read.toolpath, read.bed_from_part)};
}

}  // namespace

DepositionSimulator::DepositionSimulator(ros::NodeHandle node, const DepositionSimulatorSettings& settings)
    : settings_(settings),
      deposited_(node.advertise<sensor_msgs::PointCloud2>(names::kDeposited, 1, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kDepositedMarkers, 1, true)),
      following_(settings.mode == SimulatorMode::Follow ? std::make_unique<DepositFollowing>(node, settings)
                                                        : nullptr),
      toolpaths_(node.subscribe(names::kToolpath, 1, &DepositionSimulator::onToolpath, this)),
      action_(
          node, names::kSimulateDeposition,
          [this](const lamina_msgs::SimulateDepositionGoalConstPtr& goal) { onGoal(*goal); }, false) {
  action_.start();
}

void DepositionSimulator::onToolpath(const lamina_msgs::ToolpathConstPtr& message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    toolpath_ = message;
  }
  if (following_) following_->begin(*message);
}

lamina_msgs::ToolpathConstPtr DepositionSimulator::latched() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return toolpath_;
}

void DepositionSimulator::onGoal(const Goal& goal) {
  ActionProgress<lamina_msgs::SimulateDepositionAction> progress(action_);
  Result result;
  try {
    result = simulate(goal, progress);
  } catch (...) {
    const Failure failure = currentFailure();
    const std::string& subject = goal.program.empty() ? goal.toolpath_id : goal.program;
    ROS_ERROR_STREAM(refusalText({"lay", subject, goal.output}, failure));
    result = {};
    result.status = toMessage(failure);
  }
  endGoal(action_, result);
}

DepositionSimulator::Result DepositionSimulator::simulate(const Goal& goal, Progress& progress) {
  SimulationSettings settings = settings_.simulation;
  SettingsSchema schema;
  describe(schema, settings);
  applyRequest(schema, goal.settings);
  settings.reading.is_diameter_given = givesFilamentDiameter(typedIn(goal));
  AskedToolpath asked =
      goal.program.empty() ? fromLatched(latched(), goal.toolpath_id) : fromProgram(goal.program, settings);
  ROS_INFO_STREAM("laying toolpath " << asked.id << " of '" << asked.toolpath.part_name << "'");
  const DepositedPart deposited =
      runDepositJob({std::move(asked.toolpath), goal.output, goal.program, settings.deposition}, progress);
  Result result;
  result.toolpath_id = asked.id;
  result.summary = toMessage(deposited.summary);
  ROS_INFO("toolpath %s deposited: %.1f mm3 of %.1f mm3 in voxels of %g mm", asked.id.c_str(),
           deposited.summary.totals.deposited_mm3, deposited.summary.totals.extruded_mm3,
           deposited.summary.voxel_mm);
  if (following_) return result;
  publishLatched(deposited_, depositedCloud(deposited.grid, settings_.shown));
  publishLatched(markers_, depositedMarkers(deposited.grid, settings_.shown));
  return result;
}

}  // namespace lamina
