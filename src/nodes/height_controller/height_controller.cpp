// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "height_controller.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/control/report/loop_report.hpp"
#include "lamina/control/run/run_calibration.hpp"
#include "loop/loop_messages.hpp"
#include "loop_diagnostics.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// Layers that a plan takes the place of are to be waited for, not begun.
void withholdReplaced(LoopNews& news) {
  if (news.plans.empty()) return;
  const auto is_replaced = [first = news.plans.back().layer](const CorrectionMap& map) {
    return map.layer >= first;
  };
  for (auto* const maps : {&news.maps, &news.coasting_maps})
    maps->erase(std::remove_if(maps->begin(), maps->end(), is_replaced), maps->end());
}

constexpr double kTurn = 0.02;              // s between looks at what is due
constexpr double kQuietFor = 0.5;           // s without anything new: nothing older comes
constexpr double kLateArrivals = 10.0;      // s after the end of a job
constexpr std::uint32_t kUnboundQueue = 0;  // what is left out is left out, and counted, by the feed

LoopRunSettings calibratedRun(const HeightControllerSettings& settings) {
  LoopRunSettings run = withCalibrationFile(settings.run);
  run.keeps_memory = !settings.memory_file.empty();
  return run;
}

}  // namespace

HeightController::HeightController(ros::NodeHandle node, const HeightControllerSettings& settings)
    : settings_(settings),
      topics_(node),
      alarms_(node),
      feed_(calibratedRun(settings), settings.queue_mb),
      hold_(settings.arrival_hold_s),
      memory_(settings.memory_file),
      calibrator_(node, settings.run.calibration.file, settings.queue_mb) {
  diagnostics_.begin("none", "height loop", [this](auto& status) { diagnose(status); });
  know(feed_.settings());
  alarms_.settle(memory_.stood());
  subscribe(node);
  read_calibration_ =
      node.advertiseService(names::kReadCalibration, &HeightController::onReadCalibration, this);
  set_loop_ = node.advertiseService(names::kSetLoop, &HeightController::onSetLoop, this);
  timer_ = node.createWallTimer(ros::WallDuration(kTurn), [this](const ros::WallTimerEvent&) { onTimer(); });
  topics_.publish(toMessage(feed_.run()));
}

void HeightController::subscribe(ros::NodeHandle& node) {
  const auto hints = ros::TransportHints().tcpNoDelay();
  toolpath_ = node.subscribe(names::kToolpath, 1, &HeightController::onToolpath, this);
  machine_state_ = node.subscribe(names::kMachineState, 100, &HeightController::onMachineState, this);
  applied_ = node.subscribe(names::kAppliedCorrection, 100, &HeightController::onApplied, this);
  profile_ = node.subscribe(names::kProfile, kUnboundQueue, &HeightController::onCloud, this, hints);
  const boost::function<void(const TfEvent&)> on_tf = [this](const TfEvent& event) { onTransforms(event); };
  const boost::function<void(const TfEvent&)> on_fixed = [this](const TfEvent& event) {
    onFixedTransforms(event);
  };
  tf_ = node.subscribe<tf2_msgs::TFMessage>("/tf", kUnboundQueue, on_tf, {}, hints);
  tf_static_ = node.subscribe<tf2_msgs::TFMessage>("/tf_static", kUnboundQueue, on_fixed, {}, hints);
}

HeightController::~HeightController() {
  try {
    if (ended_) endJob();
    hold_.releaseAll();
    feed_.finish();
    publishNews();
    save();
  } catch (...) {
    // ROS is down: its log no longer reaches anybody.
    std::fprintf(stderr, "report of the height loop not saved: %s\n", currentFailure().message.c_str());
  }
}

void HeightController::onToolpath(const lamina_msgs::ToolpathConstPtr& message) {
  if (isFollowedPlan(message->id) || isDeliveredAgain(*message)) return;
  print_hold_.release();
  if (ended_) endJob();
  hold_.releaseAll();
  if (feed_.run() != nullptr) {
    feed_.finish();
    publishNews();
    save();
    memory_.forget();
  }
  const bool is_first = !announced_toolpath_;
  announced_toolpath_ = delivered_toolpath_ = message;
  if (!firstLayerOf(message->id)) part_toolpath_ = message;
  calibrator_.setMachine(message->machine);
  beginPrint(*message);
  // What was kept is of the print that a node before this one was over.
  if (is_first && feed_.run() != nullptr) memory_.resume(*feed_.run());
  publishNews();
}

