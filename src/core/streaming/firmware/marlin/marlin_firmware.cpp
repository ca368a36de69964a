// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "streaming/firmware/marlin/marlin_job.hpp"

namespace lamina {

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
  std::string name(firmware_name);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
  return std::any_of(kCommands.begin(), kCommands.end(), [&](std::string_view name) {
    return command.compare(0, name.size(), name) == 0 &&
           (command.size() == name.size() ||
            std::isdigit(static_cast<unsigned char>(command[name.size()])) == 0);
  });
}

std::vector<std::string> MarlinFirmware::interruption() const { return {"M108"}; }

std::vector<std::string> MarlinFirmware::stop() const { return {"M410"}; }

std::vector<std::string> MarlinFirmware::heatersOff() const { return {"M104 S0", "M140 S0"}; }

}  // namespace lamina
