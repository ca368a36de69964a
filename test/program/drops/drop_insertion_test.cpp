// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/program/drops/drop_program.hpp"
#include "support/drop_programs.hpp"

namespace lamina {
namespace {

using test::kDropHeader;
using test::kNoneMissing;
using test::squareProgram;

std::string filled(const std::string& text, const std::vector<std::vector<Point2>>& added) {
  return withDrops(parseDropProgram(text, {}), added, {});
}

TEST(DropInsertion, OfNoDropGivesTheProgramByteForByte) {
  const std::string text = squareProgram({kNoneMissing, {4, 4}});
  EXPECT_EQ(filled(text, {}), text);
  EXPECT_EQ(filled(text, {{}, {}}), text);
}

TEST(DropInsertion, PutsExactlyItsLinesBehindTheLastDropOfTheLayer) {
  const std::string text = squareProgram({kNoneMissing, {4, 4}, kNoneMissing});
  const std::string before = text.substr(0, text.find("M117 layer 1 done"));
  EXPECT_EQ(filled(text, {{}, {{14, 24}}, {}}),
            before + ";TYPE:VOIDFILL\nG1 X14 Y24\nM780 P3\nG1 X17 Y27\n;TYPE:INFILL\n" +
                text.substr(before.size()));
}

TEST(DropInsertion, IsReadAsDropsOfAVoidFillAndNothingElse) {
  const std::string text = squareProgram({{4, 4}, {2, 2}});
  const DropProgram before = parseDropProgram(text, {});
  const DropProgram after = parseDropProgram(filled(text, {{{14, 24}, {3, 3}}, {{12, 22}}}), {});
  ASSERT_EQ(after.layers.size(), before.layers.size());
  for (std::size_t l = 0; l < before.layers.size(); ++l) {
    const auto& prior = before.layers[l].drops;
    const auto& now = after.layers[l].drops;
    ASSERT_EQ(now.size(), prior.size() + 2 - l);
    for (std::size_t i = 0; i < prior.size(); ++i) {
      EXPECT_EQ(now[i].position, prior[i].position);
      EXPECT_EQ(now[i].role, prior[i].role);
    }
    for (std::size_t i = prior.size(); i < now.size(); ++i) EXPECT_EQ(now[i].role, PathRole::GapFill);
  }
  EXPECT_EQ(after.layers[0].drops.back().position, Point3(3, 3, 1));
}

TEST(DropInsertion, WritesInTheUnitsAndCoordinatesOfTheProgram) {
  const std::string text = kDropHeader + ";LAYER:0\nG20\nG1 X1 Y1 Z0.1\nG92 X0 Y0\nG1 X1 Y2\nM780\n";
  const DropProgram program = parseDropProgram(text, {});
  EXPECT_TRUE(program.layers[0].drops[0].position.isApprox(Point3(50.8, 76.2, 2.54)));
  const std::string with_drop = withDrops(program, {{{50.8, 50.8}}}, {});
  EXPECT_NE(with_drop.find("G1 X1 Y1\nM780\n"), std::string::npos) << with_drop;
  const DropProgram back = parseDropProgram(with_drop, {});
  EXPECT_TRUE(back.layers[0].drops[1].position.isApprox(Point3(50.8, 50.8, 2.54)));
}

TEST(DropInsertion, KeepsLineEndsAndAMissingLastOne) {
  const std::string crlf = ";drop_diameter=1\r\n;LAYER:0\r\nG1 X1 Y1 Z1 F60\r\nM780\r\n";
  EXPECT_EQ(filled(crlf, {{{2, 1}}}), crlf + ";TYPE:VOIDFILL\r\nG1 X2 Y1\r\nM780\r\nG1 X1 Y1\r\n");
  const std::string open = ";drop_diameter=1\n;LAYER:0\nG1 X1 Y1 Z1 F60\nM780";
  EXPECT_EQ(filled(open, {{{2, 1}}}), open + "\n;TYPE:VOIDFILL\nG1 X2 Y1\nM780\nG1 X1 Y1\n");
}

TEST(DropInsertion, CopiesTheCommandOfTheInfillAndTheMotionThatHolds) {
  const std::string text = kDropHeader +
                           ";LAYER:0\n;TYPE:INFILL\nG0 X1 Y1 Z1\nM780 P7\n;TYPE:CONTOUR\nX2\nM780 P9\n"
                           "X3 ; as G0\nM780 P9\n";
  const std::string with_drop = filled(text, {{{5, 5}}});
  EXPECT_EQ(with_drop.substr(text.size()), ";TYPE:VOIDFILL\nG0 X5 Y5\nM780 P7\nG0 X3 Y1\n;TYPE:CONTOUR\n");
}

TEST(DropInsertion, RefusesPlacesWhereLinesWouldMeanSomethingElse) {
  const std::string head = kDropHeader + ";LAYER:0\nG1 X1 Y1 Z1\n";
  for (const char* tail : {"G91\nM780\n", "G92 X0\nM780\n", "G28\nG1 X3\nM780\n", "G2 X3 I1\nM780\n"})
    EXPECT_THROW(filled(head + tail, {{{5, 5}}}), InvalidProgram) << tail;
  EXPECT_NO_THROW(filled(head + "G92 E0\nM780\n", {{{5, 5}}})) << "filament is no coordinate of a drop";
  EXPECT_NO_THROW(filled(head + "G91\nM780\n", {{}})) << "nothing is written there";
}

/// Any lines of a drop program in any order, some of them strange.
std::string randomProgram(Random& random) {
  const std::vector<std::string> lines = {
      ";LAYER:1",      ";TYPE:CONTOUR", ";TYPE:INFILL",  ";TYPE:OTHER",   "M780",          "M780 P2",
      "G1 X1 Y2 Z0.3", "G0 X-4",        "Y7 ; a remark", "M117 any text", "(in brackets)", "",
      "G21",           "M106 S255",     "  G1 X3.25",    ";strategy=x",   "G4 P10",        "N5 G1 Y1"};
  std::string text = kDropHeader + "G1 X1 Y1 Z0.3\n";
  const std::size_t count = random.below(60);
  for (std::size_t i = 0; i < count; ++i)
    text += lines[random.below(lines.size())] + (random.below(4) == 0 ? "\r\n" : "\n");
  if (random.below(3) == 0) text.pop_back();
  return text;
}

std::vector<std::vector<Point2>> randomDrops(Random& random, std::size_t layers) {
  std::vector<std::vector<Point2>> added(layers);
  for (auto& drops : added)
    for (std::size_t i = random.below(3); i > 0; --i)
      drops.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9));
  return added;
}

