// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {

/// In the place of a firmware: the process hands trajectories to a controller that follows them, as an
/// action.
inline constexpr char kFollowsTrajectories[] = "follow_joint_trajectory";

/// What a process that moves a machine says of itself again and again, so that another can stop the machine
/// in its place.
struct MachinePulse {
  bool is_at_work = false;  ///< it has switched on or moved what it will switch off or stop itself
  MachinePort port;         ///< or the full name of the controller's action, without a baud rate
  /// Name of the protocol, `auto` until it is known; or `kFollowsTrajectories`.
  std::string firmware = kAnyFirmware;
  std::string program;            ///< file of the job under way; empty for none
  bool keeps_heaters_on = false;  ///< at a safe stop
  bool has_job = false;           ///< it is at work on a job, and not on a step of a start-up alone
};

/// The longest text of a pulse [byte].
inline constexpr std::size_t kLongestPulse = 8192;

/// A pulse as it is sent. Ends of lines within names become spaces.
std::string toText(const MachinePulse& pulse);

/// The pulse in a text; nothing for a text that is none, or is of another version.
std::optional<MachinePulse> pulseIn(std::string_view text);

/// Name of the one protocol that firmware of this name speaks; `auto` if there are several or none.
std::string protocolOfFirmware(const std::string& firmware_name);

}  // namespace lamina
