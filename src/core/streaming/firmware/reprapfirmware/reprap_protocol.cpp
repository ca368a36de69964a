// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/reprapfirmware/reprap_protocol.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "lamina/base/text.hpp"
#include "lamina/base/text_search.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "program/gcode/command_words.hpp"
#include "streaming/job/complaints.hpp"

namespace lamina {
namespace {

constexpr const char* kMark = "lamina";

bool isLower(char c) { return c >= 'a' && c <= 'z'; }

/// "25.0 /0.0" of each heater: whether none has a target; nothing if there is no heater in it.
std::optional<bool> areTargetsZero(std::string_view text) {
  std::optional<bool> are_zero;
  for (std::size_t at = text.find(" /"); at != std::string_view::npos; at = text.find(" /", at + 1)) {
    const std::string number(text.substr(at + 2, 16));
    char* end = nullptr;
    const double target = std::strtod(number.c_str(), &end);
    if (end == number.c_str()) return std::nullopt;
    are_zero = are_zero.value_or(true) && target == 0.0;
  }
  return are_zero;
}

/// "lamina 7", or "lamina 7 x y z e x y z e".
std::optional<SyncAnswer> readAnswer(std::string_view line) {
  constexpr int kNumbers = 8;
  if (!startsWith(line, kMark)) return std::nullopt;
  const std::string rest(line.substr(std::string_view(kMark).size()));
  const char* at = rest.c_str();
  char* end = nullptr;
  SyncAnswer answer;
  answer.question = std::strtoull(at, &end, 10);
  if (end == at) return std::nullopt;
  std::array<double, kNumbers> numbers{};
  int count = 0;
  for (at = end; count < kNumbers; ++count, at = end) {
    numbers[count] = std::strtod(at, &end);
    if (end == at) break;
  }
  if (*at != '\0') return std::nullopt;
  if (count == 0) return answer;
  const bool is_twice =
      count == kNumbers && std::equal(numbers.begin(), numbers.begin() + 4, numbers.begin() + 4);
  if (!is_twice) return std::nullopt;
  answer.position = ReportedPosition{numbers[0], numbers[1], numbers[2], numbers[3]};
  return answer;
}

std::string wordAtStart(std::string_view command) {
  const auto end = std::find_if_not(command.begin(), command.end(), isLower);
  return std::string(command.begin(), end);
}

/// What of a command stands neither in quotes nor in braces, and whether both are closed.
struct OuterText {
  std::string text;
  bool is_closed = true;
};

OuterText outerTextOf(std::string_view command) {
  OuterText outer;
  bool is_quoted = false;
  int braces = 0;
  for (const char c : command) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted && c == '{') ++braces;
    if (!is_quoted && braces == 0 && c != '"') outer.text += c;
    if (!is_quoted && c == '}' && braces > 0) --braces;
  }
  outer.is_closed = !is_quoted && braces == 0;
  return outer;
}

/// Commands that make the firmware answer in another way, or not at all.
std::string changeOfTalk(std::string_view command) {
  const auto is = [command](std::string_view code) { return isCommand(command, code); };
  if (is("M555")) return "changes how RepRapFirmware answers";
  if (is("M575")) return "changes the settings of the link";
  if (is("M28") || is("M559") || is("M560"))
    return "makes RepRapFirmware write the lines behind it to a file instead of running them";
  return {};
}

std::string defectOfStart(std::string_view command) {
  constexpr std::array<std::string_view, 7> kInFiles = {"if",    "elif",  "else",    "while",
                                                        "break", "abort", "continue"};
  constexpr std::array<std::string_view, 5> kAnywhere = {"echo", "global", "set", "skip", "var"};
  const std::string word = wordAtStart(command);
  if (std::find(kInFiles.begin(), kInFiles.end(), word) != kInFiles.end())
    return "is '" + word + "', which RepRapFirmware runs in files on its card only";
  if (std::find(kAnywhere.begin(), kAnywhere.end(), word) != kAnywhere.end()) return {};
  const auto isLetterAt = [&](std::size_t at) {
    return command.size() > at && std::isalpha(static_cast<unsigned char>(command[at])) != 0;
  };
  if (!isLetterAt(0))
    return "starts with '" + std::string(command.substr(0, 1)) + "'; expected a command letter";
  if (isLetterAt(1)) return "is no command of RepRapFirmware; expected G, M or T and a number";
  return {};
}

}  // namespace

