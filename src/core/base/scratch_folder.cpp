// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/scratch_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "lamina/base/error.hpp"

namespace lamina {

ScratchFolder::ScratchFolder() {
  std::error_code unreachable;
  const std::filesystem::path outer = std::filesystem::temp_directory_path(unreachable);
  if (unreachable) throw FileError("there is no folder for temporary files: " + unreachable.message());
  path_ = (outer / "lamina_XXXXXX").string();
  if (::mkdtemp(path_.data()) == nullptr)
    throw FileError("no folder '" + path_ + "' can be made: " + std::strerror(errno));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace lamina
