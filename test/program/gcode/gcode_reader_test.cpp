// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::vector<GcodeMotion> motions(std::string_view program) {
  std::vector<GcodeMotion> list;
  GcodeReader reader({}, {[&](const GcodeMotion& motion) { list.push_back(motion); }, {}, {}});
  reader.read(program);
  reader.finish();
  return list;
}

Point3 endOf(std::string_view program) { return motions(program).back().end; }

std::string gcodeReaderRefusal(std::string_view program) {
  try {
    motions(program);
    return "";
  } catch (const InvalidProgram& error) {
    return error.what();
  }
}

TEST(GcodeReader, KeepsWordsThatAreNotRepeated) {
  const auto list = motions("G1 X10 Y20 F1200\nX15\nG0 Z3\n");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].start, Point3(10, 20, 0));
  EXPECT_EQ(list[1].end, Point3(15, 20, 0));
  EXPECT_EQ(list[2].end, Point3(15, 20, 3));
  EXPECT_DOUBLE_EQ(list[2].feed_mm_s, 20.0);
  EXPECT_EQ(list[2].line, 3U);
}

TEST(GcodeReader, LeavesOutTheMarkOfUtf8BeforeItsFirstLine) {
  EXPECT_EQ(endOf("\xEF\xBB\xBFG1 X10\nX15\n"), Point3(15, 0, 0));
  EXPECT_EQ(endOf("\xEF\xBB\xBF; from Windows\nG1 X10\n"), Point3(10, 0, 0));
  EXPECT_NE(gcodeReaderRefusal("G1 X10\n\xEF\xBB\xBFG1 X15\n").find("line 2"), std::string::npos);
}

TEST(GcodeReader, AddsRelativePositions) { EXPECT_EQ(endOf("G91\nG1 X10\nG1 X10 Y5\n"), Point3(20, 5, 0)); }

TEST(GcodeReader, ReadsInches) {
  EXPECT_TRUE(endOf("G20\nG1 X1 Y.5\n").isApprox(Point3(25.4, 12.7, 0)));
  EXPECT_DOUBLE_EQ(motions("G20 G1 X1 F60\n")[0].feed_mm_s, 25.4);
  EXPECT_EQ(endOf("G20\nG1 X1\nG21\nG1 X1\n"), Point3(1, 0, 0));
}

TEST(GcodeReader, TakesExtrusionAbsoluteOrRelative) {
  const auto absolute = motions("G1 X1 E2\nG1 X2 E5\nG92 E0\nG1 X3 E1\n");
  EXPECT_DOUBLE_EQ(absolute[1].extrusion_mm, 3.0);
  EXPECT_DOUBLE_EQ(absolute[2].extrusion_mm, 1.0);
  const auto relative = motions("M83\nG1 X1 E2\nG1 X2 E5\nM82\nG1 X3 E8\n");
  EXPECT_DOUBLE_EQ(relative[1].extrusion_mm, 5.0);
  EXPECT_DOUBLE_EQ(relative[2].extrusion_mm, 1.0);
}

TEST(GcodeReader, LetsG91AndG90SetExtrusionAsMarlinDoes) {
  const auto list = motions("M82\nG1 X1 E9\nG91\nG1 E-2\nG90\nG1 X2 E8\n");
  EXPECT_DOUBLE_EQ(list[1].extrusion_mm, -2.0);
  EXPECT_DOUBLE_EQ(list[2].extrusion_mm, 1.0);
}

TEST(GcodeReader, RenamesPositionsWithoutMoving) {
  const auto list = motions("G1 X10\nG92 X0\nG1 X5\n");
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].end, Point3(15, 0, 0));
}

TEST(GcodeReader, HomesTheAxesNamed) {
  EXPECT_EQ(endOf("G1 X10 Y10 Z10\nG28 X Y\nG1 X1\n"), Point3(1, 0, 10));
  EXPECT_EQ(endOf("G1 X10 Y10 Z10\nG92 X0\nG28\nG1 X1\n"), Point3(1, 0, 0));
}

