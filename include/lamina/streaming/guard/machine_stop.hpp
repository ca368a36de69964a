// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/streaming/guard/machine_pulse.hpp"

namespace lamina {

/// What became of a machine that was stopped in the place of its streamer.
struct MachineStopReport {
  bool is_confirmed = false;  ///< the machine itself has reported that it is at rest and heats nothing
  std::string message;
  bool has_begun = false;  ///< its first bytes have left: what the machine was to do is lost
};

/// What is sent at once, without numbers, so that also firmware that waits for heat stops as soon as it reads
/// on: beam off, heaters off, with the end of motions where the firmware has one.
/// @param machine  by its firmware, of which any that is not known stands for Marlin's kin, and whether it
/// keeps its heat
std::string urgentStopOf(const MachinePulse& machine);

/// Stops a machine whose streamer is gone: sends `urgentStopOf`, then has the machine confirm, line by line,
/// that all that the program has used is off. grbl is slowed down and reset. Returns after some seconds, or
/// as soon as the port cannot be had.
/// @param begun  called once the first bytes have left; may be empty
MachineStopReport stopMachine(const MachinePulse& machine, const std::function<void()>& begun);

}  // namespace lamina
