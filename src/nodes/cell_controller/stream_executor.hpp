// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "action_executor.hpp"
#include "messages.hpp"

namespace lamina {

/// The node gcode_streamer as the cell's executor: its jobs are programs of G-code.
class StreamExecutor final : public ActionExecutor<lamina_msgs::StreamProgramAction> {
 public:
  /// @param report  receives the executor's reports
  StreamExecutor(const ros::NodeHandle& node, std::function<void(const ExecutorReport&)> report);

 protected:
  lamina_msgs::StreamProgramGoal goalOf(const StartOrder& order) const override;
  std::uint64_t takenThrough(const lamina_msgs::StreamProgramResult& result) const override;
};

}  // namespace lamina
