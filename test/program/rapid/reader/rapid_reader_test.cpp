// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/reader/rapid_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/rapid_programs.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kPosition = 0.5e-4 + 1e-9;  // mm: half of the last decimal
constexpr double kOrientation = 1.1e-7;      // rad: half of the last decimal of each of four parts, twice
constexpr double kFeed = 0.5e-3 + 1e-9;      // mm/s

Toolpath rapidReaderReadBack(const std::vector<std::string>& texts) {
  std::vector<RapidText> modules;
  for (std::size_t m = 0; m < texts.size(); ++m)
    modules.push_back({"m" + std::to_string(m) + ".mod", texts[m]});
  return readRapid(modules, "part");
}

void expectSamePath(const Path& read, const Path& written) {
  RC_ASSERT(read.role == written.role);
  RC_ASSERT(read.is_closed == written.is_closed);
  RC_ASSERT(read.process.is_retracted == written.process.is_retracted);
  RC_ASSERT(read.points.size() == written.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    RC_ASSERT((read.points[i] - written.points[i]).cwiseAbs().maxCoeff() <=
              kPosition + (i == 0 ? 1e-4 : 0.0));
    RC_ASSERT(read.orientation.at(i).angularDistance(written.orientation.at(i)) <= 4.0 * kOrientation);
    if (i == 0 && !written.is_closed) continue;  // not used
    RC_ASSERT(std::abs(read.feed_mm_s.at(i) - written.feed_mm_s.at(i)) <= kFeed);
    if (written.role != PathRole::Travel) RC_ASSERT(read.bead.at(i) == written.bead.at(i));
  }
}

void rapidReaderExpectSame(const Toolpath& read, const Toolpath& written) {
  validate(read);
  RC_ASSERT(read.layers.size() == written.layers.size());
  for (std::size_t l = 0; l < read.layers.size(); ++l) {
    RC_ASSERT(read.layers[l].z_mm == written.layers[l].z_mm);
    RC_ASSERT(read.layers[l].height_mm == written.layers[l].height_mm);
    RC_ASSERT(read.layers[l].paths.size() == written.layers[l].paths.size());
    for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
      expectSamePath(read.layers[l].paths[p], written.layers[l].paths[p]);
  }
}

TEST(RapidReader, ReadsBackWhatWasWrittenOfEachVariant) {
  for (const RapidVariant variant :
       {RapidVariant::Powder3Axes, RapidVariant::Wire3Axes, RapidVariant::Powder5Axes})
    EXPECT_TRUE(rc::check([variant](std::uint64_t seed) {
      const Toolpath plain = test::randomToolpath(seed);
      const Toolpath toolpath = variant == RapidVariant::Powder5Axes ? test::tilted(plain, seed) : plain;
      RapidSettings settings;
      settings.variant = variant;
      settings.start_point_mm = {12.5, -3, 0.25};
      rapidReaderExpectSame(rapidReaderReadBack(test::rapidModules(toolpath, settings)), toolpath);
    }));
}

// Of the same time, whether a program states it in its head or, as before, by the triggers themselves.
TEST(RapidReader, KnowsHowLongBeforeTheEndTheWireStops) {
  RapidSettings settings;
  settings.variant = RapidVariant::Wire3Axes;
  settings.wire_stop_s = 0.25;
  std::string text = test::rapidModules(test::twoLayers(), settings)[0];
  EXPECT_EQ(readEquippedRapid({{"now.mod", text}}, "part").equipment.process.count("trigger of 0.25 s"), 1U);
  const std::string note = "!# wire_stop 0.25\n";
  text.erase(text.find(note), note.size());
  const std::string distance = "7.500\\DOp";
  for (std::size_t at = text.find(distance); at != std::string::npos; at = text.find(distance))
    text.replace(at, distance.size(), "0.25\\Time\\DOp");
  EXPECT_EQ(readEquippedRapid({{"old.mod", text}}, "part").equipment.process.count("trigger of 0.25 s"), 1U);
}

TEST(RapidReader, JoinsTheModulesOfASplitProgram) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = test::tilted(test::randomToolpath(seed), seed);
    RapidSettings settings;
    settings.max_points = 1 + static_cast<int>(seed % 30);
    rapidReaderExpectSame(rapidReaderReadBack(test::rapidModules(toolpath, settings)), toolpath);
  }));
}

