// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// The folders in which the packages of a description are searched.
class PackagePath {
 public:
  /// @param packages     folders that are searched first
  /// @param description  path of the file whose names are resolved
  PackagePath(const std::vector<std::string>& packages, const std::string& description);

  /// Folder of a package, absolute; nothing if there is none of that name.
  std::optional<std::string> package(const std::string& name) const;

  /// Absolute path of the file that a name with `package://` or `file://`, an absolute path or a relative
  /// path denotes.
  /// @return nothing if the package is not found; whether the file exists is not checked
  std::optional<std::string> resolved(const std::string& name) const;

  /// The folders searched.
  const std::vector<std::string>& folders() const { return folders_; }

 private:
  std::string own_folder_;
  std::vector<std::string> folders_;
};

}  // namespace lamina
