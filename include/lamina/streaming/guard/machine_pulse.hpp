// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {

/// The value of `MachinePulse::firmware` for a process that sends no program to firmware, but trajectories to
/// a controller, through its action of this name.
inline constexpr char kFollowsTrajectories[] = "follow_joint_trajectory";

/// The state of a process that moves a machine. The process sends it periodically (its pulse), so that
/// another process can stop the machine on its behalf if it is lost.
struct MachinePulse {
  /// Whether the process has moved or switched on anything that it still has to stop.
  bool is_at_work = false;
  MachinePort port;  ///< port of the machine; its name may be that of the controller's action
  /// Name of the protocol, `auto` until it is known; or `kFollowsTrajectories`.
  std::string firmware = kAnyFirmware;
  std::string program;            ///< path of the program of the running job; empty for none
  bool keeps_heaters_on = false;  ///< whether heaters are left on at a safe stop
  bool has_job = false;           ///< whether it runs a job, not merely a step of a start-up sequence
};

/// Greatest length of a pulse as text [byte].
inline constexpr std::size_t kLongestPulse = 8192;

/// A pulse as text, in which it is sent. Line feeds within names become spaces.
std::string toText(const MachinePulse& pulse);

/// The pulse that was written as text; nothing if the text is no pulse, or of another version.
std::optional<MachinePulse> pulseIn(std::string_view text);

/// Name of the protocol that firmware of this name speaks; `auto` if several or none match.
std::string protocolOfFirmware(const std::string& firmware_name);

}  // namespace lamina