TEST(RapidReader, FindsTheFilesOfTheModules) {
  const test::ScratchFolder folder;
  RapidSettings settings;
  settings.module = "square";
  settings.max_points = 6;
  settings.loading = RapidLoading::InTurn;
  const Toolpath toolpath = test::twoLayers();
  const RapidProgram program(toolpath, Eigen::Isometry3d::Identity(), settings);
  for (std::size_t m = 0; m < program.moduleNames().size(); ++m) {
    std::string text;
    program.write(m, [&text](std::string_view piece) { text += piece; });
    writeFile(folder.file(program.moduleNames()[m] + ".mod"), text);
  }
  const Toolpath read = readRapidFile(folder.file("square.mod"));
  EXPECT_EQ(read.part_name, "square");
  EXPECT_EQ(totals(read).waypoints, totals(toolpath).waypoints);
  EXPECT_NEAR(totals(read).deposited_mm3, totals(toolpath).deposited_mm3, 1e-9);
}

TEST(RapidReader, KeepsInclinedLayers) {
  Toolpath toolpath = test::twoLayers();
  toolpath.part_from_layers = Eigen::AngleAxisd(0.5, Point3::UnitX());
  const Toolpath read = rapidReaderReadBack(test::rapidModules(toolpath, {}));
  EXPECT_LT(read.part_from_layers.angularDistance(toolpath.part_from_layers), 1e-12);
}

/// The error that reading the text with `from` replaced by `to` gives.
std::string rapidReaderRefusal(const std::string& from, const std::string& to) {
  std::string text = test::rapidModules(test::twoLayers(), {})[0];
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    rapidReaderReadBack({text});
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return "";
}

TEST(RapidReader, NamesTheLineWhatWasFoundAndWhatWasExpected) {
  EXPECT_EQ(
      rapidReaderRefusal("    deposit_1;", "    deposit_7;"),
      "'m0.mod' line 20: found 'deposit_7'; expected an instruction that is known, or a procedure of the "
      "program");
  EXPECT_NE(rapidReaderRefusal("MoveL [[10", "MoveJ [[10").find("found instruction 'movej'; expected MoveL"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("fine,t_", "fino,t_").find("found zone 'fino'; expected"), std::string::npos);
  EXPECT_NE(rapidReaderRefusal("speed_prueba,z0", "speed_x,z0").find("found speed 'speed_x'"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("[[0.0000,", "[[x,").find("found 'x,0.0000"), std::string::npos);
  EXPECT_NE(rapidReaderRefusal("1.0000000", "0.9000000").find("length 0.9"), std::string::npos);
  EXPECT_NE(rapidReaderRefusal("WObj:=temple", "WObj:=wobj1").find("expected 'wobj1' as in the moves before"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("PERS tooldata", "PERS toolbox").find("found data of type 'toolbox'"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("ENDMODULE", "").find("the text ends; expected PROC, ENDMODULE"),
            std::string::npos);
}

TEST(RapidReader, RefusesMovesThatTheCommentsDoNotFit) {
  EXPECT_NE(rapidReaderRefusal("closed turned 5", "closed turned 4").find("a closed path does not return"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("!# bead 0.4 0.2 4", "!# bead 0.4 0.2 3").find("expected one bead for each"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("!# path", "! path").find("a note of a path before its beads"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("!# layer 0.2 0.2\n", "").find("expected a note '!# layer'"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("outer_wall closed", "outer_hall closed").find("expected the role of a path"),
            std::string::npos);
  EXPECT_NE(rapidReaderRefusal("Haz_ON;\n", "\n").find("the process is off in a path that is outer_wall"),
            std::string::npos);
}

TEST(RapidReader, ReadsOrRefusesAnyMutatedText) {
  const std::string text = test::rapidModules(test::tilted(test::twoLayers(), 1), {})[0];
  EXPECT_TRUE(rc::check([&text](std::uint64_t seed) {
    Random random(seed);
    std::string mutated = text;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(mutated.size());
      const std::size_t from = random.below(mutated.size());
      const std::size_t length = 1 + random.below(40);
      switch (random.below(4)) {
        case 0:
          mutated[at] = static_cast<char>(random.below(128));
          break;
        case 1:
          mutated.erase(at, length);
          break;
        case 2:
          mutated.insert(at, mutated.substr(from, length));
          break;
        default:
          mutated.insert(at, 1, "0123456789;,[]!\n\"%"[random.below(18)]);
      }
    }
    try {
      validate(rapidReaderReadBack({mutated}));
    } catch (const InvalidProgram&) {
    }
  }));
}

}  // namespace
}  // namespace lamina
