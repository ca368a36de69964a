// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(ScratchFolderTest, IsThereWhileItLives) {
  std::string path;
  {
    const ScratchFolder folder;
    path = folder.path();
    EXPECT_TRUE(std::filesystem::is_directory(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolderTest, IsMadeNowhereElseIfTheTemporaryFolderIsNotThere) {
  const char* found = ::getenv("TMPDIR");
  const std::string before = found != nullptr ? found : "";
  ::setenv("TMPDIR", "/no/such/folder", 1);
  EXPECT_THROW(ScratchFolder(), FileError);
  before.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before.c_str(), 1);
}

}  // namespace
}  // namespace lamina
