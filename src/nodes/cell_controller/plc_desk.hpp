// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "lamina/cell/plc_watch.hpp"
#include "messages.hpp"

namespace lamina {

/// What a PLC says, by topic and beside its commands, as the unit sees it.
class PlcDesk {
 public:
  /// @param heard  called when the topic has brought something new
  PlcDesk(ros::NodeHandle node, const PlcWatchSettings& settings, std::function<void()> heard);

  /// Takes what came beside a command, which may be ahead of the topic.
  void hear(const lamina_msgs::PlcInputs& said);

  PlcWatch& watch() { return watch_; }
  const PlcWatch& watch() const { return watch_; }

  /// Part of the programmed speed that the PLC asks for: 1 if it asks for none.
  double speed() const { return said_.speed; }

 private:
  void onSaid(const lamina_msgs::PlcInputsConstPtr& said);

  std::function<void()> heard_;
  PlcWatch watch_;
  lamina_msgs::PlcInputs said_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
