// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_incliner.hpp"

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/gcode_rewrite/rewrite_report.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "latched.hpp"
#include "markers/toolpath_markers.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "progress/action_end.hpp"
#include "progress/action_progress.hpp"
#include "progress/service_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// Wall time is left to the caller.
lamina_msgs::InclineSummary toMessage(const RewriteReport& report) {
  lamina_msgs::InclineSummary summary;
  summary.slicer = report.slicer;
  summary.lines = report.lines;
  summary.layers = static_cast<std::uint32_t>(report.layers);
  summary.motions = report.motions;
  summary.depositions = report.depositions;
  summary.arcs_made_chords = report.arcs;
  summary.homings_annulled = static_cast<std::uint32_t>(report.homings_annulled);
  summary.build_aids_dropped = report.aids_dropped;
  summary.layer_height = toMetres(report.layer_height_mm);
  summary.shift.x = toMetres(report.shift.x());
  summary.shift.y = toMetres(report.shift.y());
  summary.shift.z = toMetres(report.shift.z());
  summary.part_low = lamina::toMessage(report.part.low);
  summary.part_high = lamina::toMessage(report.part.high);
  summary.stands_on_edge = static_cast<std::uint8_t>(standsOnEdge(report));
  return summary;
}

constexpr double kBytesPerMegabyte = 1e6;

/// Reports why the programs are too large to be viewed, if they are.
std::optional<std::string> tooLarge(const std::string& program, const std::string& output, double most_mb) {
  const auto bytes = std::max(std::filesystem::file_size(program), std::filesystem::file_size(output));
  const double size_mb = static_cast<double>(bytes) / kBytesPerMegabyte;
  if (size_mb <= most_mb) return std::nullopt;
  return "not published: the program holds " + numberText(size_mb) + " MB, and view.largest_program_mb is " +
         numberText(most_mb);
}

}  // namespace

GcodeIncliner::GcodeIncliner(ros::NodeHandle node, const GcodeInclinerSettings& settings)
    : settings_(settings),
      toolpath_(node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kToolpathMarkers, 1, true)),
      source_markers_(
          node.advertise<visualization_msgs::MarkerArray>(names::kSourceToolpathMarkers, 1, true)),
      service_(node.advertiseService(names::kInclineGcode, &GcodeIncliner::onService, this)),
      action_(
          node, names::kInclineGcode, [this](const lamina_msgs::InclineGoalConstPtr& goal) { onGoal(goal); },
          false) {
  action_.start();
}

bool GcodeIncliner::onService(lamina_msgs::InclineGcode::Request& request,
                              lamina_msgs::InclineGcode::Response& response) {
  ServiceProgress progress;
  const Answer given = answer({request.program, request.output, request.settings}, progress);
  response.status = given.status;
  response.output = given.output;
  response.toolpath_id = given.toolpath_id;
  response.summary = given.summary;
  return true;
}

void GcodeIncliner::onGoal(const lamina_msgs::InclineGoalConstPtr& goal) {
  ActionProgress<lamina_msgs::InclineAction> progress(action_);
  const Answer given = answer({goal->program, goal->output, goal->settings}, progress);
  lamina_msgs::InclineResult result;
  result.status = given.status;
  result.output = given.output;
  result.toolpath_id = given.toolpath_id;
  result.summary = given.summary;
  endGoal(action_, result);
}

GcodeIncliner::Answer GcodeIncliner::answer(const Request& request, Progress& progress) {
  try {
    const std::unique_lock<std::mutex> lock(job_, std::try_to_lock);
    if (!lock) throw Rejected("another program is being inclined; wait for it or cancel it");
    ROS_INFO_STREAM("inclining '" << request.program << "'");
    Answer given = incline(request, progress);
    ROS_INFO_STREAM("inclined '" << request.program << "' to '" << given.output
                                 << "': " << given.summary.layers << " layers, " << given.summary.motions
                                 << " motions");
    if (!given.status.message.empty()) ROS_WARN_STREAM(given.output << ": " << given.status.message);
    return given;
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"incline", request.program, request.output}, failure));
    Answer refused;
    refused.status = toMessage(failure);
    return refused;
  }
}

GcodeIncliner::Answer GcodeIncliner::incline(const Request& request, Progress& progress) {
  GcodeInclinerSettings settings = settings_;
  SettingsSchema schema;
  describe(schema, settings);
  applyRequest(schema, request.settings);
  Answer answer;
  answer.output = request.output.empty() ? inclinedName(request.program) : request.output;
  const auto begin = std::chrono::steady_clock::now();
  const RewriteReport report =
      runInclineJob(inclineJob(settings.incline, request.program, answer.output), progress);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  answer.summary = toMessage(report);
  answer.summary.wall_time = passed.count();
  if (isToolAxisOffNormal(report))
    answer.status.message = "the machine holds its nozzle at " + numberText(report.tool_axis_off_normal_deg) +
                            " deg from the normal of the layers; expected 0";
  if (beginsInAir(report)) {
    std::string& message = answer.status.message;
    message += (message.empty() ? "" : "; ") + noticeOnFirstLayer(report);
  }
  progress.report("view", 0.0);
  view(request.program, settings, answer);
  return answer;
}

/// The file is written by now: what cannot be shown is reported, and is no failure.
void GcodeIncliner::view(const std::string& program, const GcodeInclinerSettings& settings, Answer& answer) {
  try {
    const auto refusal = tooLarge(program, answer.output, settings.largest_viewed_mb);
    if (refusal) throw InvalidInput(*refusal);
    answer.toolpath_id = publish(program, settings, answer.output);
  } catch (...) {
    std::string& message = answer.status.message;
    message += (message.empty() ? "" : "; ") + currentFailure().message;
  }
}

/// @return the toolpath's id
std::string GcodeIncliner::publish(const std::string& program, const GcodeInclinerSettings& settings,
                                   const std::string& output) {
  const auto source = toolpathMarkers(toolpathFromGcodeFile(program, settings.program), names::kBedFrame);
  MachineToolpath placed;
  placed.toolpath = toolpathFromGcodeFile(output, settings.program);
  placed.id = toolpathId(placed.toolpath);
  if (const auto space = buildSpaceOf(settings.incline)) placed.machine = space->name;
  publishLatched(toolpath_, stamped(placed, ros::Time::now()));
  publishLatched(source_markers_, source);
  publishLatched(markers_, toolpathMarkers(placed.toolpath, names::kBedFrame));
  return placed.id;
}

}  // namespace lamina
