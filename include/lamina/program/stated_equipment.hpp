// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a program for a robot states beside its toolpath: by what the process is switched, and axes besides
/// those of the arm.
struct StatedEquipment {
  /// Outputs, schedules or data of arcs, weaves of the controller, process values and their outputs, waits
  /// that are the process's own; each once, as one would name it: "output 1".
  std::set<std::string> process;
  std::vector<double> external;  ///< axes at the first move of the part [mm, deg]; empty for none
  bool moves_external = false;   ///< they stand elsewhere at other moves
  std::string bed_carrier;       ///< that moves the bed; empty where it stands still
};

/// A toolpath as a program has it, and what else that states.
struct EquippedToolpath {
  Toolpath toolpath;
  StatedEquipment equipment;
};

/// Refuses a program that is written anew with other equipment than it was read with.
/// @param program  that was read, for errors
/// @param keys  settings by which it is written: "robot_program.*"
/// @throws InvalidInput naming what was found and what would be written: external axes, what carries the bed,
///   how the process is switched
void requireSameEquipment(const StatedEquipment& read, const StatedEquipment& written,
                          const std::string& program, const std::string& keys);

}  // namespace lamina
