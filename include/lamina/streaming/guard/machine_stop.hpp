// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/streaming/guard/machine_pulse.hpp"

namespace lamina {

/// Result of stopping a machine on behalf of its lost streamer.
struct MachineStopReport {
  bool is_confirmed = false;  ///< whether the machine has reported that it is at rest and its heaters are off
  std::string message;
  bool has_begun = false;  ///< whether the first bytes of the stop were sent; the job is then lost
};

/// The bytes that are sent first, without line numbers and without waiting for answers: beam off, heaters
/// off, and the end of all motions if the firmware has a command for it; a feed hold for grbl. Firmware that
/// waits for a temperature also stops as soon as it reads the bytes. The program is not read.
/// @param machine  with unknown firmware it is treated as Marlin
std::string urgentStopOf(const MachinePulse& machine);

/// Stops a machine whose streamer is lost: sends `urgentStopOf`, then the commands that switch off all that
/// the program has used, each of which the machine has to confirm. grbl gets a feed hold and a reset instead.
/// Returns after some seconds, or at once if the port cannot be opened.
/// @param begun  called when the first bytes have been sent; may be empty
MachineStopReport stopMachine(const MachinePulse& machine, const std::function<void()>& begun);

}  // namespace lamina
