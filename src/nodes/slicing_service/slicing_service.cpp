// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing_service.hpp"

#include <set>

#include "lamina/base/error.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/profiles/machine_defaults.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "latched.hpp"
#include "markers/collision_markers.hpp"
#include "markers/frame_markers.hpp"
#include "markers/overhang_markers.hpp"
#include "markers/region_markers.hpp"
#include "markers/toolpath_markers.hpp"
#include "names.hpp"
#include "progress/action_end.hpp"
#include "progress/action_progress.hpp"
#include "progress/service_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr double kCubicMillimetresPerCubicMetre = 1e9;

/// What service and action have in common.
template <class Request, class Message>
Request requestOf(const Message& message) {
  return {message.part,     message.settings, message.output,
          message.material, message.process,  message.is_file_only != 0};
}

}  // namespace

SlicingService::SlicingService(ros::NodeHandle node, const JobSettings& settings)
    : settings_(settings),
      toolpath_(node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kToolpathMarkers, 1, true)),
      overhang_markers_(node.advertise<visualization_msgs::MarkerArray>(names::kOverhangMarkers, 1, true)),
      collision_markers_(node.advertise<visualization_msgs::MarkerArray>(names::kCollisionMarkers, 1, true)),
      frame_markers_(node.advertise<visualization_msgs::MarkerArray>(names::kFrameMarkers, 1, true)),
      refusal_markers_(node.advertise<visualization_msgs::MarkerArray>(names::kRefusalMarkers, 1, true)),
      service_(node.advertiseService(names::kSliceMesh, &SlicingService::onService, this)),
      action_(
          node, names::kSlice, [this](const lamina_msgs::SliceGoalConstPtr& goal) { onGoal(goal); }, false) {
  action_.start();
}

bool SlicingService::onService(lamina_msgs::SliceMesh::Request& request,
                               lamina_msgs::SliceMesh::Response& response) {
  ServiceProgress progress;
  const Answer given = answer(requestOf<Request>(request), progress);
  response.status = given.status;
  response.toolpath_id = given.toolpath_id;
  response.summary = given.summary;
  return true;
}

void SlicingService::onGoal(const lamina_msgs::SliceGoalConstPtr& goal) {
  ActionProgress<lamina_msgs::SliceAction> progress(action_);
  const Answer given = answer(requestOf<Request>(*goal), progress);
  lamina_msgs::SliceResult result;
  result.status = given.status;
  result.toolpath_id = given.toolpath_id;
  result.summary = given.summary;
  endGoal(action_, result);
}

SlicingService::Answer SlicingService::answer(const Request& request, Progress& progress) {
  try {
    const std::unique_lock<std::mutex> lock(job_, std::try_to_lock);
    if (!lock) throw Rejected("another part is being sliced; wait for it or cancel it");
    ROS_INFO_STREAM("slicing '" << request.part << "'");
    Answer given = slice(request, progress);
    ROS_INFO_STREAM("sliced '" << request.part << "' into " << given.summary.layers << " layers, toolpath "
                               << given.toolpath_id);
    if (given.summary.unprinted_volume > 0.0)
      ROS_WARN_STREAM("not printed of '" << request.part << "': "
                                         << given.summary.unprinted_volume * kCubicMillimetresPerCubicMetre
                                         << " mm^3, too small or too thin for the fill");
    return given;
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"slice", request.part, request.output}, failure));
    Answer refused;
    refused.status = toMessage(failure);
    return refused;
  }
}

JobSettings SlicingService::settingsOf(const Request& request) const {
  JobSettings settings = settings_;
  SettingsSchema schema;
  describe(schema, settings);
  std::set<std::string> typed = changedKeys(settings_);
  applyProfiles(schema, {"", settings_.machine.name, request.material, request.process, "", {}},
                ProfileLibrary(profileFolders()));
  applyRequest(schema, request.settings);
  for (const lamina_msgs::Setting& setting : request.settings) typed.insert(setting.key);
  return withMachineDefaults(settings, typed);
}

SlicingService::Answer SlicingService::slice(const Request& request, Progress& progress) {
  if (request.is_file_only && request.output.empty())
    throw InvalidInput("output is empty; expected a file, since nothing is to be published");
  const SliceJob job{request.part, request.output, settingsOf(request)};
  SlicedPart sliced = request.is_file_only ? runSliceJob(job, progress) : runShown(job, progress);
  Answer answer;
  answer.summary = toMessage(sliced.summary);
  answer.toolpath_id = toolpathId(sliced.toolpath);
  if (request.is_file_only) return answer;
  const Findings findings = find(sliced, job.settings, progress);
  MachineToolpath placed;
  placed.id = answer.toolpath_id;
  placed.machine = buildSpaceOf(job.settings.machine).name;
  placed.bed_from_part = sliced.bed_from_part;
  placed.toolpath = std::move(sliced.toolpath);
  publish(placed, findings, job.settings.frames);
  return answer;
}

SlicedPart SlicingService::runShown(const SliceJob& job, Progress& progress) {
  publishLatched(refusal_markers_, noRegionMarkers(names::kPartFrame));
  try {
    return runSliceJob(job, progress);
  } catch (const Unsliceable& refusal) {
    publishLatched(refusal_markers_, regionMarkers(refusal, names::kPartFrame));
    throw;
  }
}

SlicingService::Findings SlicingService::find(const SlicedPart& sliced, const JobSettings& settings,
                                              Progress& progress) {
  Findings findings;
  if (settings.overhang.is_shown)
    findings.overhangs = findOverhangs(sliced.toolpath, sliced.bed_from_part, settings.overhang, progress);
  if (!settings.clearance.is_shown) return findings;
  const auto model = kinematicModelOf(settings.machine);
  const CheckedMachine machine(*model);
  JointPathSettings joints = settings.joints;
  joints.tool_offsets_mm = toolOffsets(settings.planning.tools);
  const KinematicModelRun run = runOn(machine, sliced.toolpath, sliced.bed_from_part, joints, progress);
  if (!run.path.isRunnable())
    ROS_WARN_STREAM(model->name() << " cannot be led to " << run.path.faults.size()
                                  << " waypoints, the first: " << run.path.faults.front().reason);
  findings.clearance = clearanceOf(run, machine, settings.clearance, progress);
  if (findings.clearance.colliding > 0)
    ROS_WARN_STREAM(model->name() << " collides at " << findings.clearance.colliding
                                  << " waypoints, first in layer "
                                  << findings.clearance.first_of_layers.front().at.layer);
  return findings;
}

void SlicingService::publish(const MachineToolpath& placed, const Findings& findings,
                             const FrameSettings& frames) {
  publishLatched(toolpath_, stamped(placed, ros::Time::now()));
  publishLatched(markers_, toolpathMarkers(placed.toolpath, names::kPartFrame));
  publishLatched(overhang_markers_, overhangMarkers(findings.overhangs, names::kPartFrame));
  publishLatched(collision_markers_, collisionMarkers(findings.clearance, names::kBedFrame));
  publishLatched(frame_markers_, frameMarkers(placed.toolpath, frames, names::kPartFrame));
}

}  // namespace lamina
