// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The heaters, fans, lasers and spindles that a program has switched on, so that a safe stop switches them
/// off. It reads the G-code that Marlin, RepRapFirmware and Klipper share. The bed is
/// left out, since every stop switches it off, and so is the heater of a program that names no tool.
class UsedOutputs {
 public:
  /// Evaluates a command that is sent.
  void see(std::string_view command);

  /// Commands that switch off laser and spindle ("M5"); empty if none was on.
  std::vector<std::string> beamOff() const;
  /// Commands that switch off the heaters of all tools that the program has heated, if it names tools, and of
  /// the chamber, and the cooler of the laser.
  std::vector<std::string> heatOff() const;
  /// Commands that switch off fans and coolant.
  std::vector<std::string> airOff() const;

 private:
  bool has_beam_ = false;
  bool has_chamber_ = false;
  bool has_laser_cooler_ = false;
  bool has_coolant_ = false;
  std::set<int> heated_tools_;
  std::set<int> fans_;
  int tool_ = 0;
  bool names_tools_ = false;  ///< by commands or words T
};

}  // namespace lamina