/// The text without as many lines as drops need behind the last drop of each layer.
std::string withoutBlocks(const std::string& text, const DropProgram& program,
                          const std::vector<std::vector<Point2>>& added) {
  std::string rest;
  std::size_t at = 0;
  std::size_t offset = 0;
  for (std::size_t l = 0; l < added.size(); ++l) {
    if (added[l].empty()) continue;
    const InsertionPoint& end = program.layers[l].end;
    rest += text.substr(at, end.offset - offset);
    at += end.offset - offset;
    offset = end.offset;
    std::size_t lines = 2 + 2 * added[l].size() + (end.role_comment.empty() ? 0 : 1);
    if (rest.back() != '\n') ++lines;  // the one that the program's last line is ended by
    for (; lines > 0; --lines) at = text.find('\n', at) + 1;
  }
  return rest + text.substr(at);
}

TEST(DropInsertion, KeepsEveryByteOfAnyProgram) {
  EXPECT_TRUE(rc::check("random programs", [](std::uint64_t seed) {
    Random random(seed);
    const DropProgram program = parseDropProgram(randomProgram(random), {});
    RC_ASSERT(withDrops(program, {}, {}) == program.text);
    const auto added = randomDrops(random, program.layers.size());
    RC_ASSERT(withoutBlocks(withDrops(program, added, {}), program, added) == program.text);
  }));
}

TEST(DropInsertion, GivesAnyProgramItsDropsAndNoOthers) {
  EXPECT_TRUE(rc::check("random programs", [](std::uint64_t seed) {
    Random random(seed);
    const DropProgram program = parseDropProgram(randomProgram(random), {});
    const auto added = randomDrops(random, program.layers.size());
    const DropProgram back = parseDropProgram(withDrops(program, added, {}), {});
    RC_ASSERT(back.layers.size() == program.layers.size());
    for (std::size_t l = 0; l < added.size(); ++l) {
      std::vector<Point3> expected;
      for (const ProgramDrop& drop : program.layers[l].drops) expected.push_back(drop.position);
      for (const Point2& drop : added[l]) expected.emplace_back(drop.x(), drop.y(), expected.back().z());
      RC_ASSERT(back.layers[l].drops.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
        RC_ASSERT((back.layers[l].drops[i].position - expected[i]).norm() < 2e-5);
    }
  }));
}

TEST(DropInsertion, RefusesDropsForLayersThatAreNot) {
  const std::string text = squareProgram({kNoneMissing, {4, 4}});
  try {
    filled(text, {{}, {}, {{5, 5}}});
    FAIL() << "the program has two layers";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "drops are given for 3 layers; expected at most the 2 of the program");
  }
}

}  // namespace
}  // namespace lamina
