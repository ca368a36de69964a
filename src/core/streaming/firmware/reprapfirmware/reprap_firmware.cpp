// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/reprapfirmware/reprap_firmware.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "streaming/firmware/ok_paced/quick_commands.hpp"
#include "streaming/firmware/reprapfirmware/reprap_protocol.hpp"

namespace lamina {
namespace {

constexpr const char* kIdentification = "M115";
constexpr const char* kStatus = "M409 K\"state.status\"";
// Of the serial port that the question comes from: USB is its input 3, the first auxiliary port its input 4.
constexpr const char* kChecks = "M575 P{state.thisInput=3?0:(state.thisInput=4?1:2)}";

/// The string behind "result": of an answer to M409; empty if there is none.
std::string resultOf(const std::string& line) {
  constexpr std::string_view kKey = "\"result\":\"";
  const std::size_t at = line.find(kKey);
  if (line.find("\"state.status\"") == std::string::npos || at == std::string::npos) return {};
  const std::size_t begin = at + kKey.size();
  return line.substr(begin, line.find('"', begin) - begin);
}

OpeningVerdict judgeIdentity(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line.find("FIRMWARE_NAME:") == std::string::npos) continue;
    if (line.find("RepRapFirmware") != std::string::npos) return {};
    return {OpeningVerdict::Kind::Refused,
            "the machine is \"" + line +
                "\", which does not speak reprapfirmware; expected stream.firmware auto"};
  }
  return {OpeningVerdict::Kind::NotYet, "the machine answers M115 without the name of its firmware"};
}

OpeningVerdict judgeStatus(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    const std::string status = resultOf(line);
    if (status.empty()) continue;
    if (status == "idle") return {};
    const std::string why = "the machine is \"" + status + "\"; expected it to be idle";
    const bool may_pass = status == "busy" || status == "changingTool" || status == "starting";
    return {may_pass ? OpeningVerdict::Kind::NotYet : OpeningVerdict::Kind::Refused, why};
  }
  return {OpeningVerdict::Kind::NotYet,
          "the machine does not report its state (M409); expected RepRapFirmware 3"};
}

OpeningVerdict judgeChecks(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line.find("requires CRC") != std::string::npos) return {};
    if (line.find("Channel") == std::string::npos) continue;
    return {OpeningVerdict::Kind::Refused, "the link loses bytes, and the machine says \"" + line +
                                               "\"; expected \"requires CRC\" (M575 S4, or S6 for a raw "
                                               "port), for it runs damaged lines otherwise; "
                                               "or stream.link reliable"};
  }
  return {OpeningVerdict::Kind::NotYet, "the machine does not report whether it checks lines (M575)"};
}

}  // namespace

bool RepRapFirmware::isSpokenBy(std::string_view firmware_name) const {
  return firmware_name.find("RepRapFirmware") != std::string_view::npos;
}

std::string RepRapFirmware::defectOf(std::string_view command, const StreamSettings& settings) const {
  return reprapDefectOf(command, settings.max_line_bytes);
}

std::string RepRapFirmware::framed(std::uint64_t number, std::string_view command) const {
  return reprapFrame(number, command);
}

PacedReply RepRapFirmware::read(std::string_view line) const { return readReprapReply(line); }

std::vector<std::string> RepRapFirmware::opening(LinkKind link) const {
  std::vector<std::string> questions = {kIdentification, kStatus};
  if (link == LinkKind::Lossy) questions.push_back(kChecks);
  return questions;
}

OpeningVerdict RepRapFirmware::judge(const std::string& question,
                                     const std::vector<std::string>& lines) const {
  if (question == kIdentification) return judgeIdentity(lines);
  return question == kStatus ? judgeStatus(lines) : judgeChecks(lines);
}

std::string RepRapFirmware::question(std::uint64_t number, LinkKind link) const {
  return reprapQuestion(number, link);
}

ChangeCommand RepRapFirmware::changed(const LiveChange& change, const StreamableProgram&) const {
  return reprapChange(change);
}

bool RepRapFirmware::isBlocking(std::string_view command) const { return !isQuickCommand(command); }

/// All tools that the last report names: M104 reaches the one in use only.
std::vector<std::string> RepRapFirmware::switchOff(const std::string& temperatures) const {
  std::vector<std::string> commands = {"M5", "M140 S0", "M141 S0", "M104 S0", "M568 P0 A0"};
  for (std::size_t at = temperatures.find('T'); at != std::string::npos;
       at = temperatures.find('T', at + 1)) {
    const int tool = std::atoi(temperatures.c_str() + at + 1);
    if (tool > 0) commands.push_back("M568 P" + std::to_string(tool) + " A0");
  }
  return commands;
}

std::string RepRapFirmware::afterHalt() const {
  return "a halted RepRapFirmware has switched its heaters and motors off, and takes nothing until it is "
         "reset";
}

std::string RepRapFirmware::reasonOfHalt() const { return {}; }

std::string RepRapFirmware::afterRestart() const { return {}; }

}  // namespace lamina
