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

/// What is heard of the PLC's heartbeat.
enum class PlcHeartbeat : std::uint8_t {
  Unarmed,  ///< it has not called
  Good,
  Lost,
  Abandoned,  ///< lost for so long that a held unit is stopped
};

/// What the PLC's silence leads to.
enum class WatchdogAction : std::uint8_t { None, Hold, Stop };

/// What the link says of the PLC. `interlocks.is_alive` is true where the heartbeat is good.
struct PlcReport {
  PlcInterlocks interlocks;
  PlcHeartbeat heartbeat = PlcHeartbeat::Unarmed;
  WatchdogAction on_silence = WatchdogAction::Hold;
  bool is_plate_written = false;  ///< the PLC has written its plate register since the link was started
  bool is_part_removed = false;
  bool is_guard_closed = false;
};

struct PlcWatchSettings {
  bool is_required = false;  ///< the unit runs only beside a PLC, whose interlocks it needs
  bool unsuspends = true;    ///< what the PLC has suspended goes on when the PLC's reason is gone
  double patience_s = 10.0;  ///< for a link or PLC that is required and silent, while the unit runs
  bool holds_on_the_way =
      false;  ///< its reasons to suspend also count on the way to Execute, where they hold
};

/// An alarm that the PLC's words raise.
struct PlcAlarm {
  int id = 0;
  std::string message;
};

/// What the unit is to do, by what the PLC says.
struct PlcDemands {
  std::vector<PlcAlarm> raised;
  std::vector<int> ended;
  std::optional<UnitCommand> command;  ///< Stop or Unsuspend
  bool is_part_removed = false;        ///< the PLC has just said so, and the unit is at rest
};

/// Judges what the PLC says. Nothing follows from a bit that merely stays set: a part counts as removed when
/// its bit comes while the heartbeat is not lost, and an alarm ends when its cause does. A link or PLC that
/// was good and says nothing any more is silent, whether it is required or not, until `disarm`.
class PlcWatch {
 public:
  explicit PlcWatch(const PlcWatchSettings& settings) : settings_(settings) {}

  void hear(const PlcReport& report, double now_s);

  /// Remote access was locked: nobody is expected to speak.
  void disarm() { is_armed_ = false; }

  /// For the guards: not alive where the link has been silent for two seconds.
  PlcInterlocks interlocks(double now_s) const;

  /// What follows just now; each is reported once. Call it as often as the unit's tick.
  PlcDemands demands(const UnitStatus& unit, double now_s);

 private:
  std::vector<PlcAlarm> causes(const UnitStatus& unit, double now_s);
  std::optional<std::string> silence(const UnitStatus& unit, double now_s);
  std::optional<UnitCommand> ordered(const UnitStatus& unit);

  PlcWatchSettings settings_;
  std::optional<PlcReport> report_;
  double heard_s_ = 0.0;
  std::optional<double> missing_since_s_;  ///< a PLC that is expected
  bool is_armed_ = false;                  ///< its heartbeat was good
  std::set<int> raised_;
  bool is_removal_new_ = false;
  bool is_guard_opened_ = false;
  bool is_stop_due_ = false;
  std::uint32_t unsuspended_ = 0;  ///< the state change that Unsuspend was last ordered at
};

}  // namespace lamina
