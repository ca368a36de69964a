// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace lamina {

/// The path of a file that is named by another one, in the folder of that one. Where there is none, what was
/// named: a parametric part, or a file that is found from elsewhere.
/// @param folder  of the file that names the other one; empty for that of the process
inline std::string fileBeside(const std::string& folder, const std::string& named) {
  if (folder.empty()) return named;
  const std::string beside = (std::filesystem::path(folder) / named).lexically_normal().string();
  std::error_code unreachable;
  return std::filesystem::exists(beside, unreachable) ? beside : named;
}

}  // namespace lamina
