// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// State of a job on a machine, by the names of PackML (ISA-TR88). The values are those of
/// msg/MachineState.msg, not those of the standard; a test compares them. `cell/packml_model.hpp` has the
/// states of the whole cell, with the values of the standard.
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

/// The name of a state as in PackML, such as "Execute".
const char* toString(PackmlState state);

/// Whether PackML's state model has a transition from one state to the other: an acting state (Holding) ends
/// in the waiting state of its name (Held), Stopping can be entered from every state but those that stop,
/// abort or clear, and Aborting from every state but itself and Aborted.
bool isLegalTransition(PackmlState from, PackmlState to);

/// Whether the job is over: Complete, Stopped or Aborted.
bool isFinal(PackmlState state);

}  // namespace lamina
