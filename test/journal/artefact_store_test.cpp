// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/artefact_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lamina/base/scratch_folder.hpp"

namespace lamina {
namespace {

using Names = std::vector<std::string>;

TEST(ArtefactStore, FindsAFileThatWasChangedAfterItWasFoundWhole) {
  const ScratchFolder folder;
  ArtefactStore store(folder.path());
  const Artefact program = store.keepText("G1 X1\n", "program", "a.gcode");
  EXPECT_EQ(store.torn({program}), Names{});
  EXPECT_EQ(store.torn({program}), Names{});
  const std::string path = store.pathOf(program);
  const auto written = std::filesystem::last_write_time(path);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  std::ofstream(path) << "G1 X2\n";
  std::filesystem::last_write_time(path, written);
  EXPECT_EQ(store.torn({program}), Names{"a.gcode"}) << "of the same size and time of writing";
  std::filesystem::remove(path);
  EXPECT_EQ(store.torn({program}), Names{"a.gcode"});
}

TEST(ArtefactStore, SaysWhichFileIsNewAndKeepsItAgainAfterItWasRemoved) {
  const ScratchFolder folder;
  ArtefactStore store(folder.path() + "/store");
  const std::string path = folder.path() + "/a.gcode";
  std::ofstream(path) << "G1 X1\n";
  const KeptFile first = store.keepFile(path, "program", "a.gcode");
  EXPECT_TRUE(first.is_new);
  EXPECT_EQ(first.artefact.bytes, 6U);
  EXPECT_FALSE(store.keepFile(path, "program", "b.gcode").is_new) << "of the same bytes and suffix";
  store.remove(first.artefact);
  EXPECT_FALSE(std::filesystem::exists(store.pathOf(first.artefact)));
  EXPECT_TRUE(store.keepFile(path, "program", "a.gcode").is_new);
  EXPECT_EQ(store.torn({first.artefact}), Names{});
}

}  // namespace
}  // namespace lamina
