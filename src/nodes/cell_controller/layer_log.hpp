// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/journal/execution_log.hpp"
#include "messages.hpp"

namespace lamina {

/// Writes other nodes' reports on layers of the part under way into the journal. Failures to write are logged
/// only: the cell itself raises the alarm of an unwritable journal.
class LayerLog {
 public:
  LayerLog(ros::NodeHandle node, CellJournal& journal);

  /// Assigns later reports to this execution; nothing: to none. Its layers begin with the next layer.
  void follow(std::optional<std::int64_t> execution, const lamina_msgs::MachineState& machine);

  /// States that the machine is at that layer, or at the end of its last layer.
  void onMachine(const lamina_msgs::MachineState& machine);
  void onEnd(const lamina_msgs::MachineState& machine);

  /// The execution whose layers were measured after its end, once; they are those of its toolpath, until the
  /// next one begins.
  std::optional<std::int64_t> takeLate();

 private:
  void onHeight(const lamina_msgs::LayerHeightConstPtr& height);
  void onFigures(const lamina_msgs::LoopFiguresConstPtr& figures);
  void onApplied(const lamina_msgs::AppliedCorrectionConstPtr& applied);
  void keep(const LayerRow& row);
  void keepMeasured(const LayerRow& row, const std::string& toolpath_id);
  void keepStartup(const lamina_msgs::MachineState& machine);
  void write(const std::function<void()>& rows);

  ExecutionLog log_;
  std::optional<std::int64_t> execution_;
  std::int32_t layer_ = -1;
  std::string toolpath_id_;            ///< of what was measured of it; empty if nothing was
  std::optional<std::int64_t> ended_;  ///< the one before, while no other has begun
  bool is_late_ = false;               ///< whether that was measured since its end
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace lamina
