// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "lamina/cell/plc_watch.hpp"
#include "messages.hpp"

namespace lamina {

/// The inputs of a PLC as the unit sees them, received on a topic and with commands.
class PlcDesk {
 public:
  /// @param heard  called when the topic has a new message
  PlcDesk(ros::NodeHandle node, const PlcWatchSettings& settings, std::function<void()> heard);

  /// Takes the inputs that came with a command; they may be ahead of the topic.
  void hear(const lamina_msgs::PlcInputs& said);

  PlcWatch& watch() { return watch_; }
  const PlcWatch& watch() const { return watch_; }

  /// Fraction of the programmed speed that the PLC requests; 1 if it requests none.
  double speed() const { return said_.speed; }

 private:
  void onSaid(const lamina_msgs::PlcInputsConstPtr& said);

  std::function<void()> heard_;
  PlcWatch watch_;
  lamina_msgs::PlcInputs said_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
