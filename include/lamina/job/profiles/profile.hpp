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

/// Settings under a name, as one file holds them.
struct Profile {
  ProfileKind kind = ProfileKind::Machine;
  std::string name;
  std::string about;                      ///< one line
  std::string inherits;                   ///< name of a profile of the same kind that counts before this one
  int inherits_line = 0;                  ///< where that stands
  std::vector<std::string> for_machines;  ///< that it is meant for; none for all
  std::string path;
  std::vector<PlacedSetting> settings;
};

/// Reads a profile: settings, and `profile: {kind, name, about, inherits, for_machines}`. Relative names of
/// files in it (machine.urdf) are taken from its own folder.
/// @throws FileError; InvalidConfig naming file and line if it is no YAML, has no kind or name, or its head
///   has a key that is none
Profile readProfile(const std::string& path);

}  // namespace lamina
