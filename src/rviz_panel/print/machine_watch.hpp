// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <string>

namespace lamina {

/// What the machine reports, for a person.
struct WatchedState {
  std::string text;  ///< state, job, layer and temperatures in one line
  bool is_printing = false;
  bool is_held = false;
};

/// Watches the topic `machine_state` (lamina/MachineState), and asks the streamer to hold the job or to go
/// on. Never waits: calls of services run beside, their answers come with `poll`.
class MachineWatch {
 public:
  MachineWatch();

  std::function<void(const WatchedState& report)> reported;
  std::function<void(const std::string& reason)> refused;  ///< a call was not done

  void hold();
  void goOn();
  void poll();

 private:
  struct Answers;

  void call(const std::string& service);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::shared_ptr<Answers> answers_;  ///< outlives the watch while a call is under way
};

}  // namespace lamina
