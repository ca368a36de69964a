// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_log.hpp"

#include <ros/ros.h>

#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;  // of a metre

double utcNow() { return ros::WallTime::now().toSec(); }

std::optional<double> known(double value) {
  if (!std::isfinite(value) || value == 0.0) return std::nullopt;
  return value;
}

}  // namespace

LayerLog::LayerLog(ros::NodeHandle node, CellJournal& journal)
    : log_(journal),
      subscribers_({node.subscribe(names::kLayerHeight, 100, &LayerLog::onHeight, this),
                    node.subscribe(names::kLoopFigures, 100, &LayerLog::onFigures, this),
                    node.subscribe(names::kAppliedCorrection, 100, &LayerLog::onApplied, this)}) {}

void LayerLog::follow(std::optional<std::int64_t> execution, const lamina_msgs::MachineState& machine) {
  ended_ = execution ? std::nullopt : execution_;
  if (execution) {
    toolpath_id_.clear();
    is_late_ = false;
  }
  execution_ = execution;
  layer_ = -1;
  if (execution_) keepStartup(machine);
}

void LayerLog::keepStartup(const lamina_msgs::MachineState& machine) {
  write([&] {
    for (const lamina_msgs::StartupStep& step : machine.startup)
      if (std::isfinite(step.value))
        log_.add(*execution_, {utcNow(), "startup." + step.name, step.value, step.state_name});
  });
}

void LayerLog::onMachine(const lamina_msgs::MachineState& machine) {
  if (!execution_ || machine.layer <= layer_) return;
  onEnd(machine);
  layer_ = machine.layer;
  LayerRow row;
  row.layer = layer_;
  row.began_s = utcNow();
  keep(row);
}

void LayerLog::onEnd(const lamina_msgs::MachineState& machine) {
  if (!execution_ || layer_ < 0) return;
  LayerRow row;
  row.layer = layer_;
  row.ended_s = utcNow();
  row.nozzle_c = known(machine.nozzle_temperature);
  row.bed_c = known(machine.bed_temperature);
  keep(row);
}

void LayerLog::onHeight(const lamina_msgs::LayerHeightConstPtr& height) {
  if (height->sight == lamina_msgs::LayerHeight::NOT_SEEN) return;
  LayerRow row;
  row.layer = static_cast<std::int32_t>(height->layer);
  row.expected_mm = height->expected_height * kMillimetres;
  row.mean_mm = height->mean_error * kMillimetres;
  row.rms_mm = height->rms_error * kMillimetres;
  row.worst_mm = height->worst_error * kMillimetres;
  row.coverage = height->coverage;
  keepMeasured(row, height->toolpath_id);
}

/// Errors of the loop are planned less measured; those of the journal the other way round.
void LayerLog::onFigures(const lamina_msgs::LoopFiguresConstPtr& figures) {
  if (figures->is_measured == 0) return;
  LayerRow row;
  row.layer = static_cast<std::int32_t>(figures->layer);
  row.mean_mm = -figures->mean_error * kMillimetres;
  row.rms_mm = figures->rmse * kMillimetres;
  row.flatness_mm = figures->flatness * kMillimetres;
  row.coverage = figures->coverage;
  row.gain = figures->gain_mean;
  keepMeasured(row, figures->toolpath_id);
}

void LayerLog::onApplied(const lamina_msgs::AppliedCorrectionConstPtr& applied) {
  LayerRow row;
  row.layer = static_cast<std::int32_t>(applied->layer);
  row.correction = applied->digest;
  keep(row);
}

void LayerLog::keep(const LayerRow& row) {
  if (execution_) write([&] { log_.setLayer(*execution_, row); });
}

void LayerLog::keepMeasured(const LayerRow& row, const std::string& toolpath_id) {
  if (execution_) {
    toolpath_id_ = toolpath_id;
    keep(row);
    // The record may be there, and the end not followed yet.
    return write([&] { is_late_ = is_late_ || log_.part(*execution_); });
  }
  if (!ended_ || toolpath_id_.empty() || toolpath_id != toolpath_id_) return;
  write([&] { log_.setLayer(*ended_, row); });
  is_late_ = true;
}

std::optional<std::int64_t> LayerLog::takeLate() {
  return ended_ && std::exchange(is_late_, false) ? ended_ : std::nullopt;
}

void LayerLog::write(const std::function<void()>& rows) {
  try {
    rows();
  } catch (const Error& error) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "what was reported of a layer is not kept: " << error.what());
  }
}

}  // namespace lamina
