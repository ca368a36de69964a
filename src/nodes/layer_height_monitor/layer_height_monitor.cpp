// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_height_monitor.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/monitoring/layer_height_csv.hpp"
#include "lamina/monitoring/octree_export.hpp"
#include "lamina/picture/height_map_picture.hpp"
#include "names.hpp"
#include "profile_counts.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

std::string summaryOf(const HeightMonitor& monitor, const std::vector<LayerHeightReport>& layers) {
  std::ostringstream text;
  const auto is_seen = [](const LayerHeightReport& layer) { return layer.sight != LayerSight::NotSeen; };
  const auto seen = std::count_if(layers.begin(), layers.end(), is_seen);
  text << seen << " of " << monitor.toolpath().layers.size() << " layers measured";
  const auto last = std::find_if(layers.rbegin(), layers.rend(), is_seen);
  if (last != layers.rend())
    text << std::fixed << std::setprecision(3) << "; layer " << last->layer << ": mean error "
         << last->statistics.mean_mm << " mm, worst " << last->statistics.worst_mm << " mm";
  return text.str();
}

/// Writes height_map.png, deviation.png, height_map.bt and layer_heights.csv into a folder, which is made if
/// need be. Each file appears whole or not at all.
/// @throws FileError
void saveHeights(const std::string& folder, const HeightMonitor& monitor,
                 const std::vector<LayerHeightReport>& layers) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError("cannot make the folder " + folder + ": " + failure.message());
  const std::string part = monitor.toolpath().part_name;
  const std::string summary = summaryOf(monitor, layers);
  const HeightMap heights = monitor.measured().heights();
  drawHeightMap(folder + "/height_map.png", heights, {"Measured height: " + part, summary});
  drawDeviation(folder + "/deviation.png", monitor.deviation(),
                {"Measured less expected height: " + part, summary});
  writeOctree(folder + "/height_map.bt", *octreeOf(heights, kMetresPerMillimetre, monitor.bedFromHeights()));
  writeFile(folder + "/layer_heights.csv", layerHeightCsv(layers));
}

void fillIntake(const IntakeCounts& counts, diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.add("clouds received", counts.received.clouds);
  status.add("clouds placed", counts.placed.clouds);
  status.add("clouds waiting", counts.waiting.clouds);
  status.add("bytes of clouds waiting", counts.waiting_bytes);
  status.add("clouds lost on the way", counts.lost);
  status.add("clouds without transform", counts.without_transform.clouds);
  status.add("clouds without nozzle pose", counts.without_nozzle.clouds);
  status.add("clouds pushed out", counts.pushed_out.clouds);
  status.add("clouds of the print before", counts.of_former_print.clouds);
  status.add("clouds without frame or stamp", counts.without_frame.clouds);
  status.add("clouds malformed", counts.malformed.clouds);
  status.add("last malformed cloud", counts.last_fault);
  status.add("points not finite", counts.points_not_finite);
  status.add("transforms passed on early", counts.transforms_forced);
}

CalibratedSensor sensorOf(const Calibration& calibration, const SettingTable& other_time_offsets_s) {
  CalibratedSensor sensor;
  sensor.other_time_offsets_s = otherTimeOffsets(other_time_offsets_s);
  if (calibration.time) sensor.time_offset_s = calibration.time->offset_s;
  if (calibration.pose) sensor.nozzle_from_sensor = calibration.pose->nozzle_from_sensor;
  return sensor;
}

}  // namespace

LayerHeightMonitor::LayerHeightMonitor(ros::NodeHandle node, const LayerHeightMonitorSettings& settings)
    : settings_(settings),
      topics_(node),
      silence_(settings.silence_s),
      calibration_(settings.calibration.empty() ? Calibration() : readCalibration(settings.calibration)),
      intake_(node, settings.queue_mb, sensorOf(calibration_, settings.other_time_offsets_s),
              {[this](const PlacedProfile& profile) { onProfile(profile); },
               [this](const StampedNozzle& nozzle) { onNozzle(nozzle); }, [this] { onRestart(); }}) {
  diagnostics_.begin("none", "layer heights", [this](auto& status) { diagnose(status); });
  toolpath_ = node.subscribe(names::kToolpath, 1, &LayerHeightMonitor::onToolpath, this);
  machine_state_ = node.subscribe(names::kMachineState, 100, &LayerHeightMonitor::onMachineState, this);
  save_ = node.advertiseService(names::kSaveHeightMap, &LayerHeightMonitor::onSave, this);
  finish_ = node.advertiseService(names::kFinishMeasuring, &LayerHeightMonitor::onFinish, this);
  timer_ = node.createWallTimer(ros::WallDuration(0.1), [this](const ros::WallTimerEvent&) { onTimer(); });
}