/// Latched messages may come twice, and a plan is gone on with once: begun anew, the loop would have learnt
/// nothing.
bool HeightController::isFollowedPlan(const std::string& toolpath_id) const {
  return feed_.run() != nullptr && feed_.run()->part().toolpath_id == toolpath_id &&
         firstLayerOf(toolpath_id).has_value();
}

/// Of a latched message ROS delivers the same once more where a connection broke off and was made again:
/// begun anew amid a print, the loop would wait at the first layer for what lies far below the nozzle.
bool HeightController::isDeliveredAgain(const lamina_msgs::Toolpath& message) const {
  const auto is_same = [&message](const lamina_msgs::ToolpathConstPtr& before) {
    return before && before->id == message.id && before->header.stamp == message.header.stamp;
  };
  return !message.header.stamp.isZero() && (is_same(delivered_toolpath_) || is_same(part_toolpath_));
}

void HeightController::beginPrint(const lamina_msgs::Toolpath& toolpath) {
  digests_.clear();
  parts_.begin();
  is_learnt_saved_ = false;
  try {
    const bool goes_on = feed_.add(toolpath);
    const PlacedPart& part = feed_.run()->part();
    // Of a plan that the loop goes on with, the report goes on.
    if (goes_on) {
      layers_below_ += firstLayerOf(part.toolpath_id).value_or(0);
    } else {
      // A plan that is begun with: the loop was started anew, or the machine prints the plan once more.
      layers_below_ = firstLayerOf(part.toolpath_id).value_or(0);
      record_ = LoopRecord(part.toolpath.part_name, part.toolpath_id);
      topics_.clearCells();
    }
    toolpath_fault_.clear();
    ROS_INFO_STREAM("the loop over toolpath " << part.toolpath_id << " is "
                                              << toString(feed_.run()->status().state) << " "
                                              << feed_.run()->status().reason);
  } catch (...) {
    record_ = LoopRecord();
    toolpath_fault_ = currentFailure().message;
    ROS_ERROR_STREAM("no loop over toolpath " << toolpath.id << ": " << toolpath_fault_);
  }
}

/// A machine that starts, or is at layers that were done, prints the same part once more.
void HeightController::beginAgainIfOver(const lamina_msgs::MachineState& machine) {
  const auto& resumed = memory_.resumedAfter();
  if (!resumed) return;
  const bool is_below = machine.layer >= 0 && static_cast<std::size_t>(machine.layer) < *resumed;
  if (machine.state != lamina_msgs::MachineState::STARTING && !is_below) return;
  ROS_WARN("the machine is at layer %d: what was kept after layer %zu is of a print before", machine.layer,
           *resumed);
  memory_.forget();
  beginPrint(*announced_toolpath_);
  publishNews();
}

void HeightController::beginNextPart(const lamina_msgs::MachineState& machine) {
  const LoopRun* run = feed_.run();
  // A plan counts its layers anew: whether one lies below another cannot be told.
  const bool is_of_part = run != nullptr && part_toolpath_ && run->part().toolpath_id == part_toolpath_->id;
  const bool begins = parts_.see(machine, is_of_part ? run->place().layer : 0);
  if (!begins || run == nullptr || !part_toolpath_) return;
  ROS_INFO("the machine begins another part of toolpath %s", part_toolpath_->id.c_str());
  announced_toolpath_ = part_toolpath_;
  beginPrint(*announced_toolpath_);
  parts_.see(machine, 0);  // of this part
  publishNews();
}

void HeightController::onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  last_arrival_s_ = clock_.now();
  is_quiet_ = false;
  feed_.add(cloud);
  calibrator_.add(cloud);
  hold_.add(last_arrival_s_, [this, header = cloud->header] { feed_.hear(header); });
}

void HeightController::onTransforms(const TfEvent& event) {
  last_arrival_s_ = clock_.now();
  is_quiet_ = false;
  for (const auto& transform : event.getMessage()->transforms) calibrator_.add(transform);
  hold_.add(last_arrival_s_, [this, message = event.getMessage(), from = event.getPublisherName()] {
    for (const auto& transform : message->transforms) feed_.add(transform, from);
  });
}

void HeightController::onFixedTransforms(const TfEvent& event) {
  for (const auto& transform : event.getMessage()->transforms) {
    feed_.addFixed(transform, event.getPublisherName());
    calibrator_.addFixed(transform);
  }
}

