// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class OutputFiles : public testing::Test {
 protected:
  OutputFiles() { std::ofstream(read_) << "precious"; }

  test::ScratchFolder folder_;
  std::string read_ = folder_.file("read.gcode");
};

TEST_F(OutputFiles, AreApartFromWhatIsRead) {
  EXPECT_NO_THROW(requireApart({folder_.file("a.gcode"), folder_.file("b.csv")}, {read_, "box", ""}));
  EXPECT_THROW(requireApart({folder_.file("a.gcode"), read_}, {"box", read_}), InvalidInput);
}

TEST_F(OutputFiles, AreFoundThroughLinksAndDots) {
  const std::string link = folder_.file("link.gcode");
  std::filesystem::create_symlink(read_, link);
  std::filesystem::create_directory_symlink(folder_.file("."), folder_.file("folder"));
  for (const std::string& name : {link, folder_.file("./read.gcode"), folder_.file("folder/read.gcode")})
    EXPECT_THROW(requireApart({name}, {read_}), InvalidInput) << name;
}

TEST_F(OutputFiles, AreApartFromEachOtherBeforeTheyAreThere) {
  std::filesystem::create_directory_symlink(folder_.file("."), folder_.file("folder"));
  EXPECT_THROW(requireApart({folder_.file("a.csv"), folder_.file("folder/a.csv")}, {}), InvalidInput);
  EXPECT_THROW(requireApart({"a.csv", "./a.csv"}, {}), InvalidInput);
  EXPECT_NO_THROW(requireApart({"", "", "a.csv", "b.csv"}, {"", ""}));
}

TEST_F(OutputFiles, AreTriedAndLeftAsTheyAre) {
  EXPECT_NO_THROW(requireWritableFile(""));
  EXPECT_NO_THROW(requireWritableFile(folder_.file("new.gcode")));
  EXPECT_NO_THROW(requireWritableFile(read_));
  EXPECT_THROW(requireWritableFile(folder_.file("missing/a.gcode")), FileError);
  EXPECT_THROW(requireWritableFile(folder_.file(".")), FileError);
  EXPECT_EQ(std::filesystem::file_size(read_), 8U) << "precious";
  EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(OutputFiles, HaveOneOfTheSuffixes) {
  EXPECT_NO_THROW(requireSuffix("a.csv", {".csv", ".json"}));
  EXPECT_NO_THROW(requireSuffix("", {".csv"}));
  for (const char* name : {"a.txt", "a", "a.csv.old", ".csv"})
    EXPECT_THROW(requireSuffix(name, {".csv", ".json"}), InvalidInput) << name;
}

}  // namespace
}  // namespace lamina
