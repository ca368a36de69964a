// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

namespace lamina {

/// Emulates Klipper at its pseudo-terminal, with the reading and answering of klippy/gcode.py. Line numbers
/// and checksums are ignored. An error is sent before the ok of its line, and later lines are still run. A
/// halt is a shutdown. After a restart what was received is discarded, and Klipper is ready at once.
class EmulatedKlipper final : public EmulatedPacedFirmware {
 public:
  using EmulatedPacedFirmware::EmulatedPacedFirmware;
  /// Puts Klipper into a shutdown for this reason.
  void shutDown(const std::string& reason) { reason_ = reason; }

 private:
  Answer onLine(std::string_view line) override;
  std::string refusalOf(const std::string& command) const override;
  void halt() override;
  void restart() override;

  std::string reason_;  ///< of the shutdown; empty while ready
};

}  // namespace lamina
