// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/unit_machine.hpp"

namespace lamina {

/// What the PLC says of the surroundings, as it stands in its registers.
struct PlcInterlocks {
  bool is_alive = false;  ///< its heartbeat came in time
  bool has_material = false;
  bool has_gas = false;
  bool has_cooling = false;
  bool has_vacuum = false;
  bool is_plate_there = false;
  bool is_plate_clamped = false;
  bool is_zone_taken = false;
  bool is_blocked = false;  ///< parts cannot be taken away
  bool is_emergency_stop_pressed = false;
};

/// Whether a unit runs only beside a PLC.
enum class PlcNeed : std::uint8_t { None, Required };

/// What a PLC says against running, in the order of its codes. Where it is required, what it does not give is
/// missing, and all of it is if its heartbeat does not come. Where it is not, only what it forbids counts,
/// while its heartbeat comes.
std::vector<UnmetGuard> againstPlc(const PlcInterlocks& plc, PlcNeed need);

/// What has to be true before the unit starts, as found just now.
struct StartConditions {
  int mode = kProduction;
  std::string machine;               ///< of the cell; jobs are checked for one machine
  std::string job;                   ///< next in the queue; empty if none may start
  std::vector<std::string> torn;     ///< files of the job that no longer have their hashes
  std::vector<std::string> unready;  ///< steps of the start-up that are not satisfied, each with its reason
  bool runs_startup = false;         ///< Starting runs the start-up itself
  bool is_checked = false;           ///< the program was checked for this machine
  bool is_part_removed = true;       ///< the last one
  PlcNeed plc_need = PlcNeed::None;
  PlcInterlocks plc;
  std::optional<double> clock_offset_s;  ///< to the host of the sensor; nothing if there is one host
  bool needs_clouds = false;             ///< the job measures layers
  std::string loop_blocked;          ///< why the loop may not run though the job wants it; empty if it may
  std::optional<double> free_bytes;  ///< of the journal's disk; nothing if the system does not say
  std::string journal_error;         ///< why it cannot be written; empty if it can
};

/// All that stands against Start, in the order of its codes; empty if nothing does. Alarms are looked at by
/// the unit itself.
std::vector<UnmetGuard> againstStart(const StartConditions& found);

/// What has to be true before a held or suspended unit goes on.
struct ContinueConditions {
  bool is_position_known = false;
  std::vector<std::string> out_of_band;  ///< temperatures, each with value and band
  PlcNeed plc_need = PlcNeed::None;
  PlcInterlocks plc;
  bool has_master = true;  ///< the ROS master answers
};

/// All that stands against Unhold and Unsuspend, in the order of its codes.
std::vector<UnmetGuard> againstContinuing(const ContinueConditions& found);

}  // namespace lamina
