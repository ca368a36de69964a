// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>
#include <vector>

#include "lamina/base/text.hpp"
#include "lamina/base/text_search.hpp"

namespace lamina {
namespace {

std::vector<std::string_view> partsOf(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<int> wholeNumberOf(std::string_view text) {
  int value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> numberOf(std::string_view text) {
  const std::string copy(text);
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  if (copy.empty() || *end != '\0') return std::nullopt;
  return value;
}

/// The first three axes; a machine with fewer has the others at 0.
std::optional<GrblAxes> axesOf(std::string_view text) {
  GrblAxes axes{};
  const auto parts = partsOf(text, ',');
  for (std::size_t i = 0; i < std::min(parts.size(), axes.size()); ++i) {
    const auto value = numberOf(parts[i]);
    if (!value) return std::nullopt;
    axes[i] = *value;
  }
  return axes;
}

GrblState stateOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, GrblState>, 10> kNames = {{
      {"Idle", GrblState::Idle},
      {"Run", GrblState::Run},
      {"Hold", GrblState::Hold},
      {"Jog", GrblState::Jog},
      {"Home", GrblState::Home},
      {"Alarm", GrblState::Alarm},
      {"Check", GrblState::Check},
      {"Door", GrblState::Door},
      {"Sleep", GrblState::Sleep},
      {"Tool", GrblState::Tool},
  }};
  for (const auto& known : kNames)
    if (known.first == name) return known.second;
  return GrblState::Other;
}

void readField(std::string_view field, GrblReport& report) {
  const std::size_t colon = field.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view name = field.substr(0, colon);
  const std::string_view value = field.substr(colon + 1);
  if (name == "MPos") {
    report.machine_position = axesOf(value);
  } else if (name == "WPos") {
    report.work_position = axesOf(value);
  } else if (name == "WCO") {
    report.work_offset = axesOf(value);
  } else if (name == "Bf") {
    const auto parts = partsOf(value, ',');
    if (parts.size() < 2) return;
    report.free_blocks = wholeNumberOf(parts[0]);
    report.free_bytes = wholeNumberOf(parts[1]);
  } else if (name == "Ov") {
    const auto parts = partsOf(value, ',');
    if (parts.size() != 3) return;
    const auto feed = wholeNumberOf(parts[0]);
    const auto rapid = wholeNumberOf(parts[1]);
    const auto spindle = wholeNumberOf(parts[2]);
    if (feed && rapid && spindle) report.overrides = GrblPercents{*feed, *rapid, *spindle};
  } else if (name == "FS") {
    const auto parts = partsOf(value, ',');
    if (parts.size() >= 2) report.spindle_speed = numberOf(parts[1]);
  }
}

std::optional<GrblReport> reportIn(std::string_view text) {
  if (text.size() < 3 || text.front() != '<' || text.back() != '>') return std::nullopt;
  const auto fields = partsOf(text.substr(1, text.size() - 2), '|');
  if (fields.size() < 2) return std::nullopt;
  GrblReport report;
  report.state_text = std::string(fields.front());
  const auto parts = partsOf(fields.front(), ':');
  report.state = stateOf(parts.front());
  if (parts.size() > 1) report.substate = wholeNumberOf(parts[1]);
  for (std::size_t i = 1; i < fields.size(); ++i) readField(fields[i], report);
  return report;
}

/// grbl's "['$' for help]", grblHAL's "['$' or '$HELP' for help]", FluidNC's "[FluidNC v3.9 '$' for help]".
bool isGreeting(std::string_view text) {
  return text.find("for help]") != std::string_view::npos || startsWith(text, "Grbl ") ||
         startsWith(text, "GrblHAL ");
}

GrblReplyKind kindInBrackets(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, GrblReplyKind>, 4> kStarts = {{
      {"[VER:", GrblReplyKind::Version},
      {"[OPT:", GrblReplyKind::Options},
      {"[GC:", GrblReplyKind::Modes},
      {"[MSG:", GrblReplyKind::Message},
  }};
  for (const auto& start : kStarts)
    if (startsWith(text, start.first)) return start.second;
  return GrblReplyKind::Other;
}

/// In steps of 10 and 1 %.
std::string overrideBytes(int from_percent, int to_percent, std::string_view bytes) {
  constexpr int kLowest = 10;
  constexpr int kHighest = 200;
  constexpr int kCoarse = 10;
  int left = std::clamp(to_percent, kLowest, kHighest) - std::clamp(from_percent, kLowest, kHighest);
  std::string output;
  for (; left >= kCoarse; left -= kCoarse) output += bytes[0];
  for (; left <= -kCoarse; left += kCoarse) output += bytes[1];
  for (; left > 0; --left) output += bytes[2];
  for (; left < 0; ++left) output += bytes[3];
  return output;
}

}  // namespace

GrblReply parseGrblReply(std::string_view line) {
  GrblReply reply;
  const std::string_view text = trimmed(line);
  reply.text = std::string(text);
  const auto code = [&](std::string_view start) { return wholeNumberOf(text.substr(start.size())); };
  if (text == "ok") {
    reply.kind = GrblReplyKind::Ok;
  } else if (startsWith(text, "error:") && code("error:")) {
    reply.kind = GrblReplyKind::Error;
    reply.code = *code("error:");
  } else if (startsWith(text, "ALARM:") && code("ALARM:")) {
    reply.kind = GrblReplyKind::Alarm;
    reply.code = *code("ALARM:");
  } else if ((reply.report = reportIn(text))) {
    reply.kind = GrblReplyKind::Report;
  } else if (isGreeting(text)) {
    reply.kind = GrblReplyKind::Greeting;
  } else if (startsWith(text, "$") && text.find('=') != std::string_view::npos) {
    reply.kind = GrblReplyKind::Setting;
  } else {
    reply.kind = kindInBrackets(text);
  }
  return reply;
}

std::string grblFeedOverride(int from_percent, int to_percent) {
  return overrideBytes(from_percent, to_percent, "\x91\x92\x93\x94");
}

std::string grblSpindleOverride(int from_percent, int to_percent) {
  return overrideBytes(from_percent, to_percent, "\x9A\x9B\x9C\x9D");
}

std::string grblRapidOverride(int to_percent) {
  constexpr int kLow = 25;
  constexpr int kMedium = 50;
  if (to_percent <= kLow) return "\x97";
  return to_percent <= kMedium ? "\x96" : "\x95";
}

}  // namespace lamina
