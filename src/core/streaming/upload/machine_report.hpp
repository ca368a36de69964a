// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// How the print that a machine knows of stands.
enum class PrintState : std::uint8_t {
  None,  ///< it knows of none
  Printing,
  Changing,  ///< it pauses, resumes or cancels
  Paused,
  Complete,  ///< the last one ran to its end
  Stopped,   ///< the last one was ended by somebody
  Failed,    ///< the last one was ended by an error
};

/// What a machine says of itself in one answer or several.
struct MachineReport {
  bool is_ready = false;
  bool is_halted = false;  ///< has shut itself down, its heaters with it
  std::string condition;   ///< in its own words, if it is not ready or the print has failed
  PrintState state = PrintState::None;
  std::string file;              ///< below the folder of programs; empty without a print
  std::uint64_t bytes_read = 0;  ///< of that file
  bool is_moving = false;        ///< motions are under way
  std::optional<std::uint64_t>
      stalls;                ///< since it was started, for want of motions; nothing if it does not say
  bool has_targets = false;  ///< a heater has a target, or it is not known that none has
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;

  bool isPrintUnderWay() const {
    return state == PrintState::Printing || state == PrintState::Changing || state == PrintState::Paused;
  }
};

}  // namespace lamina
