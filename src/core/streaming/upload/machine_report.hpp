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
  None,  ///< there is none
  Printing,
  Changing,  ///< it pauses, resumes or cancels
  Paused,
  Complete,  ///< the last one ran to its end
  Stopped,   ///< the last one was ended by a user
  Failed,    ///< the last one was ended by an error
};

/// The report of a machine, from one answer or several.
struct MachineReport {
  bool is_ready = false;
  bool is_halted = false;  ///< has shut itself and its heaters down
  std::string condition;   ///< in its own words, if it is not ready or the print has failed
  PrintState state = PrintState::None;
  std::string file;              ///< below the folder of programs; empty without a print
  std::uint64_t bytes_read = 0;  ///< of that file
  bool is_moving = false;        ///< motions are under way
  /// Stalls for want of motions since its start; none if it does not report them.
  std::optional<std::uint64_t> stalls;
  bool has_targets = false;  ///< a heater has a target, or may have one
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;

  bool isPrintUnderWay() const {
    return state == PrintState::Printing || state == PrintState::Changing || state == PrintState::Paused;
  }
};

}  // namespace lamina