void HeightController::onMachineState(const lamina_msgs::MachineStateConstPtr& message) {
  if (ended_ && !isEnd(*message)) endJob();
  beginAgainIfOver(*message);
  beginNextPart(*message);
  if (feed_.run() == nullptr) return;
  if (isUnderWay(*message)) feed_.run()->goOn();
  if (!isEnd(*message)) return;
  // An executor repeats how the print before has ended.
  if (!parts_.hasRun() && !memory_.resumedAfter()) return;
  const double since_s = ended_ ? ended_->since_s : clock_.now();
  ended_ = EndedJob{message->state, since_s};
  endIfDue();
}

/// Of a job that is complete, what was seen last may arrive after the machine has said so.
bool HeightController::isWaitingForLast() const {
  if (ended_->state != lamina_msgs::MachineState::COMPLETE || feed_.run() == nullptr) return false;
  const bool is_done = feed_.run()->place().layer >= feed_.run()->part().toolpath.layers.size();
  return !is_done && !is_quiet_ && clock_.now() - ended_->since_s < kLateArrivals;
}

void HeightController::endIfDue() {
  if (ended_ && !isWaitingForLast()) endJob();
}

void HeightController::endJob() {
  const std::uint8_t state = ended_->state;
  ended_.reset();
  const bool was_resumed = memory_.resumedAfter().has_value();
  if (parts_.hasRun()) endPrint(state);
  memory_.forget();
  if (!was_resumed) return;
  beginPrint(*announced_toolpath_);
  publishNews();
}

void HeightController::endPrint(std::uint8_t state) {
  const bool is_complete = state == lamina_msgs::MachineState::COMPLETE;
  print_hold_.release();
  hold_.releaseAll();
  feed_.pass();
  if (is_complete) feed_.finish();
  if (feed_.run() != nullptr) feed_.run()->interrupt();
  publishNews();
  save();
  if (is_complete) saveLearnt();
}

/// The machine may be ahead of what tf has said of it so far.
void HeightController::onApplied(const lamina_msgs::AppliedCorrectionConstPtr& message) {
  if (feed_.add(*message)) publishNews();
}

bool HeightController::onSetLoop(lamina_msgs::SetLoop::Request& request,
                                 lamina_msgs::SetLoop::Response& response) {
  try {
    feed_.request(loopRequestOf(request));
    if (feed_.run() != nullptr) memory_.keepStatus(feed_.run()->status());
    if (feed_.run() == nullptr)
      response.status.message = "there is no toolpath yet: this holds from the next one on";
  } catch (...) {
    const Failure failure = currentFailure();
    const std::string toolpath_id = feed_.run() == nullptr ? "" : feed_.run()->part().toolpath_id;
    ROS_ERROR_STREAM(refusalText(
        {"take loop request " + std::to_string(request.request) + " for toolpath", toolpath_id, ""},
        failure));
    response.status = toMessage(failure);
  }
  publishNews();
  response.state = toMessage(feed_.run()).state;
  return true;
}

void HeightController::know(const LoopRunSettings& settings) {
  known_ = settings.calibration.sources;
  for (const std::string& source : known_) ROS_INFO_STREAM(source);
}

void HeightController::recalibrate() {
  feed_.recalibrate(calibratedRun(settings_));
  know(feed_.settings());
}

bool HeightController::onReadCalibration(std_srvs::Trigger::Request& /*request*/,
                                         std_srvs::Trigger::Response& response) {
  try {
    recalibrate();
    response.success = 1U;
    for (const std::string& source : known_)
      response.message += (response.message.empty() ? "" : "; ") + source;
  } catch (...) {
    response.message = currentFailure().message;
  }
  publishNews();
  return true;
}

void HeightController::onTimer() {
  const double now = clock_.now();
  if (calibrator_.takeWritten()) {
    try {
      recalibrate();
    } catch (const Error& error) {
      ROS_ERROR("the calibration is not gone by: %s", error.what());
    }
  }
  hold_.release(now);
  feed_.pass();
  // A machine that waits for its map reports nothing new, which would bring the stamps on.
  const double quiet_s = settings_.arrival_hold_s + std::max(kQuietFor, settings_.run.reorder_s);
  if (!is_quiet_ && now - last_arrival_s_ > quiet_s) {
    feed_.passAll();
    is_quiet_ = true;
  }
  publishNews();
  endIfDue();
  if (const auto late = print_hold_.takeLate()) ROS_WARN("%s", late->c_str());
  diagnostics_.update();
}

