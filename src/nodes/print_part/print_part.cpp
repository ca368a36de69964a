// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_part.hpp"

#include <ros/callback_queue.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <set>

#include "conversions.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/picture/toolpath_picture.hpp"
#include "names.hpp"
#include "service_call.hpp"
#include "shutdown.hpp"
#include "status.hpp"
#include "tf/transform_intake.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

constexpr std::chrono::seconds kSafeStopPatience{20};

/// The answer of an action that is done; its status is what it ended with.
template <class Client>
auto resultOf(Client& client, const std::string& action) {
  const auto result = client.getResult();
  if (!result)
    throw Disconnected("action " + action + " ended without a result: " + client.getState().toString());
  throwIfFailed(result->status);
  return *result;
}

}  // namespace

PrintPart::PrintPart(ros::NodeHandle node, PrintPartSettings settings)
    : settings_(std::move(settings)),
      node_(node),
      slice_(node, names::kSlice, false),
      stream_(node, names::kStreamProgram, false),
      save_height_map_(node.serviceClient<std_srvs::Trigger>(names::kSaveHeightMap)),
      finish_measuring_(node.serviceClient<lamina_msgs::FinishMeasuring>(names::kFinishMeasuring)),
      machine_rest_(node.serviceClient<lamina_msgs::MachineRest>(names::kMachineRest)) {
  std::filesystem::create_directories(settings_.output_folder);
  settings_.output_folder = std::filesystem::absolute(settings_.output_folder);
  // The nodes that read the part may run in another folder.
  if (std::filesystem::exists(settings_.part)) settings_.part = std::filesystem::absolute(settings_.part);
  subscribe(node);
  await("slicing_service", [this] { return slice_.isServerConnected(); });
  await("gcode_streamer", [this] { return stream_.isServerConnected(); });
  await("layer_height_monitor", [this] { return save_height_map_.exists(); });
}

void PrintPart::subscribe(ros::NodeHandle& node) {
  const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> onToolpath =
      [this](const auto& toolpath) { toolpath_ = toolpath; };
  const boost::function<void(const lamina_msgs::MeasuringConstPtr&)> onMeasuring =
      [this](const auto& measuring) { measuring_ = measuring; };
  toolpath_subscriber_ = node.subscribe<lamina_msgs::Toolpath>(names::kToolpath, 1, onToolpath);
  measuring_subscriber_ = node.subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, onMeasuring);
  layer_subscriber_ = node.subscribe(names::kLayerHeight, 0, &PrintPart::onLayer, this);
}

void PrintPart::onLayer(const lamina_msgs::LayerHeightConstPtr& layer) {
  if (!isOfThisPrint(*layer)) return;
  layers_.push_back(*layer);
  noteAdvance();
}

bool PrintPart::isOfThisPrint(const lamina_msgs::LayerHeight& layer) const {
  return toolpath_ != nullptr && layer.toolpath_id == toolpath_->id &&
         layer.header.stamp >= toolpath_->header.stamp;
}

PrintReport PrintPart::run() {
  const auto start = Clock::now();
  PrintReport report;
  report.part = settings_.part;
  const ros::Time asked_at = ros::Time::now();
  const auto sliced = slice();
  report.toolpath_id = sliced.toolpath_id;
  report.slicing = sliced.summary;
  // The same part may have been sliced before, and that toolpath is latched.
  await("toolpath", [&] {
    return toolpath_ != nullptr && toolpath_->id == sliced.toolpath_id && toolpath_->header.stamp >= asked_at;
  });
  scanned_ = scannedLayers(fromMessage(*toolpath_).toolpath, settings_.scan_clearance_mm);
  awaitMeasuring();
  awaitFollowing();
  report.streaming = stream();
  awaitHeights();
  report.layers = layers_;
  report.counts = finish_.counts;
  report.has_everything = has_everything_;
  report.unreported = unreported();
  report.wall_time_s = std::chrono::duration<double>(Clock::now() - start).count();
  saveHeightMap();
  saveFiles(report);
  return report;
}

lamina_msgs::SliceResult PrintPart::slice() {
  lamina_msgs::SliceGoal goal;
  goal.part = settings_.part;
  goal.output = outputFile("part.gcode");
  slice_.sendGoal(goal, {}, {}, [this](const lamina_msgs::SliceFeedbackConstPtr& feedback) {
    console_.show(feedback->stage, feedback->fraction, "");
    noteAdvance();
  });
  await("slicing_service", [this] { return slice_.getState().isDone(); });
  console_.finish();
  return resultOf(slice_, names::kSlice);
}