std::uint16_t reprapCrc(std::string_view text) {
  constexpr unsigned kPolynomial = 0x1021;
  unsigned crc = 0;
  for (const char byte : text) {
    crc ^= static_cast<unsigned>(static_cast<unsigned char>(byte)) << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1U) ^ ((crc & 0x8000U) != 0 ? kPolynomial : 0U);
    crc &= 0xffffU;
  }
  return static_cast<std::uint16_t>(crc);
}

std::string reprapFrame(std::uint64_t number, std::string_view command) {
  std::string line = "N" + std::to_string(number) + " ";
  line += command;
  std::array<char, 8> check{};
  std::snprintf(check.data(), check.size(), "*%05u", static_cast<unsigned>(reprapCrc(line)));
  return line + check.data() + "\n";
}

PacedReply readReprapReply(std::string_view line) {
  PacedReply read;
  read.reply = parseReply(line);
  FirmwareReply& reply = read.reply;
  read.are_heaters_off = areTargetsZero(reply.text);
  // Without heaters the answer to M105 is an ok and a blank.
  if (startsWith(line, "ok ") && trimmed(line) == "ok") read.are_heaters_off = true;
  read.sync_answer = readAnswer(reply.text);
  if (contains(reply.text, "Emergency Stop!") || contains(reply.text, ": Machine is halted")) {
    reply.kind = ReplyKind::Fatal;
  } else if (reprapComplaint(reply.text) == Complaint::Error) {
    reply.kind = ReplyKind::Warning;
    read.is_refusal = true;
  } else if (startsWith(reply.text, "Warning:")) {
    const bool is_undone = reprapComplaint(reply.text) == Complaint::NotDone;
    reply.kind = is_undone ? ReplyKind::NotDone : ReplyKind::Warning;
  } else if (startsWith(reply.text, "Send M292 to continue")) {
    reply.kind = ReplyKind::Warning;
  }
  return read;
}

std::string reprapQuestion(std::uint64_t number, LinkKind link) {
  std::string question = std::string("echo \"") + kMark + "\"," + std::to_string(number);
  if (link != LinkKind::Lossy) return question;
  for (int i = 0; i < 2; ++i) {
    for (const char* axis : {"0", "1", "2"}) question += std::string(",move.axes[") + axis + "].userPosition";
    question += ",move.virtualEPos";
  }
  return question;
}

std::string reprapDefectOf(std::string_view command, int max_line_bytes) {
  constexpr int kLongest = 255;  // of the firmware's buffer, of which one byte ends the text
  constexpr std::size_t kFrame = std::string_view("N99999999 *65535").size();
  const int limit = max_line_bytes > 0 ? max_line_bytes : kLongest;
  if (command.size() + kFrame > static_cast<std::size_t>(limit)) {
    return "is " + std::to_string(command.size() + kFrame) +
           " bytes with line number and check; the machine takes " + std::to_string(limit);
  }
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  if (std::any_of(command.begin(), command.end(), isControl))
    return "has a control character; expected G-code text";
  const OuterText outer = outerTextOf(command);
  if (!outer.is_closed)
    return "has a quote or a brace that is not closed, in which the line's check would be lost";
  if (contains(outer.text, "*"))
    return "has a '*' outside quotes and braces, which marks a check; checks are added here";
  const std::string start = defectOfStart(command);
  return start.empty() ? changeOfTalk(command) : start;
}

}  // namespace lamina
