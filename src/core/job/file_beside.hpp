// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace lamina {

/// Path of a file that another file names: in the folder of that other file if such a file exists there,
/// otherwise the name unchanged, as it may be a parametric part or a path from the working directory.
/// @param folder  of the file that holds the name; empty for the working directory
inline std::string fileBeside(const std::string& folder, const std::string& named) {
  if (folder.empty()) return named;
  const std::string beside = (std::filesystem::path(folder) / named).lexically_normal().string();
  std::error_code unreachable;
  return std::filesystem::exists(beside, unreachable) ? beside : named;
}

}  // namespace lamina
