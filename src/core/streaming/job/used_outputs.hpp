// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The heaters, fans, lasers and spindles that a program has switched on, so that a safe stop reaches each.
/// Reads G-code that Marlin, RepRapFirmware and Klipper share. What a stop turns off in any case, the active
/// tool's heater and the bed, is not kept.
class UsedOutputs {
 public:
  /// @param command  that is sent
  void see(std::string_view command);

  /// Turns laser and spindle off ("M5"); empty if none was on.
  std::vector<std::string> beamOff() const;
  /// Turns the heaters of other tools, the chamber's and the laser's cooler off.
  std::vector<std::string> heatOff() const;
  /// Turns fans and coolant off.
  std::vector<std::string> airOff() const;

 private:
  bool has_beam_ = false;
  bool has_chamber_ = false;
  bool has_laser_cooler_ = false;
  bool has_coolant_ = false;
  std::set<int> heated_tools_;
  std::set<int> fans_;
  int tool_ = 0;
};

}  // namespace lamina
