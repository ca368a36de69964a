// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/streamable_program.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr int kLongestLine = 96;

StreamableProgram program(const std::string& text) {
  return StreamableProgram::fromText("test", text, kLongestLine);
}

std::vector<ProgramLine> linesOf(const std::string& text) {
  std::vector<ProgramLine> lines;
  ProgramCursor cursor = program(text).open();
  while (auto line = cursor.next()) lines.push_back(*line);
  return lines;
}

/// The message with which a program is refused.
std::string refusalOf(const std::string& text) {
  try {
    program(text);
  } catch (const InvalidProgram& refused) {
    return refused.what();
  }
  return "nothing was thrown";
}

TEST(StreamableProgram, LeavesOutCommentsAndEmptyLines) {
  const auto lines = linesOf("; head\n\n  G28 ; home\r\n\t\n(a) G1 (b) X1\nM117 Hi (you)\nG4 P1");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].command, "G28");
  EXPECT_EQ(lines[1].command, "G1  X1");
  EXPECT_EQ(lines[2].command, "M117 Hi (you)");
  EXPECT_EQ(lines[3].command, "G4 P1");
}

TEST(StreamableProgram, ReportsTheLayerOfEachLine) {
  const auto lines = linesOf("G28\n;LAYER:0\nG1 X1\n;LAYER:7\nG1 X2\n;LAYER_CHANGE\nG1 X3\n");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].layer, -1);
  EXPECT_EQ(lines[1].layer, 0);
  EXPECT_EQ(lines[2].layer, 7);
  EXPECT_EQ(lines[3].layer, 8);
}

TEST(StreamableProgram, RefusesWhatFirmwareWouldMisread) {
  EXPECT_NE(refusalOf("G28\nN5 G1 X1\n").find("test line 2: \"N5 G1 X1\" has a line number"),
            std::string::npos);
  EXPECT_NE(refusalOf("G28*22\n").find("has a '*'"), std::string::npos);
  EXPECT_NE(refusalOf("G1 X\xc3\xa4\n").find("not printable ASCII"), std::string::npos);
  EXPECT_NE(refusalOf("M110 N3\n").find("sets the line number"), std::string::npos);
  EXPECT_NE(refusalOf("M117 set M110 N500 now\n").find("has 'M110' in its text"), std::string::npos);
  EXPECT_NE(refusalOf("M117 a\\b\n").find("has a '\\'"), std::string::npos);
  EXPECT_NE(refusalOf("12 monkeys\n").find("expected a command letter"), std::string::npos);
  EXPECT_NE(refusalOf("; nothing\n").find("no command"), std::string::npos);
}

TEST(StreamableProgram, RefusesALineAsSoonAsItDoesNotFitWithTheLongestNumber) {
  const std::string fits = "M117 " + std::string(96 - 17 - 5, 'x');
  EXPECT_EQ(program(fits).lines(), 1U);
  EXPECT_NE(refusalOf(fits + "x").find("is 97 bytes with line number and checksum; the machine takes 96"),
            std::string::npos);
}

TEST(StreamableProgram, RefusesMissingFilesAndFolders) {
  EXPECT_THROW(StreamableProgram::fromFile("/nowhere/at/all.gcode", kLongestLine), FileError);
  EXPECT_THROW(StreamableProgram::fromFile("/tmp", kLongestLine), FileError);
}

}  // namespace
}  // namespace lamina
