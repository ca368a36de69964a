// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/profiles/profile.hpp"

namespace lamina {

/// Folders in which profiles are searched, in this order, each with subfolders `machines`, `materials` and
/// `processes`: those listed in the environment variable LAMINA_PROFILES, separated by colons; the user's own
/// folder (`lamina/profiles` in XDG_CONFIG_HOME or ~/.config); and the folder installed with Lamina.
/// @throws InvalidConfig if LAMINA_PROFILES lists something that is not a folder
std::vector<std::string> profileFolders();

/// Profiles by name: each is the file `machines/<name>.yaml`, `materials/<name>.yaml` or
/// `processes/<name>.yaml` in the first folder that has it.
class ProfileLibrary {
 public:
  explicit ProfileLibrary(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  /// Names of all profiles of a kind, in alphabetical order, each once.
  std::vector<std::string> names(ProfileKind kind) const;
  bool has(ProfileKind kind, const std::string& name) const { return !pathOf(kind, name).empty(); }

  /// A profile and all those it inherits from, the most distant ancestor first.
  /// @param name  name of a profile, or path of its file (.yaml)
  /// @throws InvalidConfig if there is none, naming the existing profiles; naming the file, if a profile is
  ///   of another kind, has another name than its file, or inherits from itself
  /// @throws as `readProfile`
  std::vector<Profile> find(ProfileKind kind, const std::string& name) const;

 private:
  std::string pathOf(ProfileKind kind, const std::string& name) const;

  std::vector<std::string> folders_;
};

}  // namespace lamina
