// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

namespace lamina {

/// Klipper at its pseudo-terminal, as klippy/gcode.py reads and answers. Line numbers and checksums are
/// ignored. An error is sent before the ok, and the lines after it are run. A halt is a shutdown. A restart
/// forgets what was read, and is ready at once.
class EmulatedKlipper final : public EmulatedPacedFirmware {
 public:
  using EmulatedPacedFirmware::EmulatedPacedFirmware;
  /// Starts in a shutdown for that reason.
  void shutDown(const std::string& reason) { reason_ = reason; }

 private:
  Answer onLine(std::string_view line) override;
  std::string refusalOf(const std::string& command) const override;
  void halt() override;
  void restart() override;

  std::string reason_;  ///< of the shutdown; empty while ready
};

}  // namespace lamina
