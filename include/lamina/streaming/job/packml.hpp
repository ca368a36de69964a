// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// State of a job on a machine, in the names of PackML (ISA-TR88). The numbers are those of
/// msg/MachineState.msg; a test compares them. The unit as a whole has the standard's numbers
/// (`cell/packml_model.hpp`).
enum class PackmlState : std::uint8_t {
  Idle = 0,
  Starting = 1,
  Execute = 2,
  Holding = 3,
  Held = 4,
  Unholding = 5,
  Suspending = 6,
  Suspended = 7,
  Completing = 8,
  Complete = 9,
  Stopping = 10,
  Stopped = 11,
  Aborting = 12,
  Aborted = 13,
  Clearing = 14,
  Resetting = 15,
  Unsuspending = 16,
};

/// The state as a cell controller writes it: "Execute".
const char* toString(PackmlState state);

/// True if PackML's state model has an arrow from one state to the other: the acting states end in the
/// waiting state of their name, Stopping can be entered from every state but those that stop, abort or clear,
/// and Aborting from every state but itself and Aborted.
bool isLegalTransition(PackmlState from, PackmlState to);

/// Complete, Stopped or Aborted: the job is over.
bool isFinal(PackmlState state);

}  // namespace lamina
