// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/artefact_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
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

// As a folder whose disk or host fails, or that may not be searched, which root may always.
TEST(ArtefactStore, SaysWhatFailsWhereItsFolderCannotBeSearched) {
  const ScratchFolder folder;
  const std::string place = folder.path() + "/store";
  ArtefactStore store(place);
  const std::string path = folder.path() + "/a.gcode";
  std::ofstream(path) << "G1 X1\n";
  std::filesystem::remove(place);
  std::filesystem::create_symlink(place, place);
  const std::string why = "Too many levels of symbolic links";
  const auto refusalOf = [](const auto& call) {
    try {
      call();
      return std::string("none");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  const std::string of_text = refusalOf([&] { store.keepText("G1 X1\n", "program", "a.gcode"); });
  EXPECT_NE(of_text.find(place + '/'), std::string::npos) << of_text;
  EXPECT_NE(of_text.find(why), std::string::npos) << of_text;
  const std::string of_file = refusalOf([&] { store.keepFile(path, "program", "a.gcode"); });
  EXPECT_NE(of_file.find(why), std::string::npos) << of_file;
  const std::string anew = refusalOf([&] { const ArtefactStore another(place); });
  EXPECT_NE(anew.find(place + ": cannot be made"), std::string::npos) << anew;
}

}  // namespace
}  // namespace lamina
