// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/klipper/klipper_firmware.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "streaming/firmware/klipper/klipper_protocol.hpp"
#include "streaming/firmware/ok_paced/quick_commands.hpp"

namespace lamina {
namespace {

constexpr const char* kWho = "M115";
constexpr const char* kState = "STATUS";

OpeningVerdict judgeName(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line.find("FIRMWARE_NAME:") == std::string::npos) continue;
    if (line.find("FIRMWARE_NAME:Klipper") != std::string::npos) return {};
    return {OpeningVerdict::Kind::Refused,
            "the machine is \"" + line + "\", which does not speak klipper; expected stream.firmware auto"};
  }
  return {OpeningVerdict::Kind::NotYet, "the machine answers M115 without the name of its firmware"};
}

/// Klipper gives its reason in lines of its own, of which the error repeats the first.
OpeningVerdict judgeState(const std::vector<std::string>& lines) {
  std::string reason;
  for (const std::string& line : lines) {
    if (line == "// Klipper state: Ready") return {};
    if (line.compare(0, 3, "// ") == 0 && line.find("Klipper state:") == std::string::npos)
      reason += (reason.empty() ? "" : " ") + line.substr(3);
    if (line.compare(0, 2, "!!") == 0 && reason.empty())
      reason = line.substr(std::min<std::size_t>(3, line.size()));
  }
  if (reason.empty()) return {OpeningVerdict::Kind::NotYet, "Klipper does not report its state (STATUS)"};
  const bool may_pass = reason.find("is not ready") != std::string::npos;
  return {may_pass ? OpeningVerdict::Kind::NotYet : OpeningVerdict::Kind::Refused,
          "Klipper is not ready: \"" + reason + "\""};
}

}  // namespace

bool KlipperFirmware::isSpokenBy(std::string_view firmware_name) const {
  constexpr std::string_view kName = "Klipper";
  return firmware_name.substr(0, kName.size()) == kName;
}

std::string KlipperFirmware::defectOf(std::string_view command, const StreamSettings& settings) const {
  return klipperDefectOf(command, settings.max_line_bytes);
}

std::string KlipperFirmware::framed(std::uint64_t, std::string_view command) const {
  return std::string(command) + "\n";
}

PacedReply KlipperFirmware::read(std::string_view line) const { return readKlipperReply(line); }

std::vector<std::string> KlipperFirmware::opening(LinkKind) const { return {kWho, kState}; }

OpeningVerdict KlipperFirmware::judge(const std::string& question,
                                      const std::vector<std::string>& lines) const {
  return question == kWho ? judgeName(lines) : judgeState(lines);
}

std::string KlipperFirmware::question(std::uint64_t number, LinkKind) const {
  return klipperQuestion(number);
}

ChangeCommand KlipperFirmware::changed(const LiveChange& change, const StreamableProgram& program) const {
  return klipperChange(change, program);
}

bool KlipperFirmware::isBlocking(std::string_view command) const {
  return isExtendedCommand(command) || !isQuickCommand(command);
}

std::vector<std::string> KlipperFirmware::switchOff(const std::string&) const { return {"TURN_OFF_HEATERS"}; }

/// Klipper looks for M112 only while it keeps fewer than twenty lines, this one included, and then reads no
/// more; a few are left for whoever else speaks to it.
std::size_t KlipperFirmware::mostUnanswered() const { return 16; }

std::string KlipperFirmware::afterHalt() const {
  return "Klipper in shutdown has its microcontroller switch heaters and motors off, which it does not "
         "confirm";
}

std::string KlipperFirmware::reasonOfHalt() const { return kState; }

std::string KlipperFirmware::afterRestart() const {
  return "Klipper that starts anew has its microcontroller switch heaters and motors off, which it does not "
         "confirm";
}

}  // namespace lamina
