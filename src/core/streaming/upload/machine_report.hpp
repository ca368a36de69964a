// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// State of the print on a machine.
enum class PrintState : std::uint8_t {
  None,  ///< there is no print
  Printing,
  Changing,  ///< it pauses, resumes or cancels
  Paused,
  Complete,  ///< the last print ran to its end
  Stopped,   ///< a user ended the last print
  Failed,    ///< an error ended the last print
};

/// The report of a machine, from one answer or several.
struct MachineReport {
  bool is_ready = false;
  bool is_halted = false;  ///< whether the machine has shut down itself and its heaters
  std::string condition;   ///< in the machine's own words, if it is not ready or the print has failed
  PrintState state = PrintState::None;
  std::string file;                         ///< name below the folder of programs; empty without a print
  std::optional<std::uint64_t> bytes_read;  ///< number of bytes of the file that were read, if reported
  bool is_moving = false;                   ///< whether motions are in progress
  /// Number of stalls for want of motions since the machine's start; nothing if not reported.
  std::optional<std::uint64_t> stalls;
  bool has_targets = false;  ///< whether a heater has a target, or may have one
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;
  /// First value left out as implausible, and what was expected; empty if none was.
  std::string doubt = {};

  bool isPrintUnderWay() const {
    return state == PrintState::Printing || state == PrintState::Changing || state == PrintState::Paused;
  }
};

}  // namespace lamina