void HeightController::publishNews() {
  if (feed_.run() != nullptr) {
    LoopNews news = feed_.run()->takeNews();
    if (settings_.plans_followed) withholdReplaced(news);
    // First: a print that has to be held does not begin its next layer.
    for (const PrintPlan& plan : news.plans) report(plan);
    for (const RaisedAlarm& alarm : news.alarms) report(alarm);
    // Ahead of the others: the last map, which is latched, is that of the layer under way.
    for (const CorrectionMap& coasting : news.coasting_maps) topics_.publish(coasting);
    auto map = news.maps.begin();
    const auto publishUpTo = [&](std::size_t layer) {
      for (; map != news.maps.end() && map->layer <= layer; ++map)
        digests_[map->layer] = topics_.publish(*map);
    };
    for (const LayerOutcome& layer : news.layers) {
      publishUpTo(layer.figures.layer);
      report(layer);
    }
    publishUpTo(std::numeric_limits<std::size_t>::max());
    // Behind the maps: what is kept of a layer says that the map of the next one is out.
    if (news.memory) memory_.keep(*news.memory);
    if (!news.layers.empty() && feed_.run()->place().layer >= feed_.run()->part().toolpath.layers.size()) {
      save();
      memory_.forget();
    }
  }
  settleAlarms();
  topics_.publish(toMessage(feed_.run()));
}

/// Until the first toolpath comes, what a node before this one has left stands.
void HeightController::settleAlarms() {
  if (feed_.run() != nullptr) {
    alarms_.settle(feed_.run()->standing());
    memory_.keepStanding(feed_.run()->standing());
  } else if (announced_toolpath_) {
    alarms_.settle({});
  }
}

void HeightController::report(const PrintPlan& plan) {
  topics_.publish(plan);
  ROS_WARN("the layers from %zu on are planned anew as toolpath %s, of %zu layers: %s", plan.layer,
           plan.part.toolpath_id.c_str(), plan.part.toolpath.layers.size(), plan.reason.c_str());
}

void HeightController::report(const RaisedAlarm& alarm) {
  ROS_WARN("alarm %d: %s", static_cast<int>(alarm.alarm), alarm.reason.c_str());
  alarms_.raise(alarm);
  if (!holdsPrint(alarm, settings_)) return;
  topics_.publish(toMessage(feed_.run()));
  ROS_WARN("%s", print_hold_.hold().c_str());
}

void HeightController::report(const LayerOutcome& layer) {
  const LayerFigures& figures = layer.figures;
  const std::string& digest = digests_[figures.layer];
  topics_.publish(toMessage(layer, feed_.run()->part().toolpath_id, digest));
  topics_.publishCells(layer, layers_below_, feed_.run()->part().bed_from_part);
  record_.add(layer, digest);
  is_saved_ = false;
  ROS_INFO("layer %zu: rmse %.3f mm, mean %.3f mm, %.0f %% seen, gain %.3f, %s", figures.layer,
           figures.rmse_mm, figures.mean_error_mm, 100.0 * figures.coverage, figures.gain_mean,
           toString(layer.state));
}

void HeightController::save() {
  if (is_saved_ || settings_.output_folder.empty()) return;
  try {
    saveLoopReport(settings_.output_folder, record_);
    is_saved_ = true;
  } catch (const Error& error) {
    ROS_ERROR("%s", error.what());
    is_saved_ = true;  // once is enough to say so
  }
}

/// Only of parts that are complete, once: what is learnt is used when an operator asks for it.
void HeightController::saveLearnt() {
  if (is_learnt_saved_ || settings_.output_folder.empty()) return;
  try {
    const auto map = feed_.run()->learnt(PartEnd::Complete);
    if (!map) return;
    const std::string path = settings_.output_folder + "/learnt_part.csv";
    writeFile(path, partMapCsv(*map));
    is_learnt_saved_ = true;
    ROS_INFO("what %zu parts have taught is in %s: the next one is deposited by it with loop/learned",
             map->parts, path.c_str());
  } catch (const Error& error) {
    ROS_ERROR("%s", error.what());
  }
}

void HeightController::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  for (const std::string& source : known_) status.add("calibration", source);
  const LoopRun* run = feed_.run();
  if (run == nullptr) {
    const bool is_refused = !toolpath_fault_.empty();
    status.summary(is_refused ? DiagnosticStatus::ERROR : DiagnosticStatus::OK,
                   is_refused ? toolpath_fault_ : "no toolpath yet");
    return;
  }
  const LoopState state = run->status().state;
  const bool is_well =
      state == LoopState::Off || state == LoopState::Identifying || state == LoopState::Active;
  status.summary(
      is_well ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
      std::string(toString(state)) + (run->status().reason.empty() ? "" : ": ") + run->status().reason);
  addCounts(feed_.counts(), run->counts(), status);
  status.add("layer", run->place().layer);
}

}  // namespace lamina
