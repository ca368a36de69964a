// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

void writeWhole(const std::string& path, const std::string& bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

std::string everyByte() {
  std::string bytes;
  for (int i = 0; i < 256 * 1024; ++i) bytes.push_back(static_cast<char>(i));
  return bytes;
}

TEST(AtomicFile, HoldsWhatWasWrittenAfterCommit) {
  const test::ScratchFolder folder;
  writeWhole(folder.file("a"), everyByte());
  EXPECT_EQ(readFile(folder.file("a")), everyByte());
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(AtomicFile, MayBeEmpty) {
  const test::ScratchFolder folder;
  writeWhole(folder.file("a"), "");
  EXPECT_EQ(readFile(folder.file("a")), "");
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit) {
  const test::ScratchFolder folder;
  {
    AtomicFile file(folder.file("a"));
    file.write("half");
  }
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(AtomicFile, LeavesAnExistingFileUntouchedUntilCommit) {
  const test::ScratchFolder folder;
  writeWhole(folder.file("a"), "old");
  {
    AtomicFile file(folder.file("a"));
    file.write("new");
    EXPECT_EQ(readFile(folder.file("a")), "old");
  }
  EXPECT_EQ(readFile(folder.file("a")), "old");
  writeWhole(folder.file("a"), "new");
  EXPECT_EQ(readFile(folder.file("a")), "new");
}

TEST(AtomicFile, TakesWhatALibraryWroteUnderTheTemporaryName) {
  const test::ScratchFolder folder;
  AtomicFile file(folder.file("a"));
  std::FILE* other = std::fopen(file.temporaryPath().c_str(), "wb");
  ASSERT_NE(other, nullptr);
  std::fputs("theirs", other);
  std::fclose(other);
  file.commit();
  EXPECT_EQ(readFile(folder.file("a")), "theirs");
}

TEST(AtomicFile, HasATemporaryNameThatIsAnotherEachTime) {
  const test::ScratchFolder folder;
  const AtomicFile first(folder.file("a"));
  const AtomicFile second(folder.file("a"));
  EXPECT_NE(first.temporaryPath(), second.temporaryPath());
}

TEST(AtomicFile, WritesToWhatALinkOfOnesOwnNames) {
  const test::ScratchFolder folder;
  writeWhole(folder.file("target"), "before");
  std::filesystem::create_symlink("target", folder.file("link"));
  std::filesystem::create_symlink(folder.file("link"), folder.file("chain"));
  std::filesystem::create_symlink(folder.file("missing"), folder.file("dangling"));
  writeWhole(folder.file("chain"), "after");
  writeWhole(folder.file("dangling"), "new");
  for (const char* link : {"link", "chain", "dangling"})
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file(link))) << link;
  EXPECT_EQ(readFile(folder.file("target")), "after");
  EXPECT_EQ(readFile(folder.file("missing")), "new");
}

/// In a folder that others may write to, somebody may have linked it to a file of ours.
TEST(AtomicFile, ReplacesALinkOfAnotherAndLeavesWhatItLedTo) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a link of another's";
  const test::ScratchFolder folder;
  writeWhole(folder.file("precious"), "precious");
  std::filesystem::create_symlink(folder.file("precious"), folder.file("a"));
  constexpr uid_t kNobody = 65534;
  ASSERT_EQ(::lchown(folder.file("a").c_str(), kNobody, kNobody), 0);
  writeWhole(folder.file("a"), "new");
  EXPECT_EQ(readFile(folder.file("precious")), "precious");
  EXPECT_EQ(readFile(folder.file("a")), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(folder.file("a")));
}

TEST(AtomicFile, MayBeReadByThoseWhomTheMaskOfTheProcessLets) {
  const test::ScratchFolder folder;
  const mode_t before = ::umask(027);
  writeWhole(folder.file("a"), "");
  ::umask(before);
  EXPECT_EQ(std::filesystem::status(folder.file("a")).permissions(),
            static_cast<std::filesystem::perms>(0640));
}

TEST(AtomicFile, InAFolderThatIsMissingIsRefusedNamingThePath) {
  const test::ScratchFolder folder;
  try {
    AtomicFile file(folder.file("missing/a"));
    FAIL() << "nothing thrown";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a"), std::string::npos) << error.what();
  }
}

TEST(AtomicFile, CannotReplaceAFolder) {
  const test::ScratchFolder folder;
  std::filesystem::create_directory(folder.file("a"));
  EXPECT_THROW(writeWhole(folder.file("a"), "x"), FileError);
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("a")));
  try {
    writeFile(folder.file("a"), "text");
    ADD_FAILURE() << "written over a folder";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "cannot write '" + folder.file("a") + "': it is a folder; expected the name of a file");
  }
  EXPECT_EQ(folder.fileCount(), 1U);
}

/// Root may rename a file over /dev/null, which every other process then writes into.
TEST(AtomicFile, TakesThePlaceOfNoDevicePipeOrFolder) {
  const test::ScratchFolder folder;
  const auto refusal = [](const std::string& path) -> std::string {
    try {
      const AtomicFile file(path);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder.file("link"));
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_EQ(refusal("/dev/null"), "cannot write '/dev/null': it is a device; expected the name of a file");
  for (const char* name : {"pipe", "link"})
    EXPECT_EQ(refusal(folder.file(name)),
              "cannot write '" + folder.file("pipe") + "': it is a pipe; expected the name of a file");
  EXPECT_EQ(refusal(folder.file("folder")),
            "cannot write '" + folder.file("folder") + "': it is a folder; expected the name of a file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_TRUE(std::filesystem::is_fifo(folder.file("pipe")));
  EXPECT_EQ(folder.fileCount(), 3U);
}

TEST(ReadTextFile, LeavesOutTheMarkOfUtf8AndRefusesUtf16) {
  const test::ScratchFolder folder;
  writeFile(folder.file("marked"), "\xEF\xBB\xBFG28\r\n");
  writeFile(folder.file("plain"), "G28\n");
  writeFile(folder.file("wide"), std::string("\xFF\xFEG\0", 4));
  EXPECT_EQ(readTextFile(folder.file("marked")), "G28\r\n");
  EXPECT_EQ(readFile(folder.file("marked")).size(), 8U);
  EXPECT_EQ(readTextFile(folder.file("plain")), "G28\n");
  try {
    readTextFile(folder.file("wide"));
    ADD_FAILURE() << "UTF-16 was taken";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot read '" + folder.file("wide") +
                                             "': it is text in UTF-16; expected UTF-8, as editors save it");
  }
}

TEST(ReadFile, RefusesAFolderAndAMissingFile) {
  const test::ScratchFolder folder;
  EXPECT_THROW(readFile(folder.file("missing")), FileError);
  EXPECT_THROW(readFile(folder.file(".")), FileError);
}

}  // namespace
}  // namespace lamina
