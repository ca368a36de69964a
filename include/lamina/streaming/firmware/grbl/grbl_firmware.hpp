// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

/// grbl 1.1, grblHAL and FluidNC: lines without number or checksum, counted by their characters, and bytes
/// that are obeyed as they arrive (docs/firmware/grbl.md).
class GrblFirmware final : public FirmwareProtocol {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  /// Only what none of these firmwares takes; what the very machine does not know is named by the job, before
  /// its first line.
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;
  /// By the place at which the machine stands.
  bool canResume() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;
};

}  // namespace lamina
