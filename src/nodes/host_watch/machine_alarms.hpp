// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lamina/cell/host_watch.hpp"
#include "lamina/streaming/guard/machine_guard.hpp"

namespace lamina {

/// The alarms of a watched machine: 2201 while its streamer is lost, 2203 when the machine was stopped in the
/// streamer's place, 2204 while stopping it fails.
class MachineAlarms {
 public:
  /// Alarms to be raised, and alarms that are gone.
  std::vector<HostAlarm> of(const GuardNews& news);
  /// The present state of all conditions; those that do not stand are reported as gone.
  std::vector<HostAlarm> present() const;

 private:
  std::map<int, std::string> raised_;
};

}  // namespace lamina
