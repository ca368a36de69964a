// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/streamable_program.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "streaming/job/change_commands.hpp"
#include "support/scoped_entry.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

StreamSettings toMarlin() {
  StreamSettings settings;
  settings.firmware = "marlin";
  return settings;
}

StreamableProgram program(const std::string& text) {
  return StreamableProgram::fromText("test", text, toMarlin());
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

TEST(StreamableProgram, SendsNoMarkOfUtf8) {
  const auto program = StreamableProgram::fromText("test", "\xEF\xBB\xBFG28\nG1 X1\n", toMarlin());
  ProgramCursor cursor = program.open();
  EXPECT_EQ(cursor.next()->command, "G28");
  EXPECT_EQ(cursor.bytesRead(), 7U);
  const auto begun = StreamableProgram::fromText("test", "\xEF\xBB\xBF; from Windows\nG28\n", toMarlin());
  EXPECT_EQ(begun.open().next()->command, "G28");
}

TEST(StreamableProgram, KeepsParenthesesOfExpressionsAndQuotes) {
  const auto lines = linesOf(
      "G1 X{(1 + 2) / 3} (aside) F{600}\nM291 P\"a (b)\" S2 (c)\nG1 X1 (a { b) Y2\nG1 (5\" nozzle) X3\n");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].command, "G1 X{(1 + 2) / 3}  F{600}");
  EXPECT_EQ(lines[1].command, "M291 P\"a (b)\" S2");
  EXPECT_EQ(lines[2].command, "G1 X1  Y2");
  EXPECT_EQ(lines[3].command, "G1  X3");
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
  EXPECT_NE(refusalOf("G28*22\n").find("has a '*'"), std::string::npos);
  EXPECT_NE(refusalOf("G1 X\xc3\xa4\n").find("not printable ASCII"), std::string::npos);
  EXPECT_NE(refusalOf("M110 N3\n").find("sets the line number"), std::string::npos);
  EXPECT_NE(refusalOf("M117 set M110 N500 now\n").find("has 'M110' in its text"), std::string::npos);
  EXPECT_NE(refusalOf("M117 a\\b\n").find("has a '\\'"), std::string::npos);
  EXPECT_NE(refusalOf("12 monkeys\n").find("expected a command letter"), std::string::npos);
  EXPECT_NE(refusalOf("START_PRINT BED=60\n").find("is a macro's name"), std::string::npos);
  EXPECT_NE(refusalOf("N5 G1 X1*12\n").find("has a '*'"), std::string::npos) << "its checksum is wrong";
  EXPECT_NE(refusalOf("; nothing\n").find("no command"), std::string::npos);
}

TEST(StreamableProgram, IsNoBinaryFile) {
  EXPECT_THROW(program(std::string("GCDE\x01\x00\x00\x00", 8)), FileError);
  EXPECT_THROW(program("PK\x03\x04"), FileError);
  EXPECT_THROW(program(std::string("\xFF\xFEG\x00", 4)), FileError);
}

/// Marlin runs "G1 x5 Y2" as a motion of Y alone, "G28 xy" for all axes, and of "G21 G90" the first, and says
/// ok; "g28" it does not know.
TEST(StreamableProgram, RefusesWordsThatMarlinPassesOver) {
  for (const char* text : {"g28\n", "m104 S200\n", "t1\n"})
    EXPECT_NE(refusalOf(text).find("begins with a small letter"), std::string::npos) << text;
  for (const char* text : {"G1 x5 Y2\n", "G1 X5y2\n", "G28 x\n", "G92 e0\n", "M104 s200\n", "G28 xy\n",
                           "G28 Xy\n", "G28 xyz ; all\n", "G28 x // home\n"})
    EXPECT_NE(refusalOf(text).find("has a word with a small letter"), std::string::npos) << text;
  for (const char* text : {"G21 G90\n", "G0 G90 X10\n", "G90G1X5\n", "G1 X5 M3\n", "M104 S0 M140 S0\n",
                           "M106 S0 M140 S0\n", "M104 S200 G28\n"})
    EXPECT_NE(refusalOf(text).find("has a second command"), std::string::npos) << text;
}

/// Marlin's numbers end at an E, which begins a word of its own: "X1E-05" moves X by 1.
TEST(StreamableProgram, RefusesNumbersWithAnExponent) {
  for (const char* text : {"G1 X1e-3\n", "G1 X1.e-3 Y2\n", "G1X2Y1.5e+2F600\n", "G1 X1E-05 Y20\n",
                           "G1 X5 Y1.0E-5\n", "M221 S1e2\n"})
    EXPECT_NE(refusalOf(text).find("has a number with an exponent; expected a plain decimal"),
              std::string::npos)
        << text;
  EXPECT_EQ(
      program("G1X1E-3\nG1 X5Y3E-2\nG1 X5E-.2\nG1 X5E2\nG1 F1800 E-2\nG1 X5E-2F900\nG1 F1800E-2\n").lines(),
      7U)
      << "words without blanks";
}

TEST(StreamableProgram, TakesTextBehindASlashOrAHash) {
  EXPECT_EQ(program("G28 // home x and y\nG4 P500 # wait a bit\nG1 X5 // then the other\n").lines(), 3U);
}

// Marlin ends a line at semicolons alone.
TEST(StreamableProgram, RefusesWordsBehindASlashOrAHash) {
  for (const char* text :
       {"G0 X100 // G1 Z0\n", "M104 S0 # G4 S60\n", "G28 // home X\n", "G1 X5 # then Y6\n"})
    EXPECT_NE(refusalOf(text).find(", which Marlin runs; expected comments behind ';'"), std::string::npos)
        << text;
}