TEST(GcodeReader, FollowsAnArcWithinTheChordTolerance) {
  // Quarter circle of 10 mm about the origin.
  const auto list = motions("G1 X10\nG3 X0 Y10 I-10 J0 E4\n");
  double extrusion = 0.0;
  for (std::size_t i = 1; i < list.size(); ++i) {
    EXPECT_NEAR(list[i].end.norm(), 10.0, 1e-9);
    EXPECT_GE((0.5 * (list[i].start + list[i].end)).norm(), 10.0 - 0.01);
    extrusion += list[i].extrusion_mm;
  }
  EXPECT_GT(list.size(), 10U);
  EXPECT_NEAR(extrusion, 4.0, 1e-12);
  EXPECT_EQ(list.back().end, Point3(0, 10, 0));
}

double travelled(const std::vector<GcodeMotion>& list, std::size_t first) {
  double sum = 0.0;
  for (std::size_t i = first; i < list.size(); ++i) sum += (list[i].end - list[i].start).norm();
  return sum;
}

TEST(GcodeReader, TakesTheSideOfArcsFromDirectionAndRadius) {
  constexpr double kChords = 0.1;  // mm lost to chords
  EXPECT_NEAR(travelled(motions("G1 X10\nG3 X0 Y10 R10\n"), 1), 5 * M_PI, kChords);
  EXPECT_NEAR(travelled(motions("G1 X10\nG2 X0 Y10 R-10\n"), 1), 15 * M_PI, kChords);
  EXPECT_NEAR(travelled(motions("G1 X10\nG2 X0 Y10 I-10\n"), 1), 15 * M_PI, kChords);
  EXPECT_NEAR(travelled(motions("G1 X10\nG2 I-10\n"), 1), 20 * M_PI, kChords);
}

TEST(GcodeReader, ClimbsAHelixInAnyPlane) {
  EXPECT_NEAR(travelled(motions("G3 I5 Z10\n"), 0), std::hypot(10 * M_PI, 10.0), 0.1);
  EXPECT_NEAR(travelled(motions("G18\nG2 X10 I5 Y3\n"), 0), std::hypot(5 * M_PI, 3.0), 0.1);
  const auto yz = motions("G19\nG3 Y10 J5\n");
  EXPECT_LT(yz[yz.size() / 2].end.z(), -4.0);
  const auto zx = motions("G18\nG3 X10 I5\n");
  EXPECT_GT(zx[zx.size() / 2].end.z(), 4.0);
}

TEST(GcodeReader, PassesOverCommentsLineNumbersAndChecksums) {
  // The exclusive or of the bytes of "N3 G1 X7" is 82.
  unsigned checksum = 0;
  for (const char c : std::string("N3 G1 X7")) checksum ^= static_cast<unsigned char>(c);
  EXPECT_EQ(endOf("N3 G1 X7*" + std::to_string(checksum) + " ; far\n"), Point3(7, 0, 0));
  EXPECT_EQ(endOf("(first) g1 (to (x) x4 y 2 ; G1 X9\r\n"), Point3(4, 2, 0));
  EXPECT_EQ(endOf("G1 X3"), Point3(3, 0, 0));
}

TEST(GcodeReader, HandsOnWhatItDoesNotKnow) {
  std::vector<std::string> others;
  double dwelt = 0.0;
  GcodeReader reader({}, {{},
                          [&](std::size_t, double seconds) { dwelt += seconds; },
                          [&](std::size_t, std::string_view command) { others.emplace_back(command); }});
  reader.read("M104 S200 ; hot\nT1\nM117 (50% done\nSTART_PRINT BED=60\nG4 P1500\nG4 S2\nG28\n");
  const std::vector<std::string> expected = {"M104 S200", "T1", "M117 (50% done", "START_PRINT BED=60",
                                             "G28"};
  EXPECT_EQ(others, expected);
  EXPECT_DOUBLE_EQ(dwelt, 3.5);
}

TEST(GcodeReader, ReadsTheSameInPiecesOfAnySize) {
  const std::string program = "G1 X10 Y20 F1200\nX15 (a)\nG2 X20 I2.5 ; arc\nG91 G1 Z1\n";
  const auto whole = motions(program);
  for (std::size_t size = 1; size < program.size(); ++size) {
    std::size_t count = 0;
    GcodeReader reader(
        {}, {[&](const GcodeMotion& motion) { EXPECT_EQ(motion.end, whole[count++].end); }, {}, {}});
    for (std::size_t at = 0; at < program.size(); at += size)
      reader.read(std::string_view(program).substr(at, size));
    reader.finish();
    EXPECT_EQ(count, whole.size());
  }
}

