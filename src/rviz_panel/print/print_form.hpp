// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What a person fills in to have a part sliced and printed.
struct PrintForm {
  std::string part;      ///< mesh file, parametric part as in `lamina part`, or a program ready to print
  std::string program;   ///< G-code to write; empty for the default beside the part
  std::string machine;   ///< profile or machine; empty for what the node is configured for
  std::string material;  ///< profile; empty for none
  std::string process;   ///< the same
  std::string settings;  ///< lines of `key = value`, as YAML and command line name them; # begins a comment
};

/// What is asked of the node that slices.
struct SliceRequest {
  std::string part;
  std::string program;
  std::vector<SettingText> settings;
};

/// What profiles and settings set is asked for, setting by setting; all else is as the node has it.
/// @throws InvalidInput if there is no part, no program to write or it is not .gcode, or a line of the
///         settings has no `=`
/// @throws InvalidConfig if there is no such profile or setting, or the machine cannot do what is asked
SliceRequest requestOf(const PrintForm& form);

/// Whether what was chosen is a program already, which needs no slicing.
bool isProgram(const std::string& part);

/// The program that is printed: the one chosen, the one to write, or the default beside a mesh file. Empty
/// for a parametric part without one.
std::string programOf(const PrintForm& form);

/// Every field as text, in the order of the form: what is saved of it.
std::vector<SettingText> textsOf(const PrintForm& form);

/// The form that was saved. Absent keys leave the default.
/// @throws InvalidConfig if a key is unknown
PrintForm printFormFrom(const std::vector<SettingText>& texts);

/// A duration as people say it: "1 h 12 min", "12 min 5 s", "5 s".
std::string durationText(double seconds);

}  // namespace lamina
