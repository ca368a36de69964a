// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace lamina {

/// A wait during which the nozzle stands still.
struct Dwell {
  double duration_s = 0.0;
};

/// The power of the part cooling fan from this event on.
struct FanShare {
  double share = 0.0;  ///< share of the full power: 0 is off, 1 is full
};

/// A wait until the operator lets the machine continue.
struct OperatorPause {
  std::string message;  ///< message for the operator; one line, may be empty
};

/// Lines of code in the language of the machine, passed on unchanged.
struct MachineCode {
  std::string text;         ///< lines separated by line feeds
  bool moves_axes = false;  ///< whether position, modes and feed are unknown afterwards
};

/// A mark that names the part of a plate to which the material deposited from this event on belongs. It has
/// no effect on the machine.
struct PartMark {
  std::string name;  ///< one line; empty for material of no part
};

/// An event between two motions, or a setting that holds from there on.
using ToolpathEvent = std::variant<Dwell, FanShare, OperatorPause, MachineCode, PartMark>;

/// An event of a path.
struct PathEvent {
  std::size_t motion = 0;  ///< index of the motion that follows it; the number of motions if none does
  ToolpathEvent event;
};

/// The name of an event in files and messages: "dwell", "fan", "pause", "code", "part".
const char* nameOf(const ToolpathEvent& event);

/// A range of consecutive events of a path.
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

/// The events between a motion and the previous one. Takes time logarithmic in the number of events.
/// @param events  in the order of their motions; they must outlive the range
EventRange eventsBefore(const std::vector<PathEvent>& events, std::size_t motion);

/// Total duration of the dwells between a motion and the previous one [s].
double dwellBefore(const std::vector<PathEvent>& events, std::size_t motion);

/// The reason why an event is invalid: a negative duration, a share outside of [0, 1], a message or name of
/// several lines. Empty if it is valid.
std::string defectOf(const ToolpathEvent& event);

}  // namespace lamina
