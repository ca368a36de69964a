// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/ok_paced/emulated_klipper.hpp"

#include <cctype>
#include <cstdio>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

std::string withoutNumber(std::string_view line) {
  line = trimmed(line);
  if (line.empty() || line[0] != 'N' || line.size() < 2 ||
      std::isdigit(static_cast<unsigned char>(line[1])) == 0)
    return std::string(line);
  const std::size_t begin = line.find_first_not_of("0123456789", 1);
  if (begin == std::string_view::npos) return {};
  return std::string(trimmed(line.substr(begin, line.rfind('*') - begin)));
}

std::string report(double target_c) {
  char text[64];
  std::snprintf(text, sizeof text, "B:60.0 /0.0 T0:210.0 /%.1f", target_c);
  return text;
}

}  // namespace

EmulatedPacedFirmware::Answer EmulatedKlipper::onLine(std::string_view line) {
  const std::string command = withoutNumber(line);
  const std::string name = command.substr(0, command.find(' '));
  if (name == "M115") return {{}, "ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:v0.12.0"};
  if (name == "M105") return {{}, "ok " + report(temperatureTarget())};
  if (name == "ECHO") return {"// " + command + "\n"};
  if (name == "STATUS" && reason_.empty()) return {"// Klipper state: Ready\n"};
  if (name == "STATUS") return {"// " + reason_ + "\n// Klipper state: Not ready\n!! " + reason_ + "\n"};
  if (!reason_.empty()) return {"!! " + reason_ + "\n"};
  if (name == "TURN_OFF_HEATERS") {
    setNozzleTarget(0.0);
    return {};
  }
  if (name.empty() || name == "M400") return {};
  if (name == "M4242") return {"// Unknown command:\"" + name + "\"\n"};
  return run(command);
}

std::string EmulatedKlipper::refusalOf(const std::string& command) const {
  return "!! Move out of range: " + command + "\n";
}

void EmulatedKlipper::halt() {
  reason_ = "MCU 'mcu' shutdown: Timer too close";
  say("// Klipper state: Shutdown\n");
}

void EmulatedKlipper::restart() {
  forgetInput();
  say("// Klipper state: Disconnect\n");
  say("// Klipper state: Ready\n");
}

}  // namespace lamina
