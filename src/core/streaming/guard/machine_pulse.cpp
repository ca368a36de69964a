// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_pulse.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

#include "streaming/session/identification.hpp"

namespace lamina {
namespace {

constexpr std::string_view kHead = "lamina pulse 2";
constexpr std::size_t kLines = 8;
constexpr int kFastestBaud = 4000000;

std::string onOneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() <= kLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<int> numberIn(std::string_view text, int most) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_number && number >= 0 && number <= most ? std::optional<int>(number) : std::nullopt;
}

}  // namespace

std::string toText(const MachinePulse& pulse) {
  std::string text(kHead);
  text += pulse.is_at_work ? "\n1\n" : "\n0\n";
  text += std::to_string(pulse.port.baud) + '\n';
  text += pulse.keeps_heaters_on ? "1\n" : "0\n";
  text += pulse.has_job ? "1\n" : "0\n";
  text += onOneLine(pulse.firmware) + '\n' + onOneLine(pulse.port.name) + '\n' + onOneLine(pulse.program);
  return text + '\n';
}

std::optional<MachinePulse> pulseIn(std::string_view text) {
  if (text.empty() || text.size() > kLongestPulse || text.back() != '\n') return std::nullopt;
  const std::vector<std::string_view> lines = linesOf(text);
  if (lines.size() != kLines || lines[0] != kHead) return std::nullopt;
  const auto at_work = numberIn(lines[1], 1);
  const auto baud = numberIn(lines[2], kFastestBaud);
  const auto heaters = numberIn(lines[3], 1);
  const auto job = numberIn(lines[4], 1);
  if (!at_work || !baud || !heaters || !job || lines[5].empty() || lines[6].empty()) return std::nullopt;
  return MachinePulse{*at_work == 1,         {std::string(lines[6]), *baud},
                      std::string(lines[5]), std::string(lines[7]),
                      *heaters == 1,         *job == 1};
}

std::string protocolOfFirmware(const std::string& firmware_name) {
  const std::vector<std::string> protocols = protocolsSpokenBy(firmware_name);
  return protocols.size() == 1 ? protocols.front() : kAnyFirmware;
}

}  // namespace lamina
