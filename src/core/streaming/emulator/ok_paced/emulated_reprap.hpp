// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

namespace lamina {

/// Emulates RepRapFirmware 3 in its emulation of Marlin, with the reading of lines of
/// GCodeBuffer/StringParser. Only numbered lines have a checksum: one to three digits are an exclusive or,
/// five digits the CRC-16. A line with a wrong checksum, or without a required one, is dropped without an
/// answer. The position is the end of the last motion accepted.
class EmulatedRepRap final : public EmulatedPacedFirmware {
 public:
  /// Which checksums the firmware checks (M575 S0, S4).
  enum class Checks : std::uint8_t { IfThere, RequiresCrc };

  EmulatedRepRap(const PacedFaults& faults, Checks checks, Observer observer)
      : EmulatedPacedFirmware(faults, std::move(observer)), checks_(checks) {}
  /// The state that M409 reports: "idle".
  void setStatus(const std::string& status) { status_ = status; }

 private:
  Answer onLine(std::string_view line) override;
  Answer obey(const std::string& command);
  std::string refusalOf(const std::string& command) const override;
  void halt() override;
  void restart() override;
  std::string echoed(const std::string& expressions) const;
  void follow(const std::string& command);

  Checks checks_;
  std::string status_ = "idle";
  std::array<double, 4> at_{};  ///< X, Y, Z, and the filament position
  bool is_relative_ = false;
  bool is_filament_relative_ = false;
};

}  // namespace lamina
