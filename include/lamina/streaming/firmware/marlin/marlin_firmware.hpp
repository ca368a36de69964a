// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/streaming/firmware/firmware_protocol.hpp"

namespace lamina {

/// Marlin 2. One that speaks nearly so overrides what differs.
class MarlinFirmware : public FirmwareProtocol {
 public:
  std::string framed(std::uint64_t number, std::string_view command) const override;
  MarlinReply read(std::string_view line) const override;
  std::string identification() const override;
  bool isSpokenBy(std::string_view firmware_name) const override;
  std::string numberedFrom(std::uint64_t number) const override;
  std::string harmless() const override;
  std::string endOfMotions() const override;
  std::string reportPosition(int interval_s) const override;
  std::string reportTemperatures(int interval_s) const override;
  bool isBlocking(std::string_view command) const override;
  std::vector<std::string> interruption() const override;
  std::vector<std::string> stop() const override;
  std::vector<std::string> heatersOff() const override;
};

}  // namespace lamina