TEST(StreamableProgram, TakesSmallLettersOfTextsAndTheCommandBehindG53) {
  const StreamableProgram taken = program(
      "M117 g1 x5\nM0 look at it\nM23 part.g\nM486 Apart x1\nM862.3 P \"MK3S m1\"\nG53 G1 X5\nM42 P4 S1 M1\n"
      "G28 X Y\nG1X-5.5Y.5E1F600\nG29 P1\nM104 T1 S200\n");
  EXPECT_EQ(taken.lines(), 11U);
}

TEST(StreamableProgram, TakesTheToolThatAMultiMaterialUnitAsksFor) {
  EXPECT_EQ(program("Tx\nTc\nT?\nT2\n").lines(), 4U);
  EXPECT_NE(refusalOf("TOOL=2\n").find("is a macro's name"), std::string::npos);
}

TEST(StreamableProgram, QuotesNothingBeforeAPlainCommand) {
  EXPECT_EQ(refusalOf("root:$6$SECRET*\n").find("SECRET"), std::string::npos);
  EXPECT_EQ(refusalOf("M117 SECRET\n12 SECRET\n").find("SECRET"), std::string::npos);
  EXPECT_NE(refusalOf("M104 S200\n12 monkeys\n").find("test line 2: '12 monkeys'"), std::string::npos);
}

TEST(StreamableProgram, RefusesALineAsSoonAsItDoesNotFitWithItsNumber) {
  const std::string fits = "M117 " + std::string(96 - 14 - 5, 'x');
  EXPECT_EQ(program(fits).lines(), 1U);
  EXPECT_NE(refusalOf(fits + "x").find("is 97 bytes with line number and checksum; the machine takes 96"),
            std::string::npos);
  StreamSettings longer = toMarlin();
  longer.max_line_bytes = 97;
  EXPECT_EQ(StreamableProgram::fromText("test", fits + "x", longer).lines(), 1U);
}

TEST(StreamableProgram, LeavesOutNumbersChecksumsAndTapeMarks) {
  // 'N' ^ '5' ^ ' ' ^ 'G' ^ '1' ^ ' ' ^ 'X' ^ '1' is 100
  const auto lines = linesOf("%\nN5 G1 X1*100\nn10G1 X2\nN20\n%\n");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].command, "G1 X1");
  EXPECT_EQ(lines[1].command, "G1 X2");
}

TEST(StreamableProgram, TakesASemicolonInQuotesForText) {
  EXPECT_NE(refusalOf("G28\nM118 \"a;b\" ; said\n").find("'M118 \"a;b\"' has a ';' within quotes"),
            std::string::npos);
  const auto lines = linesOf("M117 5\" nozzle ; brass\n");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].command, "M117 5\" nozzle");
}

TEST(StreamableProgram, RefusesPrintingWhatReadsAsAnAnswer) {
  for (const char* text :
       {"M118 ok", "M118 start", "M118 P0 start", "M118 Resend: 3", "M118 !! done",
        "M118 Error:Heating failed", "M118 E1 busy: processing", "M118 FIRMWARE_NAME:X Y:1"})
    EXPECT_NE(refusalOf(std::string("G28\n") + text).find("read as its own answer"), std::string::npos)
        << text;
  for (const char* text :
       {"M118 ready to start", "M118 E1 Layer 3", "M118 A1 action:pause", "M118", "M118 okay"})
    EXPECT_EQ(program(text).lines(), 1U) << text;
}

TEST(StreamableProgram, TakesMessagesInAnyLanguage) {
  EXPECT_EQ(program("M117 h\xc3\xa9\xc3\xa9\nM118 \xe2\x9c\x93\n").lines(), 2U);
  EXPECT_NE(refusalOf("M117 a\x1b[0m\n").find("not printable"), std::string::npos);
}

/// Firmware that takes motions only.
class MotionsOnly : public MarlinFirmware {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override { return firmware_name == "Motions"; }
  std::string defectOf(std::string_view command, const StreamSettings&) const override {
    return command[0] == 'G' ? "" : "is no motion";
  }
};

TEST(StreamableProgram, IsCheckedForEachFirmwareItMayGoTo) {
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> entry(firmwareProtocols(), "motions",
                                                                         std::make_shared<MotionsOnly>());
  const auto program = StreamableProgram::fromText("test", "G1 X1\nM117 hello\n");
  EXPECT_EQ(program.defectFor("marlin"), "");
  EXPECT_EQ(program.defectFor("motions"), "test line 2: 'M117 hello' is no motion");
  Streamer streamer(program, {});
  streamer.start(0.0);
  streamer.takeOutput();
  streamer.receive("FIRMWARE_NAME:Motions\nok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), "");
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.message, program.defectFor("motions"));
}

TEST(StreamableProgram, RefusesMissingFilesAndFolders) {
  EXPECT_THROW(StreamableProgram::fromFile("/nowhere/at/all.gcode"), FileError);
  const test::ScratchFolder folder;
  EXPECT_THROW(StreamableProgram::fromFile(folder.file("")), FileError);
}

TEST(StreamableProgram, KnowsItsPartsWithoutItsFile) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("parts.gcode");
  std::ofstream(path) << "EXCLUDE_OBJECT_DEFINE NAME=left CENTER=1,1\nEXCLUDE_OBJECT_DEFINE CENTER=2,2\n"
                         "EXCLUDE_OBJECT_DEFINE NAME=right\nEXCLUDE_OBJECT_START NAME=left\nG1 X1\n"
                         "EXCLUDE_OBJECT_DEFINE NAME=late\n";
  const StreamableProgram program = StreamableProgram::fromFile(path);
  std::remove(path.c_str());
  EXPECT_EQ(program.definedParts(), (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(klipperChange({LiveSetting::CancelPart, 1.0}, program).command, "EXCLUDE_OBJECT NAME=right");
}

}  // namespace
}  // namespace lamina
