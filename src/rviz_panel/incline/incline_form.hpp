// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What a person fills in to have a program inclined; lengths in mm on the bed.
struct InclineForm {
  std::string source;
  std::string output;  ///< empty for the default beside the source
  double angle_deg = 45.0;
  std::string axis = "x";  ///< x, y, z, or three numbers with commas between them
  std::string machine;     ///< whose limits hold; empty for what the node is configured for
  std::string begin_code;
  std::string end_code;
  std::vector<double> table_position_mm;  ///< x, y of the part's middle; empty leaves it where it is
  std::vector<double> final_position_mm;  ///< x, y, z of the nozzle; empty leaves it where it is
  bool drops_build_aids = false;          ///< skirt, brim, raft, support and priming tower
};

/// The least and the greatest angle of the form [deg]; the other sense is the opposite axis.
inline constexpr double kLeastInclination = 0.0;
inline constexpr double kGreatestInclination = 90.0;

/// What is asked of the node.
struct InclineRequest {
  std::string program;
  std::string output;
  std::vector<SettingText> settings;
};

/// @throws InvalidInput if there is no source, source or output do not end in .gcode, or they are the same
/// @throws InvalidConfig if angle or axis are none
InclineRequest requestOf(const InclineForm& form);

/// The default output of a source; empty if the source does not end in .gcode.
std::string outputFor(const std::string& source);

/// Every field as text, in the order of the form: what is saved of it.
std::vector<SettingText> textsOf(const InclineForm& form);

/// The form that was saved. Absent keys leave the default.
/// @throws InvalidConfig if a key is unknown or a text does not fit
InclineForm formFrom(const std::vector<SettingText>& texts);

}  // namespace lamina
