// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_height_monitor.hpp"

#include "conversions.hpp"
#include "height_files.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"

namespace lamina {

LayerHeightMonitor::LayerHeightMonitor(ros::NodeHandle node, const LayerHeightMonitorSettings& settings)
    : settings_(settings),
      topics_(node),
      intake_(node, settings.queue, [this](const PlacedProfile& profile) { onProfile(profile); }) {
  diagnostics_.setHardwareID("none");
  diagnostics_.add("layer heights",
                   [this](diagnostic_updater::DiagnosticStatusWrapper& status) { diagnose(status); });
  toolpath_ = node.subscribe(names::kToolpath, 1, &LayerHeightMonitor::onToolpath, this);
  save_ = node.advertiseService(names::kSaveHeightMap, &LayerHeightMonitor::onSave, this);
  timer_ = node.createWallTimer(ros::WallDuration(0.1), [this](const ros::WallTimerEvent&) { onTimer(); });
}

LayerHeightMonitor::~LayerHeightMonitor() {
  if (is_saved_ || settings_.output_folder.empty()) return;
  try {
    const auto done = monitor_->finish();
    if (done) layers_.push_back(*done);
    save();
  } catch (...) {
    // ROS is down: its log no longer reaches anybody.
    std::fprintf(stderr, "layer heights not saved: %s\n", currentFailure().message.c_str());
  }
}

void LayerHeightMonitor::onToolpath(const lamina_msgs::ToolpathConstPtr& message) {
  monitor_.reset();
  layers_.clear();
  is_saved_ = true;
  try {
    MachineToolpath placed = fromMessage(*message);
    toolpath_id_ = placed.id;
    monitor_ =
        std::make_unique<HeightMonitor>(std::move(placed.toolpath), placed.bed_from_part, settings_.monitor);
    toolpath_fault_.clear();
    const HeightGrid& grid = monitor_->measured().grid();
    ROS_INFO_STREAM("measuring toolpath " << toolpath_id_ << " in " << grid.columns << " x " << grid.rows
                                          << " cells of " << grid.cell_mm << " mm");
  } catch (...) {
    toolpath_fault_ = currentFailure().message;
    ROS_ERROR_STREAM("cannot measure toolpath " << message->id << ": " << toolpath_fault_);
  }
}

void LayerHeightMonitor::onProfile(const PlacedProfile& profile) {
  if (!monitor_) {
    ++profiles_without_toolpath_;
    return;
  }
  const auto done = monitor_->insert(profile.points, profile.nozzle_height_mm);
  maps_changed_ = true;
  is_saved_ = false;
  if (done) report(*done);
}

void LayerHeightMonitor::report(const LayerHeightReport& layer) {
  layers_.push_back(layer);
  topics_.publish(layer, toolpath_id_);
  ROS_INFO("layer %zu: mean error %.4f mm, rms %.4f mm, worst %.4f mm, %.1f %% seen", layer.layer,
           layer.statistics.mean_mm, layer.statistics.rms_mm, layer.statistics.worst_mm,
           100.0 * layer.statistics.coverage);
}

void LayerHeightMonitor::onTimer() {
  diagnostics_.update();
  if (!monitor_) return;
  const double now = clock_.now();
  if (isScanOver(now)) {
    const auto done = monitor_->finish();
    if (done) report(*done);
  }
  if (!maps_changed_ || now - last_maps_s_ < settings_.map_period_s) return;
  topics_.publishMaps(*monitor_);
  maps_changed_ = false;
  last_maps_s_ = now;
}

bool LayerHeightMonitor::isScanOver(double now) {
  const std::size_t cells = monitor_->cellsInScan();
  if (cells != cells_in_scan_) last_news_s_ = now;
  cells_in_scan_ = cells;
  return cells > 0 && now - last_news_s_ > settings_.quiet_s;
}

bool LayerHeightMonitor::onSave(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  try {
    if (!monitor_) throw InvalidInput("no toolpath has come yet, so there is no map to save");
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
  saveHeights(settings_.output_folder, *monitor_, layers_);
  is_saved_ = true;
}

void LayerHeightMonitor::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const IntakeCounts counts = intake_.counts();
  const std::uint64_t bad = counts.lost + counts.untransformable + counts.without_frame + counts.malformed;
  if (!toolpath_fault_.empty())
    status.summary(DiagnosticStatus::ERROR, "toolpath refused: " + toolpath_fault_);
  else if (bad > 0)
    status.summary(DiagnosticStatus::WARN, std::to_string(bad) + " clouds were not used");
  else
    status.summary(DiagnosticStatus::OK, monitor_ ? "measuring" : "waiting for a toolpath");
  status.add("toolpath", toolpath_id_);
  status.add("layers measured", layers_.size());
  status.add("clouds received", counts.received);
  status.add("clouds placed", counts.placed);
  status.add("clouds waiting", counts.waiting);
  status.add("clouds lost on the way", counts.lost);
  status.add("clouds without transform", counts.untransformable);
  status.add("clouds without frame", counts.without_frame);
  status.add("clouds malformed", counts.malformed);
  status.add("last malformed cloud", counts.last_fault);
  status.add("profiles without nozzle pose", counts.without_nozzle);
  status.add("profiles without toolpath", profiles_without_toolpath_);
  status.add("points not finite", counts.points_not_finite);
  status.add("profiles of layers", monitor_ ? monitor_->profilesOfLayers() : 0);
  status.add("other profiles", monitor_ ? monitor_->otherProfiles() : 0);
  status.add("points outside the map", monitor_ ? monitor_->pointsOutside() : 0);
}

}  // namespace lamina