lamina_msgs::StreamProgramResult PrintPart::stream() {
  lamina_msgs::StreamProgramGoal goal;
  goal.program = outputFile("part.gcode");
  stream_.sendGoal(goal, {}, {}, [this](const lamina_msgs::StreamProgramFeedbackConstPtr& feedback) {
    console_.show("print", feedback->fraction,
                  std::to_string(feedback->lines_acknowledged) + " / " +
                      std::to_string(feedback->lines_total) + " lines, " + std::to_string(layers_.size()) +
                      " layers measured");
    noteAdvance();
  });
  try {
    await("gcode_streamer", [this] { return stream_.getState().isDone(); });
  } catch (...) {
    stopStreaming();
    throw;
  }
  console_.finish();
  return resultOf(stream_, names::kStreamProgram);
}

/// Nobody looks after a machine whose print was given up.
void PrintPart::stopStreaming() {
  if (!ros::ok()) return;  // then ROS shuts gcode_streamer down as well
  stream_.cancelGoal();
  const auto give_up = Clock::now() + kSafeStopPatience;
  while (ros::ok() && !stream_.getState().isDone() && Clock::now() < give_up)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
}

void PrintPart::awaitMeasuring() {
  await("layer_height_monitor, profile and tf", [this] {
    return measuring_ != nullptr && measuring_->toolpath_id == toolpath_->id &&
           measuring_->toolpath_stamp == toolpath_->header.stamp;
  });
  layers_.clear();
}

/// Motions that no node turns into tf would be lost. A machine that states where it rests has published that
/// place, and tf of it is latched.
void PrintPart::awaitFollowing() {
  if (!machine_rest_.exists()) return;
  tf2::BufferCore buffer;
  const TransformIntake intake(buffer, node_);
  await("trajectory_publisher, tf of where the machine rests", [&] {
    return askRest() && lookUp(buffer, names::kBedFrame, names::kNozzleFrame, rest_.last_position);
  });
}

/// The monitor lags behind the machine by as much as the host is slow. A machine that states the stamps of
/// its last motion gives it an end; one that does not has had its time once nothing comes any more.
void PrintPart::awaitHeights() {
  const double patience_s = 0.9 * settings_.patience_s;  // before `await` takes it for a failure
  await("layer_height_monitor", [this, patience_s] { return isMeasured() || silence() > patience_s; });
  has_everything_ = isMeasured();
  if (!finish_.is_finished) askFinish(ros::Time(), ros::Time());
  layers_ = finish_.layers;
  if (layers_.empty()) throw TimedOut("no layer height was measured; the scan passes gave no profiles");
}

bool PrintPart::isMeasured() {
  if (!machine_rest_.exists()) return unreported().empty();
  return askRest() && askFinish(rest_.last_position, rest_.last_profile);
}

/// Whether the machine says that it rests.
bool PrintPart::askRest() {
  lamina_msgs::MachineRest rest;
  if (!callService(machine_rest_.getService(), rest)) return false;
  if (rest.response.last_position != rest_.last_position) noteAdvance();
  rest_ = rest.response;
  return rest_.is_resting;
}

/// Whether the monitor has had everything up to these stamps.
bool PrintPart::askFinish(const ros::Time& last_position, const ros::Time& last_profile) {
  lamina_msgs::FinishMeasuring finish;
  finish.request.toolpath_id = toolpath_->id;
  finish.request.last_position = last_position;
  finish.request.last_profile = last_profile;
  if (!callService(finish_measuring_.getService(), finish))
    throw Disconnected("layer_height_monitor does not answer");
  throwIfFailed(finish.response.status);
  if (finish.response.counts != finish_.counts) noteAdvance();
  finish_ = finish.response;
  return finish_.is_finished;
}

std::vector<std::size_t> PrintPart::unreported() const {
  std::set<std::size_t> reported;
  for (const auto& layer : layers_) reported.insert(layer.layer);
  std::vector<std::size_t> missing;
  for (const std::size_t layer : scanned_)
    if (reported.count(layer) == 0) missing.push_back(layer);
  return missing;
}

void PrintPart::saveHeightMap() {
  std_srvs::Trigger request;
  if (!callService(save_height_map_.getService(), request))
    throw Disconnected("layer_height_monitor does not answer");
  if (!request.response.success) throw FileError("height map not saved: " + request.response.message);
}

void PrintPart::saveFiles(const PrintReport& report) {
  drawToolpath(fromMessage(*toolpath_).toolpath, {}, outputFile("toolpath.png"));
  writeFile(outputFile("summary"), summaryText(report));
}

std::string PrintPart::outputFile(const std::string& name) const {
  return settings_.output_folder + "/" + name;
}

void PrintPart::await(const std::string& what, const std::function<bool()>& isDone) {
  noteAdvance();
  while (!isDone()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    if (isStopRequested() || !ros::ok())
      throw Cancelled("printing was interrupted while waiting for " + what);
    if (silence() > settings_.patience_s)
      throw TimedOut("nothing from " + what + " for " +
                     std::to_string(static_cast<int>(settings_.patience_s)) + " s");
  }
}

double PrintPart::silence() const {
  return std::chrono::duration<double>(Clock::now() - last_advance_).count();
}

}  // namespace lamina
