// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/line_gate.hpp"

#include <charconv>

#include "lamina/base/text.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {
namespace {

std::optional<std::uint64_t> wholeNumber(std::string_view text) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

bool isM110(std::string_view command) {
  return command.substr(0, 4) == "M110" && (command.size() == 4 || command[4] == ' ');
}

GatedLine refused(const char* why) { return {why, {}, std::nullopt}; }

}  // namespace

std::optional<std::uint64_t> lineNumberOf(std::string_view line) {
  line = trimmed(line);
  if (line.empty() || line.front() != 'N') return std::nullopt;
  line.remove_prefix(1);
  return wholeNumber(line.substr(0, line.find_first_not_of("0123456789")));
}

std::string withoutErased(std::string_view line) {
  std::string kept;
  for (const char c : line) {
    if (c != '\b') {
      kept += c;
    } else if (!kept.empty()) {
      kept.pop_back();
    }
  }
  return kept;
}

GatedLine LineGate::take(std::string_view line) {
  line = trimmed(line);
  const std::size_t star = line.rfind('*');
  const auto number = lineNumberOf(line);
  if (!number && !line.empty() && line.front() == 'N')
    return refused("Line Number is not Last Number+1, Last Line: ");
  // As Marlin does: the tail of a line is run, whatever checksum it ends with.
  if (!number) return {{}, std::string(trimmed(line.substr(0, star))), std::nullopt};
  if (star == std::string_view::npos) return refused("No Checksum with line number, Last Line: ");
  if (wholeNumber(trimmed(line.substr(star + 1))) != marlinChecksum(line.substr(0, star))) {
    return refused("checksum mismatch, Last Line: ");
  }
  const std::size_t space = line.find_first_not_of("0123456789", 1);
  const std::string_view command = trimmed(line.substr(space, star - space));
  if (isM110(command)) {
    const std::size_t n = command.find('N', 4);
    const auto set = n == std::string_view::npos ? number : wholeNumber(command.substr(n + 1));
    last_number_ = first_number_ = set.value_or(*number);
  } else if (*number != last_number_ + 1) {
    return refused("Line Number is not Last Number+1, Last Line: ");
  } else {
    last_number_ = *number;
  }
  return {{}, std::string(command), number};
}

}  // namespace lamina
