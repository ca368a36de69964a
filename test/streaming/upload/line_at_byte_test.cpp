// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/line_at_byte.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>

#include "streaming/upload/program_body.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(LineAtByte, FindsCommandsOfAnyLengthAndTheirLayers) {
  const auto ends = std::make_shared<CommandEnds>();
  ends->add(4, -1);
  ends->add(131, 0);            // 127 bytes: the longest distance of one byte
  ends->add(259, 0);            // 128
  ends->add(16643, 1);          // 16384
  ends->add(5000000000000, 2);  // more than 32 bits
  LineAtByte line(ends);
  EXPECT_EQ(line.linesBefore(3), 0U);
  EXPECT_EQ(line.layer(), -1);
  EXPECT_EQ(line.linesBefore(131), 2U);
  EXPECT_EQ(line.layer(), 0);
  EXPECT_EQ(line.linesBefore(16642), 3U);
  EXPECT_EQ(line.linesBefore(4999999999999), 4U);
  EXPECT_EQ(line.layer(), 1);
  EXPECT_EQ(line.linesBefore(130), 1U) << "back";
  EXPECT_EQ(line.layer(), -1);
  EXPECT_EQ(line.linesBefore(std::numeric_limits<std::uint64_t>::max()), 5U);
  EXPECT_EQ(line.layer(), 2);
}

TEST(LineAtByte, NeedsNoDiskWhileAMachinePrints) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.gcode");
  std::ofstream(path) << "; a comment\nG28\n;LAYER:0\nG1 X1 ; and another\n\n;LAYER:1\nG1 X2";
  const ProgramBody body(StreamableProgram::fromFile(path));
  std::remove(path.c_str());
  LineAtByte line(body.commandEnds());
  EXPECT_EQ(line.linesBefore(15), 0U);
  EXPECT_EQ(line.linesBefore(16), 1U) << "12 bytes of comment, 4 of the command";
  EXPECT_EQ(line.linesBefore(44), 1U);
  EXPECT_EQ(line.linesBefore(45), 2U) << "9 of the layer, 20 of the command and its comment";
  EXPECT_EQ(line.layer(), 0);
  EXPECT_EQ(line.linesBefore(60), 2U);
  EXPECT_EQ(line.linesBefore(61), 3U)
      << "1 of the empty line, 9 of the layer, 6 with the line feed that it gets";
  EXPECT_EQ(line.layer(), 1);
}

}  // namespace
}  // namespace lamina
