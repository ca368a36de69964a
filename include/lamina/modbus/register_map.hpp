// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lamina/cell/active_alarms.hpp"
#include "lamina/cell/packml_model.hpp"
#include "lamina/cell/unit_machine.hpp"

namespace lamina {

// The registers of the PLC link, version 1: docs/cell/plc.md lists them for PLC programmers. Addresses are
// those of the protocol, from 0.

/// Which word of a 32-bit value is in the lower register.
enum class WordOrder : std::uint8_t { HighFirst, LowFirst };

constexpr std::uint16_t kRegisterMapVersion = 1;
constexpr std::size_t kInputRegisters = 132;
constexpr std::size_t kHoldingRegisters = 36;

using InputRegisters = std::array<std::uint16_t, kInputRegisters>;
using HoldingRegisters = std::array<std::uint16_t, kHoldingRegisters>;

/// Flags of input register 3; the value is the number of the bit.
enum class StatusFlag : std::uint8_t {
  WatchdogGood,
  RemoteAllowed,
  CommandRefused,
  ModeChanging,
  StateChanging,
  Alarm,
  Warning,
  JobLoaded,
  HeatersOn,
  Motion,
  BeamOn,
  PartOnPlate,
  StartupDone,
  LoopActive,
  LoopCoasting,
  ResumeWaits,
};

/// The job as shown to the PLC.
struct JobStatus {
  std::uint32_t id = 0;  ///< 0 for none
  std::uint16_t state =
      0;  ///< of ISA-95 (OPC 10031-4): 1 not allowed to start ... 6 aborted; 0 without a job
  std::uint16_t queued = 0;
  std::uint32_t next = 0;   ///< job that Start would begin; 0 for none
  std::int32_t layer = -1;  ///< -1 before the first
  std::int32_t layers = 0;
  float fraction = 0.0F;
  std::uint32_t gone_s = 0;  ///< time since the job began
  /// Estimated; the greatest value stands for not known.
  std::uint32_t left_s = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t line = 0;
  float path_mm = 0.0F;
  std::string name;  ///< only the first 64 bytes are shown, in whole characters
};

/// Figures of the process as shown to the PLC; 0 where they are not measured.
struct ProcessFigures {
  float nozzle_c = 0.0F;
  float bed_c = 0.0F;
  float flow_mm3_s = 0.0F;
  float tip_speed_mm_s = 0.0F;
  float laser_w = 0.0F;
  float wire_mm_s = 0.0F;
  float mean_error_mm = 0.0F;  ///< of the layer measured last, as are those below
  float rmse_mm = 0.0F;
  float coverage = 0.0F;
  float mean_correction = 0.0F;
};

/// Contents of the input registers, except for those that the link itself adds (`LinkFigures`).
struct PlcStatus {
  std::vector<StatusFlag> flags;  ///< flags that are set, without the flags that the link sets itself
  int mode = kProduction;
  int mode_requested = kProduction;
  UnitState state = UnitState::Aborted;  ///< Aborted, which allows least, until the unit reports its state
  UnitState state_requested = UnitState::Aborted;
  std::uint16_t stop_reason = 0;  ///< number of the alarm; 0 for none
  std::int32_t stop_value = 0;
  std::vector<ActiveAlarm> alarms;
  JobStatus job;
  ProcessFigures process;
  UnitCounters counters;
  double in_state_s = 0.0;
  double in_mode_s = 0.0;
  double utc_s = 0.0;
  bool is_clock_synchronised = false;
};

/// Contents of the input registers that the link itself adds.
struct LinkFigures {
  std::uint16_t heartbeat = 0;
  std::uint16_t plc_heartbeat = 0;
  std::uint16_t last_command = 0;
  std::uint16_t answered_sequence = 0;
  std::uint16_t result = 0;  ///< a `CommandResult`; 0 before the first command
};

/// All input registers; those that the map does not use are 0.
InputRegisters inputRegisters(const PlcStatus& status, const LinkFigures& link, WordOrder order);

/// Contents of the holding registers: what the PLC has written.
struct PlcInputs {
  std::uint16_t heartbeat = 0;
  std::uint16_t command = 0;
  std::uint16_t command_sequence = 0;
  std::uint16_t mode = 0;
  std::uint16_t mode_sequence = 0;
  std::uint32_t job = 0;
  std::uint16_t job_sequence = 0;
  bool has_material = false;
  bool has_gas = false;
  bool has_cooling = false;
  bool has_vacuum = false;
  bool is_blocked = false;
  bool is_starved = false;
  bool is_guard_closed = false;  ///< for information only, as are those below; never used for protection
  bool is_guard_reset = false;
  bool is_emergency_stop_pressed = false;
  bool is_plate_there = false;
  bool is_plate_clamped = false;
  bool is_part_removed = false;
  bool is_zone_taken = false;
  double speed = 1.0;  ///< override; 1 if the PLC has written nothing
  std::uint16_t acknowledged_alarm = 0;
  std::string badge;
};

/// Reads the contents of the holding registers.
PlcInputs plcInputs(const HoldingRegisters& registers, WordOrder order);

/// Whether all holding registers have valid values: the speed override is 0 (none) or 0.5 to 1.2.
bool areInRange(const HoldingRegisters& registers, WordOrder order);

/// Whether a PLC may write the holding register: 0 to 14 and 20 to 35.
bool isWritable(std::size_t address);

}  // namespace lamina
