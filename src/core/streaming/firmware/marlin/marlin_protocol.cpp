// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>

#include "lamina/base/text_search.hpp"

namespace lamina {
namespace {

bool containsIgnoringCase(std::string_view text, std::string_view part) {
  const auto equal = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), equal) != text.end();
}

template <class Number>
std::optional<Number> leadingInteger(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> leadingNumber(std::string_view text) {
  const std::string copy(text.substr(0, 32));
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  if (end == copy.c_str()) return std::nullopt;
  return value;
}

/// What follows `label` where it stands at the start of the text or after a space.
std::optional<std::string_view> after(std::string_view text, std::string_view label) {
  for (std::size_t at = text.find(label); at != std::string_view::npos; at = text.find(label, at + 1)) {
    if (at == 0 || text[at - 1] == ' ') return text.substr(at + label.size());
  }
  return std::nullopt;
}

std::optional<double> numberAfter(std::string_view text, std::string_view label) {
  const auto rest = after(text, label);
  return rest ? leadingNumber(*rest) : std::nullopt;
}

/// The target of "actual /target", which ends before the next heater's colon.
std::optional<double> targetAfter(std::string_view text) {
  const std::size_t slash = text.substr(0, text.find(':')).find('/');
  return slash == std::string_view::npos ? std::nullopt : leadingNumber(text.substr(slash + 1));
}

/// Of all "<heater>:<actual> /<target>", whatever the heaters are called.
double highestTarget(std::string_view text) {
  double highest = 0.0;
  for (std::size_t at = text.find('/'); at != std::string_view::npos; at = text.find('/', at + 1))
    highest = std::max(highest, leadingNumber(text.substr(at + 1)).value_or(0.0));
  return highest;
}

std::optional<ReportedTemperatures> temperatures(std::string_view text) {
  const auto nozzle = after(text, "T:");
  if (!nozzle) return std::nullopt;
  const auto nozzle_c = leadingNumber(*nozzle);
  if (!nozzle_c) return std::nullopt;
  ReportedTemperatures read;
  read.nozzle_c = *nozzle_c;
  read.highest_target_c = highestTarget(text);
  read.nozzle_target_c = targetAfter(*nozzle);
  if (const auto bed = after(text, "B:")) {
    read.bed_c = leadingNumber(*bed);
    if (read.bed_c) read.bed_target_c = targetAfter(*bed);
  }
  return read;
}

std::optional<ReportedPosition> position(std::string_view text) {
  if (!startsWith(text, "X:")) return std::nullopt;
  const auto x = numberAfter(text, "X:");
  const auto y = numberAfter(text, "Y:");
  const auto z = numberAfter(text, "Z:");
  if (!x || !y || !z) return std::nullopt;
  return ReportedPosition{*x, *y, *z, numberAfter(text, "E:").value_or(0.0)};
}

template <std::size_t count>
bool containsAny(std::string_view text, const std::array<std::string_view, count>& signs) {
  return std::any_of(signs.begin(), signs.end(),
                     [&](std::string_view sign) { return containsIgnoringCase(text, sign); });
}

bool isHalt(std::string_view text) {
  constexpr std::array<std::string_view, 7> kSigns = {
      "halted", "kill()", "stopped", "heating failed", "mintemp", "maxtemp", "thermal runaway"};
  return containsAny(text, kSigns);
}

/// What firmware says when it has started: Marlin and its kin, grbl, RepRapFirmware, Klipper.
bool isGreeting(std::string_view text) {
  constexpr std::string_view kStart = "start";
  constexpr std::size_t kMostStrayBytes = 8;
  if (text.size() >= kStart.size() && text.size() <= kStart.size() + kMostStrayBytes &&
      text.substr(text.size() - kStart.size()) == kStart) {
    const std::string_view before = text.substr(0, text.size() - kStart.size());
    return before.empty() || std::isalpha(static_cast<unsigned char>(before.back())) == 0;
  }
  constexpr std::array<std::string_view, 5> kSigns = {"free memory:", "is up and running", "['$' for help]",
                                                      "external reset", "watchdog reset"};
  return containsAny(text, kSigns);
}

/// In the words of Marlin and of Prusa's firmware.
bool isNotDone(std::string_view text) {
  constexpr std::array<std::string_view, 5> kSigns = {"unknown command", "unknown g code", "unknown m code",
                                                      "cold extrusion prevented", "long extrusion prevented"};
  return containsAny(text, kSigns);
}

/// What follows `//action:` [Marlin HOST_ACTION_COMMANDS].
ReplyKind kindOfAction(std::string_view action) {
  while (!action.empty() && action.front() == ' ') action.remove_prefix(1);
  constexpr std::array<std::string_view, 3> kEnds = {"cancel", "kill", "poweroff"};
  constexpr std::array<std::string_view, 3> kPauses = {"pause", "out_of_filament", "filament_runout"};
  const auto begins = [action](std::string_view name) { return startsWith(action, name); };
  if (std::any_of(kEnds.begin(), kEnds.end(), begins)) return ReplyKind::Cancel;
  if (begins("resume")) return ReplyKind::Resume;
  return std::any_of(kPauses.begin(), kPauses.end(), begins) ? ReplyKind::Pause : ReplyKind::Information;
}

bool isUnreadable(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char byte) {
    const auto code = static_cast<unsigned char>(byte);
    return (code < 0x20 && code != '\t') || code >= 0x7f;
  });
}

