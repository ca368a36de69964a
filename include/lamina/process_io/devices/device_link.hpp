// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/process_io/devices/process_device.hpp"
#include "lamina/process_io/lateness.hpp"

namespace lamina {

/// What a device link reports.
struct DeviceReport {
  bool is_connected = false;
  bool is_hung = false;        ///< a call of the device has not come back
  std::string reason;          ///< why it is not
  std::string note;            ///< what was to be warned of as it was opened; once
  std::vector<double> inputs;  ///< raw, of the last exchange; empty before the first
  double late_s = 0.0;         ///< the worst begin of an exchange since the last report
};

/// How well a device was served.
struct DeviceFigures {
  Lateness late;        ///< begins of exchanges, after they were due
  Lateness round_trip;  ///< of exchanges
};

/// Exchanges values with a device in a thread of its own: who sends never waits. A device that is lost is
/// opened again; the first values after opening, and the last before the end, are the safe ones.
class DeviceLink {
 public:
  /// @param clock  must outlive it
  /// @param safe   raw, in the order of the device's table
  DeviceLink(std::unique_ptr<ProcessDevice> device, const DeviceSettings& settings, const Clock& clock,
             std::vector<double> safe);
  ~DeviceLink();
  DeviceLink(const DeviceLink&) = delete;
  DeviceLink& operator=(const DeviceLink&) = delete;

  /// Takes the place of what was not sent yet.
  /// @param due_s  when it should be sent, by the clock
  void send(std::vector<double> raw, double due_s);
  DeviceReport report();
  DeviceFigures figures() const;

 private:
  struct Waiting {
    std::vector<double> raw;
    double due_s = 0.0;
  };
  void run();
  bool waitForWork(std::unique_lock<std::mutex>& lock);
  void tryToOpen();
  void exchange(const Waiting& values);
  void lose(const std::string& why);

  std::unique_ptr<ProcessDevice> device_;
  DeviceSettings settings_;
  const Clock& clock_;
  std::vector<double> safe_;

  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::optional<Waiting> waiting_;
  std::optional<double> busy_since_s_;
  DeviceReport report_;
  DeviceFigures figures_;
  double retry_at_s_ = 0.0;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
