// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

namespace lamina {

/// Klipper at its pseudo-terminal, as klippy/gcode.py reads and answers: numbers and checksums are left
/// unread; an error is said before the ok, and the lines behind it are run. A halt is a shutdown; a restart
/// forgets what was read, and is ready again at once.
class EmulatedKlipper final : public EmulatedPacedFirmware {
 public:
  using EmulatedPacedFirmware::EmulatedPacedFirmware;
  /// Not ready from the start, and why.
  void shutDown(const std::string& reason) { reason_ = reason; }

 private:
  Answer onLine(std::string_view line) override;
  std::string refusalOf(const std::string& command) const override;
  void halt() override;
  void restart() override;

  std::string reason_;  ///< of the shutdown; empty while ready
};

}  // namespace lamina
