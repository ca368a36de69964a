// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Firmware that speaks grbl's protocol. All agree on the first 38 error codes and the first nine alarms.
enum class GrblDialect : std::uint8_t {
  Grbl,     ///< 1.1, on eight-bit boards
  GrblHal,  ///< on many boards
  FluidNc,  ///< on the ESP32
};

/// State of the machine, as grbl reports it.
enum class GrblState : std::uint8_t {
  Idle,
  Run,
  Hold,  ///< substate 0: at rest, 1: still slowing down
  Jog,
  Home,
  Alarm,  ///< the machine is locked
  Check,  ///< lines are checked, but nothing moves
  Door,   ///< substate 0: closed, at rest, 1: open, at rest, 2: retracting, 3: returning to the part
  Sleep,
  Tool,   ///< the machine waits for a change of tool (grblHAL)
  Other,  ///< any other state, such as FluidNC's Starting
};

/// Coordinates X, Y and Z in the unit of the machine's reports, mm or inch (setting $13).
using GrblAxes = std::array<double, 3>;

/// Overrides of the speeds in a program [%].
struct GrblPercents {
  int feed = 100;
  int rapid = 100;
  int spindle = 100;  ///< speed of the spindle, or power of a laser
};

/// The answer of grbl to '?'. It omits values that have not changed, and values that the configuration of the
/// machine excludes.
struct GrblReport {
  GrblState state = GrblState::Other;
  std::optional<int> substate;
  std::string state_text;  ///< the state as the machine wrote it, such as "Hold:0"
  std::optional<GrblAxes> machine_position;
  std::optional<GrblAxes> work_position;
  std::optional<GrblAxes> work_offset;
  std::optional<int> free_blocks;  ///< free places of the motion queue
  std::optional<int> free_bytes;   ///< free bytes of the receive buffer
  std::optional<GrblPercents> overrides;
  std::optional<double> spindle_speed;  ///< [rpm], or power of a laser
};

/// Kind of a line that the firmware sends.
enum class GrblReplyKind : std::uint8_t {
  Ok,        ///< a line was accepted
  Error,     ///< a line was refused, with a code
  Alarm,     ///< the machine has locked itself, with a code
  Greeting,  ///< the firmware has restarted, and has lost its state
  Report,    ///< answer to '?'
  Version,   ///< answer to `$I`: "[VER:...]"
  Options,   ///< answer to `$I`: "[OPT:...]"
  Modes,     ///< answer to `$G`
  Setting,   ///< a line of the answer to `$$`, such as "$13=0"
  Message,   ///< "[MSG:...]"
  Other,
};

/// A line that the firmware sends, parsed.
struct GrblReply {
  GrblReplyKind kind = GrblReplyKind::Other;
  int code = 0;                      ///< of an Error or Alarm
  std::optional<GrblReport> report;  ///< of a Report
  std::string text;                  ///< the line, without blanks at its ends
};

/// Parses a line of the firmware; an unknown one is Other. A greeting is found anywhere in the line, since
/// stray bytes may precede it after a reset.
GrblReply parseGrblReply(std::string_view line);

/// The meaning of an error code in words; for an unknown code, where to look it up.
std::string meaningOfGrblError(int code, GrblDialect dialect);

/// The meaning of an alarm code in words; for an unknown code, where to look it up.
std::string meaningOfGrblAlarm(int code, GrblDialect dialect);

// Real-time commands: single bytes that grbl obeys on arrival, before the lines in its receive buffer, and
// that need no space in it.
namespace grbl_byte {

inline constexpr char kStatus = '?';
inline constexpr char kFeedHold = '!';
inline constexpr char kCycleStart = '~';
inline constexpr char kReset = '\x18';

}  // namespace grbl_byte

/// The real-time bytes that change the feed override from one value to another, in steps of 10 % and 1 %.
/// @param from_percent  override that the machine reports now, 10 to 200
/// @param to_percent  target, clamped to 10 to 200
/// @return empty if both are equal
std::string grblFeedOverride(int from_percent, int to_percent);
/// The real-time bytes that change the override of the spindle; parameters as for `grblFeedOverride`.
std::string grblSpindleOverride(int from_percent, int to_percent);

/// The real-time byte that sets the override of rapid motions to 25, 50 or 100 %: the least of these that is
/// not below the target.
std::string grblRapidOverride(int to_percent);

}  // namespace lamina