TEST(GcodeReader, NamesTheLineOfWhatItRefuses) {
  EXPECT_EQ(gcodeReaderRefusal("G1 X1\nG1 X1.2.3\n"), "line 2: a letter is expected, as in X10.5, at '.3'");
  EXPECT_EQ(gcodeReaderRefusal("G1 X\n"), "line 1: X has no value");
  EXPECT_EQ(gcodeReaderRefusal("G1 X1 X2\n"), "line 1: X stands twice");
  EXPECT_EQ(gcodeReaderRefusal("G28\nG1 X-\n"), "line 2: bad number at '-'");
  EXPECT_NE(gcodeReaderRefusal("G1 Xnan\n"), "");
  EXPECT_NE(gcodeReaderRefusal("G1 Xinf\n"), "");
  EXPECT_NE(gcodeReaderRefusal("G1 X99999999999\n"), "");
  EXPECT_EQ(gcodeReaderRefusal("X1\n"), "line 1: coordinates before any motion command");
  EXPECT_EQ(gcodeReaderRefusal("G1 X1 F0\n"), "line 1: feed is 0; must be positive");
  EXPECT_EQ(gcodeReaderRefusal("G2 X10\n"), "line 1: arc without centre: neither R nor IJ");
  EXPECT_EQ(gcodeReaderRefusal("G2 X10 I0 J0\n"),
            "line 1: arc without centre: the centre is where it starts");
  EXPECT_EQ(gcodeReaderRefusal("G2 X10 I4\n"), "line 1: the arc ends 2 mm off its circle");
  EXPECT_NE(gcodeReaderRefusal("G2 X10 R4\n"), "");
  EXPECT_NE(gcodeReaderRefusal("G2 R4\n"), "");
  EXPECT_EQ(gcodeReaderRefusal("G1 G2 X1\n"), "line 1: two commands that use the same words");
  EXPECT_EQ(gcodeReaderRefusal("G5 X1\n"), "line 1: G5 is not supported");
  EXPECT_NE(gcodeReaderRefusal("G1 A90\n"), "");
  EXPECT_EQ(gcodeReaderRefusal("N1 G1 X1*3\n").substr(0, 26), "line 1: checksum is 3; the");
  EXPECT_EQ(gcodeReaderRefusal("G28\nG1 (X1\n"), "line 2: comment is not closed at '(X1'");
  EXPECT_NE(gcodeReaderRefusal("\x01\x02\n"), "");
  EXPECT_NE(gcodeReaderRefusal(std::string(2U << 20, 'X')), "");
}

TEST(GcodeReader, QuotesNothingBeforeAPlainCommand) {
  EXPECT_EQ(gcodeReaderRefusal("; SECRET\nX:SECRET\n").find("SECRET"), std::string::npos);
  EXPECT_EQ(gcodeReaderRefusal("; SECRET\nX:SECRET\n").substr(0, 8), "line 2: ");
}

TEST(GcodeReader, EndsAnyBytesWithMotionsOrAnError) {
  EXPECT_TRUE(rc::check("any bytes are read or refused as InvalidProgram", [](const std::string& bytes) {
    try {
      for (const GcodeMotion& motion : motions(bytes)) RC_ASSERT(motion.end.allFinite());
    } catch (const InvalidProgram&) {
    }
  }));
}

TEST(GcodeReader, EndsAnyProgramOfItsWordsWithMotionsOrAnError) {
  const auto pieces =
      rc::gen::container<std::string>(rc::gen::elementOf(std::string("GGMXYZEFIJKRN0123459.-+ \n\n;(*)")));
  EXPECT_TRUE(rc::check("letters and digits in any order are read or refused", [&] {
    const std::string program = *pieces;
    try {
      for (const GcodeMotion& motion : motions(program)) RC_ASSERT(motion.end.allFinite());
    } catch (const InvalidProgram&) {
    }
  }));
}

}  // namespace
}  // namespace lamina
