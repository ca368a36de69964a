// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/profiles/profile.hpp"

namespace lamina {

/// Folders with `machines`, `materials` and `processes` in them, the first counts first: those that the
/// environment's LAMINA_PROFILES names with colons between them, the user's own (`lamina/profiles` in
/// XDG_CONFIG_HOME or ~/.config), and those of Lamina, in the share beside the core library.
/// @throws InvalidConfig if LAMINA_PROFILES names what is no folder
std::vector<std::string> profileFolders();

/// Profiles by their name: each is the file `<kind>s/<name>.yaml` in the first folder that has it.
class ProfileLibrary {
 public:
  explicit ProfileLibrary(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  /// In alphabetical order, each name once.
  std::vector<std::string> names(ProfileKind kind) const;
  bool has(ProfileKind kind, const std::string& name) const { return !pathOf(kind, name).empty(); }

  /// The profile and all that it inherits from, the farthest first.
  /// @param name  of a profile, or path of its file (.yaml)
  /// @throws InvalidConfig if there is none, naming those there are; if it is of another kind or has another
  ///   name than its file, or inherits from itself, naming file and line
  std::vector<Profile> find(ProfileKind kind, const std::string& name) const;

 private:
  std::string pathOf(ProfileKind kind, const std::string& name) const;

  std::vector<std::string> folders_;
};

}  // namespace lamina
