// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/ok_paced/emulated_reprap.hpp"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "lamina/base/characters.hpp"
#include "streaming/firmware/reprapfirmware/reprap_protocol.hpp"

namespace lamina {
namespace {

/// A line as the firmware's parser leaves it.
struct ParsedLine {
  std::string command;
  bool has_number = false;
  bool has_check = false;
  int check_digits = 0;
  unsigned long declared = 0;
  std::string checked;  ///< the bytes that the check covers
};

/// Where the check begins: at a '*' outside quotes and braces, of a line with a number.
std::size_t checkOf(std::string_view line) {
  bool is_quoted = false;
  int braces = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (line[i] == '{') ++braces;
    if (line[i] == '}' && braces > 0) --braces;
    if (line[i] == '*' && braces == 0) return i;
  }
  return std::string_view::npos;
}

ParsedLine parsed(std::string_view line) {
  ParsedLine read;
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return read;
  line.remove_prefix(begin);
  read.has_number = line[0] == 'N' || line[0] == 'n';
  if (!read.has_number) {
    read.command = std::string(line.substr(0, line.find(';')));
    return read;
  }
  const std::size_t star = checkOf(line);
  const std::string_view body = line.substr(0, star);
  std::size_t at = 1;
  while (at < body.size() && isDigit(body[at])) ++at;
  while (at < body.size() && body[at] == ' ') ++at;
  read.command = std::string(body.substr(at));
  read.checked = std::string(body);
  if (star == std::string_view::npos) return read;
  read.has_check = true;
  for (at = star + 1; at < line.size() && isDigit(line[at]); ++at) {
    read.declared = 10 * read.declared + static_cast<unsigned long>(line[at] - '0');
    ++read.check_digits;
  }
  return read;
}

bool isRight(const ParsedLine& line) {
  if (line.check_digits == 5) return line.declared == reprapCrc(line.checked);
  unsigned sum = 0;
  for (const char c : line.checked) sum ^= static_cast<unsigned char>(c);
  return line.check_digits >= 1 && line.check_digits <= 3 && line.declared == sum;
}

std::optional<double> argument(const std::string& command, char letter) {
  const std::size_t at = command.find(letter, 1);
  if (at == std::string::npos) return std::nullopt;
  return std::atof(command.c_str() + at + 1);
}

std::string decimal(double value, const char* format) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

EmulatedPacedFirmware::Answer EmulatedRepRap::onLine(std::string_view line) {
  const ParsedLine read = parsed(line);
  Answer dropped;
  dropped.is_silent = true;
  if (read.command.empty()) return dropped;
  if (read.has_check && !isRight(read)) return dropped;
  const bool has_crc = read.has_check && read.check_digits == 5;
  if (checks_ == Checks::RequiresCrc && !has_crc) return dropped;
  return obey(read.command);
}

EmulatedPacedFirmware::Answer EmulatedRepRap::obey(const std::string& command) {
  const std::string name = command.substr(0, command.find(' '));
  if (status_ == "halted" && name != "M115" && name != "M409")
    return {"Error: " + name + ": Machine is halted\n"};
  if (name == "M115") {
    return {
        "FIRMWARE_NAME: RepRapFirmware for Duet 2 WiFi/Ethernet FIRMWARE_VERSION: 3.5.3 ELECTRONICS: "
        "Duet WiFi 1.02 or later FIRMWARE_DATE: 2024-09-18\n"};
  }
  if (name == "M409") return {R"({"key":"state.status","flags":"","result":")" + status_ + "\"}\n"};
  if (name == "M105") return {{}, "ok T:25.0 /" + decimal(temperatureTarget(), "%.1f") + " B:25.0 /0.0"};
  if (name == "echo") return {echoed(command.substr(4)) + "\n"};
  if (name == "M575") {
    const char* const how =
        checks_ == Checks::RequiresCrc ? "requires CRC" : "does not require checksum or CRC";
    return {std::string("Channel 0: baud rate 115200, ") + how + "\n"};
  }
  if (name == "M568") setNozzleTarget(0.0);
  if (name == "M568" || name == "M400") return {};
  if (name == "M4242") return {"Warning: " + name + ": Command is not supported\n"};
  const char letter = command[0];
  if (letter != 'G' && letter != 'M' && letter != 'T') return {"Error: Bad command: " + command + "\n"};
  Answer answer = run(command);
  const bool was_run = answer.lines.empty() && !answer.is_silent;
  if (was_run) follow(command);
  return answer;
}

/// The values of a list such as `"lamina",7,move.axes[0].userPosition`.
std::string EmulatedRepRap::echoed(const std::string& expressions) const {
  std::istringstream list(expressions);
  std::string text;
  std::string item;
  while (std::getline(list, item, ',')) {
    item.erase(0, item.find_first_not_of(' '));
    if (!text.empty()) text += ' ';
    if (item.compare(0, 10, "move.axes[") == 0) {
      text += decimal(at_[static_cast<std::size_t>(item[10] - '0')], "%.3f");
    } else if (item == "move.virtualEPos") {
      text += decimal(at_[3], "%.5f");
    } else {
      text += item[0] == '"' ? item.substr(1, item.size() - 2) : item;
    }
  }
  return text;
}

void EmulatedRepRap::follow(const std::string& command) {
  const std::string name = command.substr(0, command.find(' '));
  if (name == "G90" || name == "G91") is_relative_ = name == "G91";
  if (name == "M82" || name == "M83") is_filament_relative_ = name == "M83";
  const bool is_motion = name == "G0" || name == "G1" || name == "G2" || name == "G3";
  if (!is_motion && name != "G92" && name != "G28") return;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const auto value = argument(command, "XYZE"[i]);
    if (name == "G28") {
      if (i < 3) at_[i] = 0.0;
    } else if (value) {
      const bool is_relative = is_motion && (i == 3 ? is_filament_relative_ : is_relative_);
      at_[i] = is_relative ? at_[i] + *value : *value;
    }
  }
}

std::string EmulatedRepRap::refusalOf(const std::string& command) const {
  return "Error: " + command.substr(0, command.find(' ')) + ": insufficient axes homed\n";
}

void EmulatedRepRap::halt() {
  status_ = "halted";
  say("Emergency Stop! Reset the controller to continue.\n");
}

void EmulatedRepRap::restart() {
  forgetInput();
  at_ = {};
  is_relative_ = is_filament_relative_ = false;
  say("RepRapFirmware for Duet 2 WiFi/Ethernet is up and running.\n");
}

}  // namespace lamina
