// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// Where the packages of a description are looked for.
class PackagePath {
 public:
  /// @param packages     folders that are searched first
  /// @param description  path of the file whose names are resolved
  PackagePath(const std::vector<std::string>& packages, const std::string& description);

  /// Folder of a package, absolute; nothing if there is none of that name.
  std::optional<std::string> package(const std::string& name) const;

  /// Absolute path of what `package://`, `file://`, an absolute or a relative name stands for.
  /// @return nothing if its package is not found; whether there is such a file is not looked at
  std::optional<std::string> resolved(const std::string& name) const;

  /// The folders searched.
  const std::vector<std::string>& folders() const { return folders_; }

 private:
  std::string own_folder_;
  std::vector<std::string> folders_;
};

}  // namespace lamina
