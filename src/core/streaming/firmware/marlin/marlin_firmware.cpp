// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lamina/base/characters.hpp"
#include "lamina/base/text.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "program/gcode/command_words.hpp"
#include "streaming/firmware/marlin/marlin_job.hpp"
#include "streaming/job/change_commands.hpp"

namespace lamina {
namespace {

/// Whether a byte comes through: printable ASCII, and beyond it in a message.
bool isTaken(char c, bool is_message) {
  return (c >= ' ' && c <= '~') || (is_message && static_cast<unsigned char>(c) >= 0x80);
}

std::string defectOfLength(std::string_view command, int max_line_bytes) {
  // A line passes wherever it stands in a program of up to ten million lines.
  constexpr std::size_t kFrameBytes = std::string_view("N9999999 *255\n").size();
  constexpr int kUsualLimit = 96;  // MAX_CMD_SIZE
  const int limit = max_line_bytes > 0 ? max_line_bytes : kUsualLimit;
  const std::size_t framed = command.size() + kFrameBytes;
  if (framed <= static_cast<std::size_t>(limit)) return {};
  return "is " + std::to_string(framed) + " bytes with line number and checksum; the machine takes " +
         std::to_string(limit);
}

/// Whether all that follows the code is words of a letter and a number, none of it text.
bool hasWordsOnly(std::string_view command) {
  constexpr std::array<std::string_view, 14> kCommands = {"M3",   "M4",   "M92",  "M104", "M106",
                                                          "M109", "M140", "M141", "M190", "M191",
                                                          "M203", "M204", "M220", "M221"};
  return command[0] == 'G' || isAnyCommand(command, kCommands);
}

bool isNumberAt(std::string_view command, std::size_t at) {
  return at < command.size() &&
         (isDigit(command[at]) || command[at] == '-' || command[at] == '+' || command[at] == '.');
}

/// Whether the E behind a number is its exponent. "G1X1E-3" may be two words without a blank between them,
/// "G1 X1E-3" is hardly.
/// @param word  where the word with the number begins
bool isExponentAt(std::string_view command, std::size_t word, std::size_t at) {
  if (!isDigit(command[at - 1]) && command[at - 1] != '.') return false;
  if (command[at] == 'e') return isNumberAt(command, at + 1);
  if (command[at] != 'E' || word == 0 || !isBlank(command[word - 1])) return false;
  if (command[word] == 'F') return false;  // a retraction behind its feed
  if (at + 1 == command.size() || (command[at + 1] != '-' && command[at + 1] != '+')) return false;
  const std::string_view power = command.substr(at + 2);
  const std::size_t digits = std::min(power.find_first_not_of("0123456789"), power.size());
  return digits > 0 && (digits == power.size() || isBlank(power[digits]));
}

/// Whether a word has a small letter where Marlin looks for a capital: "x5", "x", or "xy" in `G28 xy`.
bool isSmallWordAt(std::string_view command, std::size_t at) {
  constexpr std::string_view kAxes = "XYZE";
  std::size_t end = at;
  bool has_small = false;
  bool is_of_axes = true;
  for (; end < command.size() && isLetter(command[end]); ++end) {
    has_small = has_small || command[end] != upper(command[end]);
    is_of_axes = is_of_axes && kAxes.find(upper(command[end])) != std::string_view::npos;
  }
  if (!has_small) return false;
  const bool is_alone = end == command.size() || isBlank(command[end]);
  return (is_of_axes || end == at + 1) && (is_alone || isNumberAt(command, end));
}

/// Whether a capital stands alone or before a number, as a word does.
bool isWordAt(std::string_view command, std::size_t at) {
  if (command[at] < 'A' || command[at] > 'Z') return false;
  return at + 1 == command.size() || isBlank(command[at + 1]) || isNumberAt(command, at + 1);
}

/// Marlin passes over what it looks for in no line, in silence: `G1 x5 Y2` moves Y alone, of `G21 G90` it
/// runs the first, and `G1 X1E-3` moves X by 1. It answers a line that begins with a small letter with
/// "Unknown command". Comments begin at semicolons alone: of `G0 X100 // G1 Z0` it runs the Z.
std::string defectOfWords(std::string_view command) {
  constexpr std::string_view kCodes = "gmt";
  if (kCodes.find(command[0]) != std::string_view::npos && isNumberAt(command, 1))
    return "begins with a small letter, which Marlin does not know; expected capitals";
  if (!hasWordsOnly(command)) return {};
  const bool may_precede = isCommand(command, "G53");  // the command that it is for
  const std::size_t remark = std::min(command.find_first_of("/#"), command.size());
  const std::size_t end = std::min(command.find('"'), command.size());  // where a text begins
  std::size_t word = 0;
  for (std::size_t at = 1; at < end; ++at) {
    if (!isLetter(command[at]) || isLetter(command[at - 1])) continue;
    if (at > remark) {
      if (isWordAt(command, at))
        return "has a word at '" + std::string(1, command[at]) + "' behind '" +
               std::string(1, command[remark]) + "', which Marlin runs; expected comments behind ';'";
      continue;
    }
    if (isExponentAt(command, word, at)) return "has a number with an exponent; expected a plain decimal";
    word = at;
    if (isSmallWordAt(command, at))
      return "has a word with a small letter at '" + std::string(1, command[at]) +
             "', which Marlin passes over; expected capitals";
    const bool is_code = command[at] == 'G' || command[at] == 'M';
    if (is_code && isNumberAt(command, at + 1) && !may_precede)
      return "has a second command, which Marlin passes over; expected one on each line";
  }
  return {};
}

/// What `M118` makes the machine print: its text behind A1, E1 and P<port>, in any order.
std::string printedBy(std::string_view command) {
  std::string_view text = trimmed(command.substr(4));
  std::string prefix;
  for (int i = 0; i < 3 && text.size() > 1; ++i) {
    const bool is_action = text[0] == 'A' && text[1] == '1';
    const bool is_echo = text[0] == 'E' && text[1] == '1';
    if (!is_action && !is_echo && !(text[0] == 'P' && text[1] >= '0' && text[1] <= '9')) break;
    if (is_action) prefix += "//";
    if (is_echo) prefix = "echo:" + prefix;
    text = trimmed(text.substr(2));
  }
  return prefix + std::string(text);
}

/// Whether a line that the machine prints would be taken for its own: an answer, a reset, a halt.
bool isReadAsAnswer(std::string_view printed) {
  const FirmwareReply reply = parseReply(printed);
  switch (reply.kind) {
    case ReplyKind::Ok:
    case ReplyKind::Resend:
    case ReplyKind::LineError:
    case ReplyKind::Fatal:
    case ReplyKind::Busy:
    case ReplyKind::Start:
      return true;
    default:
      return !reply.firmware_name.empty();
  }
}

}  // namespace

std::string MarlinFirmware::defectOf(std::string_view command, const StreamSettings& settings) const {
  std::string too_long = defectOfLength(command, settings.max_line_bytes);
  if (!too_long.empty()) return too_long;
  const bool is_message = isCommand(command, "M117") || isCommand(command, "M118");
  if (!std::all_of(command.begin(), command.end(), [&](char c) { return isTaken(c, is_message); }))
    return "has a byte that is not printable ASCII; expected G-code text";
  if (command.find('*') != std::string_view::npos)
    return "has a '*', which marks a checksum; checksums are added here";
  if (!isLetter(command[0])) return "starts with no letter; expected a command letter";
  const bool is_tool_of_user = command == "Tx" || command == "Tc";  // asked for at a multi-material unit
  if (!is_tool_of_user && command.size() > 1 && (isLetter(command[1]) || command[1] == '_'))
    return "is a macro's name, which Marlin does not know; expected a letter and a number";
  if (isCommand(command, "M110")) return "sets the line number, which belongs to the streamer";
  if (command.find("M110") != std::string_view::npos)
    return "has 'M110' in its text, which Marlin takes for the setting of a line number";
  if (command.find(';') != std::string_view::npos)
    return "has a ';' within quotes, behind which Marlin looks for no checksum";
  if (command.find('\\') != std::string_view::npos)
    return "has a '\\', which Marlin leaves out of a line before it looks at the checksum";
  if (isCommand(command, "M118") && isReadAsAnswer(printedBy(command)))
    return "makes the machine print what is read as its own answer; expected another text";
  return defectOfWords(command);
}

std::unique_ptr<StreamJob> MarlinFirmware::begin(StreamOrder order) const {
  return std::make_unique<MarlinJob>(std::move(order), shared_from_this());
}

std::string MarlinFirmware::framed(std::uint64_t number, std::string_view command) const {
  return frameLine(number, command);
}

FirmwareReply MarlinFirmware::read(std::string_view line) const { return parseReply(line); }

std::string MarlinFirmware::identification() const { return "M115"; }

/// Many printers' firmware is Marlin under another name; these count lines in another way or not at all.
bool MarlinFirmware::isSpokenBy(std::string_view firmware_name) const {
  constexpr std::array<std::string_view, 6> kOthers = {"klipper", "reprapfirmware", "grbl",
                                                       "fluidnc", "smoothie",       "duet"};
  const std::string name = lowerCase(firmware_name);
  return std::none_of(kOthers.begin(), kOthers.end(),
                      [&](std::string_view other) { return name.find(other) != std::string::npos; });
}

std::string MarlinFirmware::numberedFrom(std::uint64_t number) const {
  return "M110 N" + std::to_string(number);
}

std::string MarlinFirmware::harmless() const { return "M105"; }

std::string MarlinFirmware::endOfMotions() const { return "M400"; }

std::string MarlinFirmware::reportPosition(int interval_s) const {
  return "M154 S" + std::to_string(interval_s);
}

std::string MarlinFirmware::reportTemperatures(int interval_s) const {
  return "M155 S" + std::to_string(interval_s);
}

bool MarlinFirmware::isBlocking(std::string_view command) const {
  constexpr std::array<std::string_view, 16> kCommands = {"G28",  "G29",  "G30",  "G34",  "G4",   "M0",
                                                          "M1",   "M48",  "M109", "M190", "M191", "M226",
                                                          "M303", "M400", "M600", "M701"};
  return isAnyCommand(command, kCommands);
}

std::optional<std::string> MarlinFirmware::changed(const LiveChange& change) const {
  if (change.setting == LiveSetting::Babystep) return "M290 Z" + decimal(change.value);
  const auto command = overrideCommand(change);
  return command ? command : cancelCommand(change);
}

std::vector<std::string> MarlinFirmware::interruption() const { return {"M108"}; }

std::vector<std::string> MarlinFirmware::stop() const { return {"M410"}; }

std::vector<std::string> MarlinFirmware::heatersOff() const { return {"M104 S0", "M140 S0"}; }

}  // namespace lamina
