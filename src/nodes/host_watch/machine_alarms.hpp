// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lamina/cell/host_watch.hpp"
#include "lamina/streaming/guard/machine_guard.hpp"

namespace lamina {

/// The alarms of a watched machine: 2201 while its streamer is lost, 2203 when it was stopped in its place,
/// 2204 while that fails.
class MachineAlarms {
 public:
  /// What is to be raised, or has gone.
  std::vector<HostAlarm> of(const GuardNews& news);
  /// All conditions as they are, those that are not there as gone.
  std::vector<HostAlarm> present() const;

 private:
  std::map<int, std::string> raised_;
};

}  // namespace lamina
