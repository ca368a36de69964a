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

/// What is deposited from then on is of that part of a plate. Asks nothing of the machine.
struct PartMark {
  std::string name;  ///< one line; empty for what is of no part
};

/// What happens between two motions, or holds from there on.
using ToolpathEvent = std::variant<Dwell, FanShare, OperatorPause, MachineCode, PartMark>;

/// An event of a path.
struct PathEvent {
  std::size_t motion = 0;  ///< that it comes before (`Path::motionEnd`); the count of motions for after all
  ToolpathEvent event;
};

/// As named in files and messages: "dwell", "fan", "pause", "code", "part".
const char* nameOf(const ToolpathEvent& event);

/// Events of one motion, in their order.
class EventRange {
 public:
  using Iterator = std::vector<PathEvent>::const_iterator;
  EventRange(Iterator begin, Iterator end) : begin_(begin), end_(end) {}
  Iterator begin() const { return begin_; }
  Iterator end() const { return end_; }

 private:
  Iterator begin_;
  Iterator end_;
};

/// The events that come before a motion. Logarithmic in their number.
/// @param events  in the order of their motions; they must outlive the range
EventRange eventsBefore(const std::vector<PathEvent>& events, std::size_t motion);

/// Waiting of the events that come before a motion [s].
double dwellBefore(const std::vector<PathEvent>& events, std::size_t motion);

/// Why an event cannot be: a duration that is negative, a share outside 0 to 1, a message or name of several
/// lines. Empty if it can.
std::string defectOf(const ToolpathEvent& event);

}  // namespace lamina
