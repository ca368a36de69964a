// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a robot's program states besides its toolpath: how the process is switched, and external axes.
struct StatedEquipment {
  /// Outputs, schedules or data of arcs, weaves of the controller, process values with their outputs, and
  /// waits for the process; each once, as text: "output 1".
  std::set<std::string> process;
  /// Values of the external axes at the first move of the part [mm, deg]; empty for none.
  std::vector<double> external;
  bool moves_external = false;  ///< whether external axes have other values at other moves
  std::string bed_carrier;      ///< what moves the bed; empty if it stands still
};

/// A toolpath as read from a program, and what else the program states.
struct EquippedToolpath {
  Toolpath toolpath;
  StatedEquipment equipment;
};

/// Checks that a program to be written has the equipment of the program from which it was read.
/// @param program  name of the program that was read, for errors
/// @param keys  settings by which it is written: "robot_program.*"
/// @throws InvalidInput naming what was found and what would be written, if external axes, the carrier of the
///   bed, or the switching of the process differ
void requireSameEquipment(const StatedEquipment& read, const StatedEquipment& written,
                          const std::string& program, const std::string& keys);

}  // namespace lamina
