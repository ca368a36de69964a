// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/machine_sheet.hpp"
#include "lamina/cell/unit_machine.hpp"

namespace lamina {

/// State of the unit's surroundings as the PLC reports it in its registers.
struct PlcInterlocks {
  bool is_alive = false;  ///< whether its watchdog is armed, and its heartbeat came in time
  bool has_material = false;
  bool has_gas = false;
  bool has_cooling = false;
  bool has_vacuum = false;
  bool is_plate_there = false;
  bool is_plate_clamped = false;
  bool is_zone_taken = false;  ///< whether another robot is in the zone
  bool is_blocked = false;     ///< whether parts cannot be taken away
  bool is_emergency_stop_pressed = false;
  bool is_silent = false;  ///< whether it was heard before, and its heartbeat does not come
  /// Whether its heartbeat came in time, armed or not: it is not armed while remote access is locked.
  bool is_beating = false;
};

/// Whether a unit runs only together with a PLC.
enum class PlcNeed : std::uint8_t { None, Required };

/// Whether the word of a PLC counts: its heartbeat comes. Where it is required its watchdog has to be armed.
bool isHeard(const PlcInterlocks& plc, PlcNeed need);

/// Unmet guards of the PLC's interlocks, in the order of their codes. Prohibitions (occupied zone, parts that
/// cannot be taken away, emergency stop) count while the PLC is heard. A missing build plate, clamp or
/// supply counts only with `PlcNeed::Required`. Without a heartbeat, `Required` gives the missing heartbeat
/// only. `None` then gives only the zone, which counts as taken if the PLC was heard before.
std::vector<UnmetGuard> againstPlc(const PlcInterlocks& plc, PlcNeed need);

/// Why the zone is not known to be free; empty if it is, or if no PLC is required and none was heard.
std::string whyZoneIsTaken(const PlcInterlocks& plc, PlcNeed need);

/// The present conditions for a start.
struct StartConditions {
  int mode = kProduction;
  BoundMachine machine;  ///< machine of the cell, for which programs have to be checked
  /// Differences between the machine and the one for which the job's program was checked.
  std::vector<std::string> machine_differences;
  std::string job;                   ///< next job in the queue; empty if none is allowed to start
  std::vector<std::string> torn;     ///< files of the job whose hash has changed
  std::vector<std::string> unready;  ///< steps of the start-up that are not satisfied, each with the reason
  bool is_checked = false;           ///< whether the program was checked for this machine
  bool is_part_removed = true;       ///< whether the last part was removed
  PlcNeed plc_need = PlcNeed::None;
  PlcInterlocks plc;
  bool needs_loop = false;  ///< whether jobs run with the height loop, and so with the sensor's clock
  std::string loop_fault;   ///< why the height loop may not run; empty if it may
  std::string clock_fault;  ///< which clocks of the hosts differ, and by how much; empty if none do
  /// Free space on the disk of the journal; nothing if the system does not report it.
  std::optional<double> free_bytes;
};

/// The reasons against Start, in the order of their codes; empty if there are none. Alarms are not among
/// them: the unit checks these itself.
std::vector<UnmetGuard> againstStart(const StartConditions& found);

/// The present conditions for continuing after Held or Suspended.
struct ContinueConditions {
  bool is_position_known = false;
  std::vector<std::string> out_of_band;  ///< temperatures outside their bands, each with value and band
  PlcNeed plc_need = PlcNeed::None;
  PlcInterlocks plc;
  bool has_master = true;  ///< whether the ROS master answers
};

/// The reasons against Unhold and Unsuspend, in the order of their codes. Alarms are not among them, nor is
/// the interlock `is_blocked`.
std::vector<UnmetGuard> againstContinuing(const ContinueConditions& found);

}  // namespace lamina
