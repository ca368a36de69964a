// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/process_io/channel_drive.hpp"
#include "lamina/process_io/lateness.hpp"
#include "lamina/process_io/process_plan.hpp"
#include "lamina/process_io/process_watch.hpp"

namespace lamina {

struct ProcessBridgeSettings {
  double rate_hz = 100.0;
  double late_s = Lateness::kLate;         ///< lateness of an output above which alarm 5103 is raised
  double too_late_s = Lateness::kTooLate;  ///< lateness of an output above which 5104 is raised
  double standstill_s = 0.3;  ///< longest time for which the beam may be on without motion; 0 for no limit
  /// Time from the start after which a device that was never connected raises an alarm.
  double connect_wait_s = 5.0;
};

/// Adds the keys rate_hz, late_s, too_late_s, standstill_s and connect_wait_s.
void describe(SettingsSchema& schema, ProcessBridgeSettings& settings);

/// State of a device at a cycle.
struct DeviceView {
  bool is_connected = false;
  std::string reason;  ///< why the device is not connected
};

/// Input of a cycle besides the plan.
struct CycleView {
  std::vector<DeviceView> devices;  ///< in the order of the tables
  std::vector<double> measured;     ///< of each input [unit of its quantity]; NaN if it is not read
  double late_s = 0.0;              ///< greatest lateness of an output since the last cycle
};

/// Result of a cycle.
struct BridgeCycle {
  /// Values to be sent to the channels, in the order of the tables [unit of the channel's quantity].
  std::vector<double> values;
  std::vector<ProcessAlarm> alarms;
  std::string fault;  ///< why the process cannot be run; empty if it can
};

/// Finds the values that devices are to be sent, cycle by cycle, from the plan of a process. It does no input
/// or output itself: callers pass times and measured values, and send the values.
///
/// Values are the safe ones wherever the plan is not known. A device that is not connected, an output that is
/// too late (5104), a beam without motion (5105) and a plan that begins with a flow where nothing was known
/// before, as after a restart, trip the bridge: all values are then the safe ones until every device is
/// connected and the plan has had the process off for half a second, so that no bead is begun in its middle.
class ProcessBridge {
 public:
  ProcessBridge(const ProcessTables& tables, const ProcessBridgeSettings& settings, double now_s);

  /// Adds a chunk to the plan.
  /// @throws InvalidInput as `ProcessPlan::accept`
  void accept(const ProcessChunk& chunk, double now_s);
  /// Gives positions of joints by name, as `StandstillWatch::hear` takes them [m, rad].
  void updatePositions(const std::map<std::string, double>& positions, double now_s) {
    motion_.hear(positions, now_s);
  }

  /// Computes one cycle; to be called at the rate of the settings. Times must not go back.
  BridgeCycle cycle(double now_s, const CycleView& view);
  /// Drops the plan. Returns safe values for all channels.
  std::vector<double> stop(double now_s);

  const std::vector<ChannelDrive>& drives() const { return drives_; }
  /// The signals that are planned for a time; safe signals if they are not known.
  ProcessSignals planned(double now_s) const { return plan_.at(now_s).value_or(safeSignals()); }
  /// Alarms that are raised now.
  std::vector<ProcessAlarm> raised() const { return raised_.all(); }
  bool isTripped() const { return !trip_.empty(); }
  /// Number of chunks that changed values already sent; values are sent ahead of time by the dead time.
  std::uint64_t overtaken() const { return overtaken_; }
  /// Number of chunks that came after their first values should have been sent.
  std::uint64_t lateChunks() const { return late_chunks_; }

 private:
  bool isProcessOn() const;
  void lookAtDevices(double now_s, const std::vector<DeviceView>& devices);
  void lookAtLateness(double now_s, double late_s);
  void lookAtAsked();
  void lookAtBeam(double now_s);
  void trip(const std::string& why);
  void rearm(double now_s);

  ProcessTables tables_;
  ProcessBridgeSettings settings_;
  double begin_s_;
  double longest_lead_s_ = 0.0;
  ProcessPlan plan_;
  std::vector<ChannelDrive> drives_;
  InputWatch inputs_;
  StandstillWatch motion_;
  RaisedAlarms raised_;
  std::vector<ProcessAlarm> events_;
  std::vector<bool> was_connected_;
  bool are_all_connected_ = false;
  std::string trip_;  ///< why the bridge has tripped; empty if it has not
  std::optional<double> off_since_s_;
  std::optional<double> mid_bead_s_;  ///< when a plan comes that begins in the middle of a bead
  std::optional<double> beam_since_s_;
  double chunk_late_s_ = 0.0;  ///< greatest lateness of a chunk since the last cycle
  double late_reported_s_;
  std::uint64_t overtaken_ = 0;
  std::uint64_t late_chunks_ = 0;
};

}  // namespace lamina
