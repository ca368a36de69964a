// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lamina/cell/guards.hpp"
#include "lamina/cell/unit_machine.hpp"

namespace lamina {

/// State of the PLC's heartbeat.
enum class PlcHeartbeat : std::uint8_t {
  Unarmed,  ///< the PLC has not called yet
  Good,
  Lost,
  Abandoned,  ///< lost for so long that a held unit is stopped
};

/// What is done when the heartbeat of the PLC is lost.
enum class WatchdogAction : std::uint8_t { None, Hold, Stop };

/// What the link to the PLC reports. `interlocks.is_alive` is true while the heartbeat is good;
/// `interlocks.is_beating` is also true of one that comes while its watchdog is not armed.
struct PlcReport {
  PlcInterlocks interlocks;
  PlcHeartbeat heartbeat = PlcHeartbeat::Unarmed;
  WatchdogAction on_silence = WatchdogAction::Hold;
  bool is_plate_written =
      false;  ///< whether the PLC has written its plate register since the link was started
  bool is_part_removed = false;
  bool is_guard_closed = false;
};

/// Settings of the watch of the PLC.
struct PlcWatchSettings {
  bool is_required = false;  ///< the unit runs only with a PLC, whose interlocks it needs
  bool unsuspends = true;  ///< whether the unit continues by itself when the PLC's reason to suspend is gone
  /// Time for which a link or PLC that is expected may be silent while the unit runs.
  double patience_s = 10.0;
  /// Whether the PLC's reasons to suspend also count in the states on the way to Execute, where they hold the
  /// unit.
  bool holds_on_the_way = false;
};

/// An alarm that the report of the PLC raises.
struct PlcAlarm {
  int id = 0;
  std::string message;
};

/// What the unit is to do because of the PLC.
struct PlcDemands {
  std::vector<PlcAlarm> raised;        ///< new alarms
  std::vector<int> ended;              ///< IDs of alarms whose cause is gone
  std::optional<UnitCommand> command;  ///< Stop or Unsuspend
  bool is_part_removed = false;        ///< the PLC has just reported it, and the unit is at rest
};

/// Judges the reports of the PLC. It acts on changes, not on bits that stay set: a part counts as removed
/// when its bit is set while the heartbeat is not lost and the plate register was written before; an alarm
/// ends when its cause does. A link or PLC that was good and is now silent raises an alarm, even if it is not
/// required, until `disarm` is called. A heartbeat that the first report says is lost, or abandoned, counts
/// as lost just then.
class PlcWatch {
 public:
  explicit PlcWatch(const PlcWatchSettings& settings) : settings_(settings) {}

  /// Evaluates a report of the link.
  void hear(const PlcReport& report, double now_s);

  /// States that remote access was locked. A silent PLC then raises no alarm unless it is required.
  void disarm() { is_armed_ = false; }

  /// The interlocks for the guards. The PLC is neither alive nor beating if the link has been silent for more
  /// than two seconds. Such a PLC counts as silent if its heartbeat was good since `disarm` or the link
  /// reports it lost.
  PlcInterlocks interlocks(double now_s) const;

  /// What has become necessary since the last call; each demand is returned once. To be called as often as
  /// the unit's `tick`.
  PlcDemands demands(const UnitStatus& unit, double now_s);

 private:
  void hearSilence(const PlcReport& report, PlcHeartbeat before);
  std::vector<PlcAlarm> causes(const UnitStatus& unit, double now_s);
  std::optional<std::string> silence(const UnitStatus& unit, double now_s);
  std::optional<UnitCommand> ordered(const UnitStatus& unit);

  PlcWatchSettings settings_;
  std::optional<PlcReport> report_;
  double heard_s_ = 0.0;
  std::optional<double> missing_since_s_;  ///< since when an expected PLC or link is silent
  bool is_armed_ = false;                  ///< whether its heartbeat was good
  std::set<int> raised_;
  bool is_removal_new_ = false;
  bool is_guard_opened_ = false;
  bool is_stop_due_ = false;       ///< by `WatchdogAction::Stop`
  bool is_abandoned_ = false;      ///< and the unit has not yet been stopped for that
  std::uint32_t unsuspended_ = 0;  ///< state change for which Unsuspend was last ordered
};

}  // namespace lamina
