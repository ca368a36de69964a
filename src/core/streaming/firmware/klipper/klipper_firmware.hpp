// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// The protocol of Klipper at its pseudo-terminal. Klipper ignores line numbers and checksums, so lines are
/// sent without them.
class KlipperFirmware final : public OkPacedFirmware {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;

  std::string framed(std::uint64_t number, std::string_view command) const override;
  PacedReply read(std::string_view line) const override;
  std::vector<std::string> opening(LinkKind link) const override;
  OpeningVerdict judge(const std::string& question, const std::vector<std::string>& lines) const override;
  std::string question(std::uint64_t number, LinkKind link) const override;
  ChangeCommand changed(const LiveChange& change, const StreamableProgram& program) const override;
  bool isBlocking(std::string_view command) const override;
  bool detectsDamage() const override { return false; }
  std::string resumption() const override { return "RESUME"; }
  std::vector<std::string> switchOff(const std::string& temperatures) const override;
  std::string emergencyStop() const override { return "M112"; }
  std::size_t mostUnanswered() const override;
  std::string afterHalt() const override;
  std::string reasonOfHalt() const override;
  std::string afterRestart() const override;
};

}  // namespace lamina
