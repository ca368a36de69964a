// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace lamina {

/// The nozzle waits where it stands.
struct Dwell {
  double duration_s = 0.0;
};

/// The fan that cools the part runs at that share of its power from then on.
struct FanShare {
  double share = 0.0;  ///< 0 is off, 1 the greatest
};

/// The machine waits until somebody lets it go on.
struct OperatorPause {
  std::string message;  ///< for who stands there; one line, may be empty
};

/// Lines in the machine's own language, which are passed on as they are.
struct MachineCode {
  std::string text;         ///< lines ended by line feeds, but for the last
  bool moves_axes = false;  ///< position, modes and feed are unknown after it
};

/// What happens between two motions, or holds from there on.
using ToolpathEvent = std::variant<Dwell, FanShare, OperatorPause, MachineCode>;

/// An event of a path.
struct PathEvent {
  std::size_t motion = 0;  ///< that it comes before (`Path::motionEnd`); the count of motions for after all
  ToolpathEvent event;
};

/// As named in files and messages: "dwell", "fan", "pause", "code".
const char* nameOf(const ToolpathEvent& event);

/// Waiting of the events that come before a motion [s].
double dwellBefore(const std::vector<PathEvent>& events, std::size_t motion);

/// Why an event cannot be: a duration that is negative, a share outside 0 to 1, a message of several lines.
/// Empty if it can.
std::string defectOf(const ToolpathEvent& event);

}  // namespace lamina