LayerHeightMonitor::~LayerHeightMonitor() {
  if (is_saved_ || settings_.output_folder.empty()) return;
  try {
    const LayerHeightReports done = heights_->finish();
    layers_.insert(layers_.end(), done.begin(), done.end());
    save();
  } catch (...) {
    // ROS is down: its log no longer reaches anybody.
    std::fprintf(stderr, "layer heights not saved: %s\n", currentFailure().message.c_str());
  }
}

void LayerHeightMonitor::onToolpath(const lamina_msgs::ToolpathConstPtr& message) {
  if (heights_) intake_.startOver();  // the first toolpath may come after its clouds
  if (!is_saved_)
    ROS_WARN_STREAM("the map of toolpath " << toolpath_id_ << " is dropped unsaved: toolpath " << message->id
                                           << " has come");
  announced_ = message;
  beginPart();
}

/// Executors print a toolpath as often as they are asked to, and nobody announces it again.
void LayerHeightMonitor::onMachineState(const lamina_msgs::MachineStateConstPtr& message) {
  const std::size_t printed = heights_ ? heights_->monitor().printed().value_or(0) : 0;
  if (!parts_.see(*message, printed) || !heights_) return;
  ROS_INFO_STREAM("the machine begins another part of toolpath " << toolpath_id_);
  try {
    if (!is_finished_) report(heights_->finish());
    if (!is_saved_ && !settings_.output_folder.empty()) save();
  } catch (...) {
    ROS_ERROR_STREAM("layer heights not saved: " << currentFailure().message);
  }
  intake_.startOver();
  beginPart();
  parts_.see(*message, 0);  // of this part
}

void LayerHeightMonitor::beginPart() {
  heights_.reset();
  layers_.clear();
  parts_.begin();
  is_announced_ = is_finished_ = false;
  toolpath_stamp_ = announced_->header.stamp;
  before_ = intake_.counts();
  is_saved_ = true;
  try {
    MachineToolpath placed = fromMessage(*announced_);
    if (!settings_.calibration.empty()) requireCalibrationOf(calibration_, placed.machine);
    toolpath_id_ = placed.id;
    heights_ =
        std::make_unique<StampedHeights>(std::move(placed.toolpath), placed.bed_from_part, settings_.monitor);
    toolpath_fault_.clear();
    topics_.outdateMaps();
    const HeightGrid& grid = heights_->monitor().measured().grid();
    ROS_INFO_STREAM("measuring toolpath " << toolpath_id_ << " in " << grid.columns << " x " << grid.rows
                                          << " cells of " << grid.cell_mm << " mm");
  } catch (...) {
    toolpath_fault_ = currentFailure().message;
    ROS_ERROR_STREAM("cannot measure toolpath " << announced_->id << ": " << toolpath_fault_);
  }
}

void LayerHeightMonitor::onProfile(const PlacedProfile& profile) {
  if (!heights_) {
    ++profiles_without_toolpath_;
    return;
  }
  report(heights_->insert({static_cast<std::int64_t>(profile.stamp.toNSec()), profile.points}));
  topics_.outdateMaps();
  is_saved_ = false;
}

void LayerHeightMonitor::onNozzle(const StampedNozzle& nozzle) {
  if (!heights_) return;
  report(heights_->observe(
      {static_cast<std::int64_t>(nozzle.stamp.toNSec()), nozzle.bed_from_nozzle.translation()}));
}

/// By stamps of before, whatever comes now would be late.
void LayerHeightMonitor::onRestart() {
  if (heights_) report(heights_->restartClock());
}

void LayerHeightMonitor::report(const LayerHeightReports& layers) {
  for (const LayerHeightReport& layer : layers) {
    layers_.push_back(layer);
    topics_.publish(layer, toolpath_id_, counts());
    is_saved_ = false;
    if (layer.sight == LayerSight::NotSeen)
      ROS_WARN("layer %zu was not seen, though %zu profiles were taken in its scan", layer.layer,
               layer.profiles);
    else
      ROS_INFO("layer %zu: mean error %.4f mm, rms %.4f mm, worst %.4f mm, %.1f %% seen", layer.layer,
               layer.statistics.mean_mm, layer.statistics.rms_mm, layer.statistics.worst_mm,
               100.0 * layer.statistics.coverage);
  }
}

