// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/process_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "lamina/base/text.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "program/gcode/command_words.hpp"
#include "program/gcode/fixed_point.hpp"

namespace lamina {
namespace {

constexpr double kFanSteps = 255.0;
constexpr std::string_view kBox = "M291";  // a message that waits to be acknowledged

std::string pauseLine(std::string message, const ProgramSettings& settings) {
  std::string command =
      settings.pause_code == "dialect" ? gcodeDialects().find(settings.dialect).pause : settings.pause_code;
  if (command == kBox) {
    std::replace(message.begin(), message.end(), '"', '\'');
    return command + " P\"" + (message.empty() ? "Continue?" : message) + "\" S2";
  }
  if (message.empty()) return command;
  // The other commands would read the message as parameters.
  return command + (command == "M0" ? " " : " ; ") + message;
}

/// The text of a box that waits; nothing if the command is none.
std::optional<OperatorPause> readBox(std::string_view command) {
  const std::size_t begin = command.find('"');
  const std::size_t end = command.rfind('"');
  if (!isCommand(command, kBox) || begin == end || command.find("S2", end) == std::string_view::npos)
    return std::nullopt;
  return OperatorPause{std::string(command.substr(begin + 1, end - begin - 1))};
}

/// Appends each kind of event.
struct EventWords {
  const ProgramSettings& settings;
  std::string& text;

  void operator()(const Dwell& dwell) const {
    // Whole milliseconds; in seconds with 3 decimals.
    const long long thousandths = std::llround(1e3 * dwell.duration_s);
    char digits[32];
    char* const end = gcodeDialects().find(settings.dialect).dwells_in_seconds
                          ? writeFixed<3>(digits, thousandths)
                          : std::to_chars(digits, digits + sizeof digits, thousandths).ptr;
    text.append("G4 P").append(digits, end).append("\n");
  }
  void operator()(const FanShare& fan) const {
    const long long steps = std::llround(fan.share * kFanSteps);
    const long long least = gcodeDialects().find(settings.dialect).least_fan;
    text += steps > 0 ? "M106 S" + std::to_string(std::max(steps, least)) + "\n" : "M107\n";
  }
  void operator()(const OperatorPause& pause) const { text += pauseLine(pause.message, settings) + "\n"; }
  void operator()(const PartMark& mark) const { text += ";PART:" + mark.name + "\n"; }
  void operator()(const MachineCode& code) const {
    text += code.text;
    if (text.back() != '\n') text += '\n';
  }
};

constexpr std::string_view kPartMark = "PART:";

}  // namespace

void writeEvent(const ToolpathEvent& event, const ProgramSettings& settings, std::string& text) {
  std::visit(EventWords{settings, text}, event);
}

std::optional<ToolpathEvent> readEvent(std::string_view command) {
  constexpr std::array<std::string_view, 6> kPauses = {"M0", "M1", "M226", "M600", "M601", "PAUSE"};
  if (isCommand(command, "M107")) return FanShare{0.0};
  if (isCommand(command, "M106")) {
    if (wordValue(command, 'P').value_or(0.0) != 0.0) return std::nullopt;
    return FanShare{std::clamp(wordValue(command, 'S').value_or(kFanSteps) / kFanSteps, 0.0, 1.0)};
  }
  if (const auto box = readBox(command)) return *box;
  if (!isAnyCommand(command, kPauses)) return std::nullopt;
  return OperatorPause{std::string(trimmed(command.substr(std::min(command.find(' '), command.size()))))};
}

std::optional<PartMark> readPartMark(std::string_view comment) {
  if (comment.substr(0, kPartMark.size()) != kPartMark) return std::nullopt;
  return PartMark{std::string(trimmed(comment.substr(kPartMark.size())))};
}

std::optional<std::uint32_t> readTool(std::string_view command) {
  if (command.size() < 2 || command[0] != 'T') return std::nullopt;
  std::uint32_t tool = 0;
  const auto result = std::from_chars(command.data() + 1, command.data() + command.size(), tool);
  const bool is_alone = result.ec == std::errc{} && result.ptr == command.data() + command.size();
  return is_alone ? std::optional(tool) : std::nullopt;
}

}  // namespace lamina
