// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/line_reader.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20U;

TEST(LineReader, ReadsLinesAcrossItsBufferWhole) {
  const test::ScratchFolder folder;
  std::string text;
  for (int i = 0; text.size() < 3 * kMebibyte; ++i) text += "G1 X" + std::to_string(i) + "\n";
  writeFile(folder.file("long.gcode"), text + "M84");
  LineReader reader(folder.file("long.gcode"));
  std::string read;
  while (const auto line = reader.next()) (read += *line) += '\n';
  EXPECT_EQ(read, text + "M84\n");
  EXPECT_EQ(reader.bytesRead(), text.size() + 3);
}

TEST(LineReader, LeavesOutTheMarkOfUtf8AndCountsIt) {
  const test::ScratchFolder folder;
  writeFile(folder.file("marked.gcode"), "\xEF\xBB\xBFG28\nM84\n");
  LineReader reader(folder.file("marked.gcode"));
  EXPECT_EQ(reader.next(), "G28");
  EXPECT_EQ(reader.next(), "M84");
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_EQ(reader.bytesRead(), 11U);
}

TEST(LineReader, RefusesALineThatIsNoLine) {
  const test::ScratchFolder folder;
  writeFile(folder.file("one.gcode"), "M83\n;" + std::string(kMebibyte, 'x'));
  LineReader reader(folder.file("one.gcode"));
  EXPECT_EQ(reader.next(), "M83");
  EXPECT_THROW(reader.next(), InvalidProgram);
}

}  // namespace
}  // namespace lamina
