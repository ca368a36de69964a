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

/// Firmware that speaks as grbl does. They agree on the first 38 error codes and the first nine alarms.
enum class GrblDialect : std::uint8_t {
  Grbl,     ///< 1.1, on eight-bit boards
  GrblHal,  ///< on many boards
  FluidNc,  ///< on the ESP32
};

enum class GrblState : std::uint8_t {
  Idle,
  Run,
  Hold,  ///< substate 0: at rest, 1: still slowing down
  Jog,
  Home,
  Alarm,  ///< locked
  Check,  ///< lines are read and nothing is moved
  Door,   ///< substate 0: closed, at rest, 1: open, at rest, 2: retracting, 3: going back
  Sleep,
  Tool,   ///< waits for a tool to be changed (grblHAL)
  Other,  ///< none of these, such as FluidNC's Starting
};

/// X, Y and Z, in the unit of the machine's reports.
using GrblAxes = std::array<double, 3>;

/// Overrides of the speeds in a program [%].
struct GrblPercents {
  int feed = 100;
  int rapid = 100;
  int spindle = 100;  ///< power of a laser
};

/// The answer of grbl to '?'. It lacks values that have not changed, and those excluded by its configuration.
struct GrblReport {
  GrblState state = GrblState::Other;
  std::optional<int> substate;
  std::string state_text;  ///< as the machine wrote it: "Hold:0"
  std::optional<GrblAxes> machine_position;
  std::optional<GrblAxes> work_position;
  std::optional<GrblAxes> work_offset;
  std::optional<int> free_blocks;  ///< of the motion queue
  std::optional<int> free_bytes;   ///< of the receive buffer
  std::optional<GrblPercents> overrides;
  std::optional<double> spindle_speed;  ///< [rpm], or power of a laser
};

enum class GrblReplyKind : std::uint8_t {
  Ok,        ///< a line was taken
  Error,     ///< a line was refused, with a code
  Alarm,     ///< the machine has locked itself, with a code
  Greeting,  ///< the firmware has started, and has forgotten everything
  Report,    ///< to '?'
  Version,   ///< to `$I`
  Options,   ///< to `$I`
  Modes,     ///< to `$G`
  Setting,   ///< to `$$`: "$13=0"
  Message,   ///< "[MSG:...]"
  Other,
};

struct GrblReply {
  GrblReplyKind kind = GrblReplyKind::Other;
  int code = 0;  ///< of an error or alarm
  std::optional<GrblReport> report;
  std::string text;  ///< the line, without blanks at its ends
};

/// Parses a line of the firmware. Any line is accepted; an unknown one is Other. A greeting is found anywhere
/// in the line, since a reset puts stray bytes on the link.
GrblReply parseGrblReply(std::string_view line);

/// The meaning of an error code in words; for an unknown code, where to look it up.
std::string meaningOfGrblError(int code, GrblDialect dialect);

/// The meaning of an alarm code in words; for an unknown code, where to look it up.
std::string meaningOfGrblAlarm(int code, GrblDialect dialect);

/// Real-time bytes: grbl obeys them on arrival, whatever is in its buffer, and they take no room in it.
namespace grbl_byte {

inline constexpr char kStatus = '?';
inline constexpr char kFeedHold = '!';
inline constexpr char kCycleStart = '~';
inline constexpr char kReset = '\x18';

}  // namespace grbl_byte

/// The bytes that change an override of grbl by at most 10 % each.
/// @param from_percent  what the machine reports now, 10 to 200
/// @param to_percent  target, clamped to 10 to 200
/// @return empty if both are the same
std::string grblFeedOverride(int from_percent, int to_percent);
std::string grblSpindleOverride(int from_percent, int to_percent);

/// The byte that sets the override of rapid motions to 25, 50 or 100 %: the next of these above the target.
std::string grblRapidOverride(int to_percent);

}  // namespace lamina
