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

/// Stops a machine, as `stopMachine` does one that reads programs.
using MachineStopper =
    std::function<MachineStopReport(const MachinePulse& machine, const std::function<void()>& begun)>;

/// Receiver of a watch's reports, called from its thread.
struct WatchObserver {
  std::function<void(const GuardNews&)> news;
  std::function<void()> begun;                     ///< a stop has begun; may be empty
  std::function<void(const MachinePulse&)> heard;  ///< each pulse; may be empty
};

/// Watches the process that moves one machine, in a thread of its own, and stops the machine in its place
/// (`MachineGuard`). A process that hangs, and has the port, is ended first.
class StreamerWatch {
 public:
  /// @param stop  called from the watch's thread
  /// @throws InvalidInput, DeviceError as `PulseListener`
  StreamerWatch(const std::string& socket, GuardSettings settings, WatchObserver observer,
                MachineStopper stop = stopMachine);
  /// Waits for a stop under way, and stops what was left and not taken up, once.
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
