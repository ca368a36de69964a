// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

/// The protocol of grbl 1.1, grblHAL and FluidNC: lines without number or checksum, whose characters are
/// counted, and single bytes that take effect on arrival (docs/streaming/firmware/grbl.md).
class GrblFirmware final : public FirmwareProtocol {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  /// Reports only commands that none of these firmwares accepts. What the connected machine does not support
  /// is reported by the job, before its first line.
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;
  /// True: the job finds the line at which to resume from the position of the machine.
  bool canResume() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;
};

}  // namespace lamina
