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

/// State of a device link.
struct DeviceReport {
  bool is_connected = false;
  bool is_hung = false;        ///< a call to the device has not returned for twice its time-out
  std::string reason;          ///< why the device is not connected
  std::string note;            ///< warning from opening the device; in one report only
  std::vector<double> inputs;  ///< raw values of the last exchange; empty if there is none
  double late_s = 0.0;         ///< greatest delay of an exchange's begin since the last report
};

/// Delays and durations of the exchanges with a device.
struct DeviceFigures {
  Lateness late;        ///< time from when an exchange was due to its begin
  Lateness round_trip;  ///< from the begin of an exchange to its end
};

/// Exchanges values with a device in a thread of its own, so that callers never wait. If the connection is
/// lost, the device is opened again. The first values sent after opening, and the last ones before the link
/// ends, are the safe values.
class DeviceLink {
 public:
  /// @param clock  must outlive the link
  /// @param safe  safe values, raw, in the order of the device's table
  DeviceLink(std::unique_ptr<ProcessDevice> device, const DeviceSettings& settings, const Clock& clock,
             std::vector<double> safe);
  ~DeviceLink();
  DeviceLink(const DeviceLink&) = delete;
  DeviceLink& operator=(const DeviceLink&) = delete;

  /// Gives values to be sent, in place of values that were not sent yet.
  /// @param raw  in the order of the device's table
  /// @param due_s  time by the clock at which they should be sent
  void send(std::vector<double> raw, double due_s);
  DeviceReport report();
  DeviceFigures figures() const;

  /// Sends the safe values for the last time and closes the device. The destructor does so too, but waits for
  /// the device however long it takes.
  /// @return false if a call to the device has not returned for twice its time-out: the link has not ended
  /// yet
  bool end();

 private:
  struct Waiting {
    std::vector<double> raw;
    double due_s = 0.0;
  };
  void run();
  bool waitForWork(std::unique_lock<std::mutex>& lock);
  bool isHung() const;
  void beginCall();
  void tryToOpen();
  void exchange(const Waiting& values);
  void lose(const std::string& why);

  std::unique_ptr<ProcessDevice> device_;
  DeviceSettings settings_;
  const Clock& clock_;
  std::vector<double> safe_;

  mutable std::mutex mutex_;  ///< guards the members below
  std::condition_variable changed_;
  std::optional<Waiting> waiting_;
  std::optional<double> busy_since_s_;  ///< begin of the call to the device that has not returned
  DeviceReport report_;
  DeviceFigures figures_;
  double retry_at_s_ = 0.0;
  bool is_ending_ = false;
  bool has_ended_ = false;
  std::thread thread_;
};

}  // namespace lamina
