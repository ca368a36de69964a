// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lamina/cell/host_watch.hpp"

namespace lamina {

/// Checks the ROS graph repeatedly: whether the master knows this node, and whether the watched nodes answer,
/// and by which process. It has a thread of its own, since requests to a lost master block.
class GraphLook {
 public:
  /// @param mutex  of the watch
  GraphLook(std::vector<std::string> nodes, double interval_s, HostWatch& watch, std::mutex& mutex);
  ~GraphLook();
  GraphLook(const GraphLook&) = delete;
  GraphLook& operator=(const GraphLook&) = delete;

 private:
  void run();
  void look();

  std::vector<std::string> nodes_;
  double interval_s_;
  HostWatch& watch_;
  std::mutex& mutex_;
  std::mutex ending_mutex_;
  std::condition_variable ending_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
