// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/streaming/guard/machine_guard.hpp"
#include "lamina/streaming/guard/machine_stop.hpp"
#include "lamina/streaming/guard/pulse_link.hpp"

namespace lamina {

/// Function that stops a machine; `stopMachine` for machines that read programs.
using MachineStopper =
    std::function<MachineStopReport(const MachinePulse& machine, const std::function<void()>& begun)>;

/// Callbacks of a `StreamerWatch`, called from its thread.
struct WatchObserver {
  std::function<void(const GuardNews&)> news;
  std::function<void()> begun;                     ///< called when a stop has begun; may be empty
  std::function<void(const MachinePulse&)> heard;  ///< called with each pulse; may be empty
};

/// Watches the process that moves a machine, in a thread of its own, and stops the machine on its behalf when
/// `MachineGuard` decides so. If that process hangs and holds the port, it is killed first.
class StreamerWatch {
 public:
  /// @param socket  path at which pulses are received (`PulseListener`)
  /// @param stop  called from the watch's thread
  /// @throws InvalidInput, DeviceError as `PulseListener`
  StreamerWatch(const std::string& socket, GuardSettings settings, WatchObserver observer,
                MachineStopper stop = stopMachine);
  /// Waits for a stop under way; if a lost process has left work that nobody has taken up, tries once to stop
  /// its machine.
  ~StreamerWatch();
  StreamerWatch(const StreamerWatch&) = delete;
  StreamerWatch& operator=(const StreamerWatch&) = delete;

 private:
  void run();
  void hear(double timeout_s);
  void tell();
  void stop(const GuardOrder& order);
  void endHung(int process);

  SteadyClock clock_;
  PulseListener listener_;
  MachineGuard guard_;
  WatchObserver observer_;
  MachineStopper stop_;
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

}  // namespace lamina
