// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_yaml.hpp"

namespace lamina {

enum class ProfileKind : std::uint8_t { Machine, Material, Process };

/// "machine", "material", "process".
const char* toString(ProfileKind kind);

/// A named set of settings, as read from one file.
struct Profile {
  ProfileKind kind = ProfileKind::Machine;
  std::string name;
  std::string about;  ///< description in one line
  /// Name of a profile of the same kind whose settings this profile overrides; empty for none.
  std::string inherits;
  int inherits_line = 0;                  ///< line of the file that names the inherited profile
  std::vector<std::string> for_machines;  ///< names of machines for which the profile is meant; empty for all
  std::string path;                       ///< path of the profile's file
  std::vector<PlacedSetting> settings;
};

/// Reads a profile: settings, and `profile: {kind, name, about, inherits, for_machines}`. A relative path in
/// machine.urdf is taken from the folder of the profile.
/// @throws FileError
/// @throws InvalidConfig naming file and line if it is not YAML, lacks kind or name, or has an unknown key
///   below `profile`
Profile readProfile(const std::string& path);

}  // namespace lamina