lamina_msgs::ProfileCounts LayerHeightMonitor::counts() const {
  return toMessage(since(before_, intake_.counts()), heights_->use());
}

/// Says once that a print may begin.
void LayerHeightMonitor::announce() {
  if (is_announced_ || !intake_.isConnected()) return;
  topics_.publishMeasuring(toolpath_id_, toolpath_stamp_);
  is_announced_ = true;
}

void LayerHeightMonitor::onTimer() {
  diagnostics_.update();
  if (!heights_) return;
  announce();
  const double now = clock_.now();
  // The last resort where no stamp shows that a scan is over.
  if (silence_.look(intake_.news(), now) && heights_->monitor().isScanning()) {
    ROS_WARN("no profile has come for %.1f s while a layer was scanned: its scan is given up",
             settings_.silence_s);
    report(heights_->cutShort());
  }
  if (!topics_.areMapsAwaited() || now - last_maps_s_ < settings_.map_period_s) return;
  topics_.publishMaps(heights_->monitor());
  last_maps_s_ = now;
}

bool LayerHeightMonitor::onFinish(lamina_msgs::FinishMeasuring::Request& request,
                                  lamina_msgs::FinishMeasuring::Response& response) {
  try {
    if (!heights_ || request.toolpath_id != toolpath_id_)
      throw Rejected("toolpath '" + request.toolpath_id + "' is not measured; expected " +
                     (heights_ ? "'" + toolpath_id_ + "'" : "a toolpath first"));
    finishOnce(request);
    response.is_finished = is_finished_;
    response.counts = counts();
    if (is_finished_)
      for (const LayerHeightReport& layer : layers_)
        response.layers.push_back(toMessage(layer, toolpath_id_, response.counts));
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"finish measuring toolpath", request.toolpath_id, ""}, failure));
    response.status = toMessage(failure);
  }
  return true;
}

void LayerHeightMonitor::finishOnce(const lamina_msgs::FinishMeasuring::Request& request) {
  if (is_finished_ || !intake_.hasCome(request.last_position, request.last_profile)) return;
  report(heights_->finish());
  is_finished_ = true;
  is_saved_ = false;
}

bool LayerHeightMonitor::onSave(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  try {
    if (!heights_) throw InvalidInput("no toolpath has come yet, so there is no map to save");
    if (settings_.output_folder.empty())
      throw InvalidConfig("parameter output_folder is empty; must name a folder");
    save();
    response.success = true;
    response.message = settings_.output_folder;
  } catch (...) {
    response.message = currentFailure().message;
    ROS_ERROR_STREAM("layer heights not saved: " << response.message);
  }
  return true;
}

void LayerHeightMonitor::save() {
  saveHeights(settings_.output_folder, heights_->monitor(), layers_);
  is_saved_ = true;
}

void LayerHeightMonitor::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const IntakeCounts intake = intake_.counts();
  const ProfileUse use = heights_ ? heights_->use() : ProfileUse();
  const std::uint64_t bad = unused(toMessage(intake, use));
  const auto missed = std::count_if(layers_.begin(), layers_.end(), [](const LayerHeightReport& layer) {
    return layer.sight == LayerSight::NotSeen;
  });
  if (!toolpath_fault_.empty())
    status.summary(DiagnosticStatus::ERROR, "toolpath refused: " + toolpath_fault_);
  else if (missed > 0)
    status.summary(DiagnosticStatus::WARN,
                   countedSubject(static_cast<std::size_t>(missed), "layer") + " not seen");
  else if (bad > 0)
    status.summary(DiagnosticStatus::WARN, countedSubject(bad, "cloud") + " not used");
  else
    status.summary(DiagnosticStatus::OK, heights_ ? "measuring" : "waiting for a toolpath");
  status.add("toolpath", toolpath_id_);
  status.add("layers measured", layers_.size() - static_cast<std::size_t>(missed));
  status.add("layers not seen", missed);
  fillIntake(intake, status);
  status.add("profiles without toolpath", profiles_without_toolpath_);
  status.add("profiles of layers", use.of_layers.profiles);
  status.add("other profiles", use.of_no_layer.profiles);
  status.add("profiles waiting for poses", use.waiting.profiles);
  status.add("profiles in gaps of poses", use.in_gap.profiles);
  status.add("profiles too late", use.late.profiles);
  status.add("points outside the map", use.points_outside);
}

}  // namespace lamina
