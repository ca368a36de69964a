// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/process_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kFanSteps = 255.0;

void writeWords(const Dwell& dwell, std::string& text) {
  text += "G4 P" + std::to_string(std::llround(dwell.duration_s * 1e3)) + "\n";
}

void writeWords(const FanShare& fan, std::string& text) {
  const auto steps = std::llround(fan.share * kFanSteps);
  text += steps > 0 ? "M106 S" + std::to_string(steps) + "\n" : "M107\n";
}

void writeWords(const OperatorPause& pause, std::string& text) {
  text += "M0" + (pause.message.empty() ? "" : " " + pause.message) + "\n";
}

void writeWords(const MachineCode& code, std::string& text) {
  text += code.text;
  if (text.back() != '\n') text += '\n';
}

template <class Number>
std::optional<Number> numberAt(std::string_view text) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} ? std::optional(value) : std::nullopt;
}

/// The number behind a letter that stands after a space.
std::optional<double> wordOf(std::string_view command, char letter) {
  for (std::size_t at = 1; at < command.size(); ++at)
    if (command[at] == letter && command[at - 1] == ' ') return numberAt<double>(command.substr(at + 1));
  return std::nullopt;
}

}  // namespace

void writeEvent(const ToolpathEvent& event, std::string& text) {
  std::visit([&text](const auto& kind) { writeWords(kind, text); }, event);
}

std::optional<ToolpathEvent> readEvent(std::string_view command) {
  const std::string_view code = command.substr(0, command.find(' '));
  if (code == "M107") return FanShare{0.0};
  if (code == "M106") {
    if (wordOf(command, 'P').value_or(0.0) != 0.0) return std::nullopt;
    return FanShare{std::clamp(wordOf(command, 'S').value_or(kFanSteps) / kFanSteps, 0.0, 1.0)};
  }
  if (code != "M0" && code != "M1" && code != "M600" && code != "M601") return std::nullopt;
  return OperatorPause{std::string(trimmed(command.substr(code.size())))};
}

std::optional<std::uint32_t> readTool(std::string_view command) {
  if (command.size() < 2 || command[0] != 'T') return std::nullopt;
  const auto tool = numberAt<std::uint32_t>(command.substr(1));
  const bool is_alone = tool && command.substr(1) == std::to_string(*tool);
  return is_alone ? tool : std::nullopt;
}

}  // namespace lamina
