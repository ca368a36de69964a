// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/program_identity.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(ProgramIdentity, HasTheChecksumOfIso3309) {
  // The check value that every description of CRC-32 gives.
  EXPECT_EQ(identityOfText("", "123456789").crc32, 0xCBF43926U);
  EXPECT_EQ(identityOfText("", "").crc32, 0U);
}

TEST(ProgramIdentity, OfAFileIsThatOfItsBytes) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.gcode");
  std::string text;
  for (int i = 0; i < 200000; ++i)
    text += "G1 X" + std::to_string(i) + "\n";  // longer than what is read at once
  writeFile(path, text);
  EXPECT_TRUE(identityOfFile(path) == identityOfText(path, text));
  writeFile(path, "");
  EXPECT_EQ(identityOfFile(path).bytes, 0U);
  EXPECT_THROW(identityOfFile(folder.file("none.gcode")), FileError);
}

TEST(ProgramIdentity, ReportsAProgramThatDidNotComeWhole) {
  const ProgramIdentity arrived = identityOfText("part.gcode", "123456789");
  EXPECT_NO_THROW(requireWhole(arrived, 9, "cbf43926"));
  EXPECT_NO_THROW(requireWhole(arrived, 9, "CBF43926"));
  EXPECT_THROW(requireWhole(arrived, 10, "cbf43926"), InvalidProgram);
  EXPECT_THROW(requireWhole(arrived, 9, "cbf43927"), InvalidProgram);
  EXPECT_THROW(requireWhole(arrived, 9, ""), InvalidInput);
  EXPECT_THROW(requireWhole(arrived, 9, "cbf4392x"), InvalidInput);
}

}  // namespace
}  // namespace lamina