/// The name in an answer to M115, which ends before the next key in capitals.
std::string firmwareName(std::string_view text) {
  const auto rest = after(text, "FIRMWARE_NAME:");
  if (!rest) return {};
  std::size_t end = rest->size();
  for (const std::string_view key : {" SOURCE_CODE_URL:", " PROTOCOL_VERSION:", " FIRMWARE_VERSION:",
                                     " FIRMWARE_URL:", " MACHINE_TYPE:", " ELECTRONICS:"})
    end = std::min(end, rest->find(key));
  std::string_view name = rest->substr(0, end);
  while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
  return std::string(name);
}

bool isLineError(std::string_view text) {
  return containsIgnoringCase(text, "checksum") || containsIgnoringCase(text, "line number");
}

ReplyKind kindOfError(std::string_view text) {
  if (isLineError(text)) return ReplyKind::LineError;
  return isHalt(text) ? ReplyKind::Fatal : ReplyKind::Warning;
}

void readOk(std::string_view text, FirmwareReply& reply) {
  reply.kind = ReplyKind::Ok;
  if (const auto number = after(text, "N")) reply.line = leadingInteger<std::uint64_t>(*number);
  if (!reply.line) return;
  if (const auto blocks = after(text, "P")) reply.free_planner_blocks = leadingInteger<int>(*blocks);
  if (const auto slots = after(text, "B")) reply.free_command_slots = leadingInteger<int>(*slots);
}

void readResend(std::string_view number, FirmwareReply& reply) {
  reply.kind = ReplyKind::Resend;
  while (!number.empty() && (number.front() == ' ' || number.front() == ':' || number.front() == 'N')) {
    number.remove_prefix(1);
  }
  reply.line = leadingInteger<std::uint64_t>(number);
}

bool isOk(std::string_view text) { return text == "ok" || startsWith(text, "ok "); }

}  // namespace

std::uint8_t marlinChecksum(std::string_view text) {
  std::uint8_t sum = 0;
  for (const char byte : text) sum = static_cast<std::uint8_t>(sum ^ static_cast<unsigned char>(byte));
  return sum;
}

std::string frameLine(std::uint64_t number, std::string_view command) {
  std::string line = "N" + std::to_string(number) + " ";
  line += command;
  const std::uint8_t sum = marlinChecksum(line);
  line += '*';
  line += std::to_string(sum);
  line += '\n';
  return line;
}

FirmwareReply parseReply(std::string_view line) {
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.remove_suffix(1);
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.front())) != 0) line.remove_prefix(1);
  FirmwareReply reply;
  if (isOk(line)) {
    readOk(line, reply);
    if (line.size() == 2) return reply;
  } else if (startsWith(line, "Resend:")) {
    readResend(line.substr(7), reply);
  } else if (startsWith(line, "rs ")) {
    readResend(line.substr(3), reply);
  } else if (startsWith(line, "Error:")) {
    reply.kind = kindOfError(line);
  } else if (startsWith(line, "!!") || startsWith(line, "fatal:") || startsWith(line, "Fatal:")) {
    reply.kind = ReplyKind::Fatal;
  } else if (startsWith(line, "//")) {
    const auto action = after(line.substr(2), "action:");
    if (action) reply.kind = kindOfAction(*action);
  } else if (startsWith(line, "echo:busy") || startsWith(line, "busy:")) {
    reply.kind = ReplyKind::Busy;
  } else if (isGreeting(line)) {
    reply.kind = ReplyKind::Start;
  } else if (isNotDone(line)) {
    reply.kind = ReplyKind::NotDone;
  } else if (isUnreadable(line)) {
    reply.kind = ReplyKind::Unreadable;
  }
  reply.text = line;
  reply.temperatures = temperatures(line);
  reply.position = position(line);
  reply.firmware_name = firmwareName(line);
  return reply;
}

}  // namespace lamina
