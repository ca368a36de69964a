// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/corrected_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// Two layers of three beads each, retracted between.
Toolpath beadPart() {
  Toolpath part{"beads", {test::straightBeadLayer({0.0, 3.0, 6.0}, 40.0, 1.5)}};
  ToolpathLayer second = test::straightBeadLayer({0.0, 3.0, 6.0}, 40.0, 3.0);
  Path up;
  up.role = PathRole::Travel;
  up.feed_mm_s = 50.0;
  up.process.is_retracted = true;
  up.points = {part.layers[0].paths.back().lastPoint(), second.paths.front().firstPoint()};
  second.paths.insert(second.paths.begin(), up);
  part.layers.push_back(second);
  return part;
}

/// A ring of 360 waypoints.
Toolpath ringPart() {
  Path ring;
  ring.role = PathRole::OuterWall;
  ring.is_closed = true;
  ring.bead = Bead{3.0, 1.5};
  ring.feed_mm_s = 10.0;
  for (int i = 0; i < 360; ++i)
    ring.points.emplace_back(20.0 * std::cos(i * M_PI / 180), 20.0 * std::sin(i * M_PI / 180), 1.5);
  return {"ring", {{1.5, 1.5, {ring}}}};
}

std::string programOf(const Toolpath& part, double arcs_tolerance_mm = 0.0) {
  ProgramSettings settings;
  settings.arcs_tolerance_mm = arcs_tolerance_mm;
  std::string text;
  writeGcode(part, Eigen::Isometry3d::Identity(), settings, [&](std::string_view piece) { text += piece; });
  return text;
}

/// Map of all depositing paths of a layer, by a function of the length along each.
template <class Amount>
CorrectionMap mapOf(const Toolpath& part, std::size_t layer, Amount placeAt) {
  const LayerCells cells = layerCells(part.layers[layer], layer, 0.5);
  CellCorrections corrections;
  for (const double s : cells.along_mm) {
    const PointCorrection place = placeAt(s);
    corrections.amount.push_back(place.amount);
    corrections.speed.push_back(place.speed);
    corrections.dz_mm.push_back(place.dz_mm);
  }
  return correctionMap(cells, corrections, toolpathId(part), 1);
}

CorrectionMap evenMap(const Toolpath& part, std::size_t layer, const PointCorrection& place) {
  return mapOf(part, layer, [&](double) { return place; });
}

/// What a program does.
struct Played {
  double deposited_mm = 0.0;  ///< filament, while the nozzle moves
  double balance_mm = 0.0;    ///< all filament
  double deposit_mm = 0.0;    ///< way
  double fastest_mm_s = 0.0;  ///< of depositing motions
  double slowest_mm_s = 1e9;
  double fastest_travel_mm_s = 0.0;
  double highest_mm = 0.0;  ///< deposited at
};

Played played(const std::string& program) {
  Played sum;
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) {
    const double way = (motion.end - motion.start).norm();
    sum.balance_mm += motion.extrusion_mm;
    if (way > 0.0 && motion.extrusion_mm <= 0.0 && motion.layer)
      sum.fastest_travel_mm_s = std::max(sum.fastest_travel_mm_s, motion.feed_mm_s);
    if (way == 0.0 || motion.extrusion_mm <= 0.0) return;
    sum.deposited_mm += motion.extrusion_mm;
    sum.deposit_mm += way;
    sum.fastest_mm_s = std::max(sum.fastest_mm_s, motion.feed_mm_s);
    sum.slowest_mm_s = std::min(sum.slowest_mm_s, motion.feed_mm_s);
    sum.highest_mm = std::max(sum.highest_mm, motion.end.z());
  };
  GcodeReader reader({}, handlers);
  reader.read(program);
  reader.finish();
  return sum;
}

/// The same program with E counted from the start.
std::string inAbsoluteExtrusion(const std::string& program) {
  std::string text;
  double filament = 0.0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size() - 1) + 1;
    std::string line = program.substr(begin, end - begin);
    begin = end;
    if (line.rfind("M83", 0) == 0) line = "M82\n";
    const std::size_t word = line.rfind("G1", 0) == 0 || line.rfind("G2", 0) == 0 || line.rfind("G3", 0) == 0
                                 ? line.find(" E")
                                 : std::string::npos;
    if (word != std::string::npos) {
      const std::size_t stop = line.find_first_of(" \n", word + 2);
      filament += std::stod(line.substr(word + 2, stop - word - 2));
      line.replace(word + 2, stop - word - 2, std::to_string(filament));
    }
    text += line;
  }
  return text;
}

TEST(CorrectedProgram, WithoutCorrectionIsTheSameToTheLastByte) {
  for (const Toolpath& part : {beadPart(), ringPart()}) {
    const CorrectionMap none = evenMap(part, 0, {});
    for (const double arcs : {0.0, 0.01}) {
      const std::string program = programOf(part, arcs);
      EXPECT_EQ(correctedProgram(program, part, {none}, {}).text, program);
      EXPECT_EQ(correctedProgram(program, part, {}, {}).text, program);
      const std::string absolute = inAbsoluteExtrusion(program);
      EXPECT_EQ(correctedProgram(absolute, part, {none}, {}).text, absolute);
      const std::string cut = program.substr(0, program.size() - 1);
      EXPECT_EQ(correctedProgram(cut, part, {none}, {}).text, cut) << "no line feed at the end";
    }
  }
}

TEST(CorrectedProgram, PushesWhatTheMapAsksFor) {
  const Toolpath part = beadPart();
  const CorrectionMap map = evenMap(part, 1, {0.15, 0.0, 0.0});
  for (const bool is_absolute : {false, true}) {
    const std::string program = is_absolute ? inAbsoluteExtrusion(programOf(part)) : programOf(part);
    const Played before = played(program);
    const CorrectedProgram corrected = correctedProgram(program, part, {map}, {});
    const Played after = played(corrected.text);
    EXPECT_NEAR(after.deposited_mm, before.deposited_mm * (1.0 + 0.5 * 0.15), 1e-4)
        << "the second layer of two";
    EXPECT_NEAR(after.balance_mm - before.balance_mm, 0.075 * before.deposited_mm, 1e-4)
        << "retractions are kept";
    EXPECT_NEAR(after.deposit_mm, before.deposit_mm, 1e-9);
    EXPECT_EQ(corrected.report.corrected_lines, 3U);
    EXPECT_EQ(corrected.report.added_lines, 0U) << "it does not change along a line";
    EXPECT_NEAR(corrected.report.corrected_mm, 1.15 * corrected.report.planned_mm, 1e-9);
  }
}

/// A ramp from -0.2 to 0.2 along each bead changes no sum; beyond half a station from its ends it is flat.
TEST(CorrectedProgram, SplitsLinesWhereTheAmountChanges) {
  const Toolpath part = beadPart();
  const auto ramp = [](double s) { return PointCorrection{0.2 * (s / 20.0 - 1.0), 0.0, 0.0}; };
  const std::string program = programOf(part);
  const CorrectedProgram corrected = correctedProgram(program, part, {mapOf(part, 0, ramp)}, {});
  const Played before = played(program);
  const Played after = played(corrected.text);
  EXPECT_NEAR(after.deposited_mm, before.deposited_mm, 1e-4);
  EXPECT_NEAR(after.deposit_mm, before.deposit_mm, 1e-6);
  // A change of 0.395 in pieces of 0.02, cut at stations of 0.005: 19.75, and so 20 of each of three lines.
  EXPECT_EQ(corrected.report.added_lines, 3U * 19U);
}

TEST(CorrectedProgram, KeepsTheSumOfManyPieces) {
  const Toolpath part = ringPart();
  const auto wave = [](double s) { return PointCorrection{0.3 * std::sin(s / 20.0), 0.0, 0.0}; };
  for (const double arcs : {0.0, 0.01}) {
    for (const bool is_absolute : {false, true}) {
      const std::string program =
          is_absolute ? inAbsoluteExtrusion(programOf(part, arcs)) : programOf(part, arcs);
      const CorrectedProgram corrected = correctedProgram(program, part, {mapOf(part, 0, wave)}, {});
      EXPECT_NEAR(played(corrected.text).deposited_mm, corrected.report.corrected_mm, 1e-4);
      EXPECT_NEAR(corrected.report.corrected_mm, played(program).deposited_mm, 1e-3) << "a wave adds nothing";
      EXPECT_EQ(corrected.report.off_path_lines, 0U);
    }
  }
}

TEST(CorrectedProgram, KeepsAnArcWhoseAmountIsTheSame) {
  const Toolpath part = ringPart();
  const std::string program = programOf(part, 0.01);
  const CorrectedProgram corrected = correctedProgram(program, part, {evenMap(part, 0, {0.1, 0, 0})}, {});
  EXPECT_EQ(corrected.report.added_lines, 0U);
  EXPECT_NE(corrected.text.find("G3"), std::string::npos);
  EXPECT_NEAR(played(corrected.text).deposited_mm, 1.1 * played(program).deposited_mm, 1e-4);
}

TEST(CorrectedProgram, ChangesFeedsAndTakesThemBack) {
  const Toolpath part = beadPart();
  const std::string program = programOf(part);
  const CorrectedProgram corrected = correctedProgram(program, part, {evenMap(part, 0, {0.0, 0.5, 0.0})}, {});
  const Played after = played(corrected.text);
  EXPECT_NEAR(after.fastest_mm_s, 15.0, 1e-3);
  EXPECT_NEAR(after.slowest_mm_s, 10.0, 1e-3) << "the second layer has its own";
  EXPECT_NEAR(after.fastest_travel_mm_s, played(program).fastest_travel_mm_s, 1e-3);
  EXPECT_NEAR(after.deposited_mm, played(program).deposited_mm, 1e-4);
}

TEST(CorrectedProgram, ShiftsTheNozzleAndTakesItBack) {
  const Toolpath part = beadPart();
  const std::string program = programOf(part);
  const CorrectedProgram corrected = correctedProgram(program, part, {evenMap(part, 0, {0.0, 0.0, 0.3})}, {});
  const std::string& text = corrected.text;
  EXPECT_NE(text.find("Z1.800"), std::string::npos);
  EXPECT_NE(text.find("G0 X0.000 Y0.000 Z3.000"), std::string::npos) << "the way up takes it back";
  EXPECT_EQ(text.substr(text.rfind(";TYPE")), program.substr(program.rfind(";TYPE")));
  EXPECT_NEAR(played(text).highest_mm, 3.0, 1e-9);
}

/// What stands in the corrected program between the last deposit and the end code's first motion.
std::string beforeTheLift(double dz_mm) {
  const Toolpath part = beadPart();
  std::string program = programOf(part);
  program += "G91\nG0 Z5 F600\nG90\n";
  const std::string text = correctedProgram(program, part, {evenMap(part, 1, {0.0, 0.0, dz_mm})}, {}).text;
  const std::size_t last = text.rfind(" E");
  const std::size_t from = text.find('\n', last) + 1;
  return text.substr(from, text.rfind("G91") - from);
}

TEST(CorrectedProgram, StatesNoPlaceWhileTheEndCodeCountsFromWhereItIs) {
  EXPECT_EQ(beforeTheLift(0.3).find("G1 X"), std::string::npos) << "would go down into the bead";
  EXPECT_NE(beforeTheLift(-0.3).find("G1 X40.000 Y6.000 Z3.000"), std::string::npos);
  const Toolpath part = beadPart();
  const std::string program = programOf(part) + "G91\nG0 Z5 F600\n";
  const std::string text = correctedProgram(program, part, {evenMap(part, 1, {0.0, 0.0, -0.3})}, {}).text;
  EXPECT_EQ(text.substr(text.rfind("G91")), "G91\nG0 Z5 F600\n");
}

TEST(CorrectedProgram, RefusesMapsOfOtherToolpaths) {
  const Toolpath part = beadPart();
  const CorrectionMap map = evenMap(part, 0, {0.1, 0.0, 0.0});
  EXPECT_THROW(correctedProgram("", ringPart(), {map}, {}), InvalidInput);
  EXPECT_THROW(correctedProgram("", part, {map, map}, {}), InvalidInput);
}

TEST(CorrectedProgram, RefusesShiftsBeyondALayer) {
  const Toolpath part = beadPart();
  EXPECT_NO_THROW(correctedProgram("", part, {evenMap(part, 0, {0.0, 0.0, -1.5})}, {}));
  EXPECT_THROW(correctedProgram("", part, {evenMap(part, 0, {0.0, 0.0, -1.6})}, {}), InvalidInput);
}

TEST(CorrectedProgram, HoldsNoMoreThanTheStationsOfAMap) {
  const Toolpath part = beadPart();
  CorrectionMap map = evenMap(part, 0, {0.1, 0.0, 0.0});
  for (PathCorrection& path : map.paths) {
    path.spacing_mm = 0.001;  // the least: 40 mm of them would be 40 000 pieces
    path.stations.resize(2);
  }
  const std::string program = programOf(part);
  EXPECT_NEAR(played(correctedProgram(program, part, {map}, {}).text).deposited_mm,
              1.05 * played(program).deposited_mm, 1e-3);
  CorrectionWriting never;
  never.split_change = 0.0;
  EXPECT_THROW(correctedProgram(program, part, {map}, never), InvalidInput);
}

TEST(CorrectedProgram, LeavesWhatIsBesideTheToolpath) {
  const Toolpath part = beadPart();
  std::string program = programOf(part);
  const std::string purge = "G0 X-50 Y-50 Z1.5\nG1 X-50 Y-20 E3.000\n";
  const std::size_t layer = program.find('\n', program.find(";LAYER:0")) + 1;
  program.insert(layer, purge + "G0 X0 Y0\n");
  const CorrectedProgram corrected = correctedProgram(program, part, {evenMap(part, 0, {0.1, 0, 0})}, {});
  EXPECT_EQ(corrected.report.off_path_lines, 1U);
  EXPECT_EQ(corrected.report.corrected_lines, 3U);
  EXPECT_NE(corrected.text.find(purge), std::string::npos);
}

TEST(CorrectedProgram, RefusesAChecksum) {
  const Toolpath part = beadPart();
  std::string program = programOf(part);
  const std::size_t line = program.find("G1", program.find(";LAYER:0"));
  program.insert(program.find('\n', line), "*12");
  EXPECT_THROW(correctedProgram(program, part, {evenMap(part, 0, {0.1, 0, 0})}, {}), InvalidProgram);
}

TEST(CorrectedProgram, TakesMapsUntilTheirLayersBegin) {
  const Toolpath part = beadPart();
  const std::string program = programOf(part);
  const CorrectionMap second = mapOf(part, 1, [](double) { return PointCorrection{0.1, 0.0, 0.0}; });
  const std::string expected = correctedProgram(program, part, {second}, {}).text;
  const std::size_t layer = program.find(";LAYER:1");
  ASSERT_NE(layer, std::string::npos);
  ProgramCorrector corrector(part, {}, {});
  std::string text;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    if (begin == layer) {
      CorrectionMap late = second;
      late.layer = 0;
      EXPECT_THROW(corrector.add(late), InvalidInput) << "the first layer is deposited";
      corrector.add(second);
      EXPECT_THROW(corrector.add(second), InvalidInput) << "one a layer";
    }
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    corrector.read(std::string_view(program).substr(begin, end - begin), ++number, text);
    if (end < program.size()) text += '\n';
    begin = end + 1;
  }
  EXPECT_EQ(text, expected);
}

/// The second of three beads is read by another map than the first: half and a tenth more.
TEST(CorrectedProgram, TakesLaterMapsForLinesThatAreNotRead) {
  const Toolpath part = beadPart();
  const std::string program = programOf(part);
  const CorrectionMap begun = evenMap(part, 0, {0.5, 0.0, 0.0});
  CorrectionMap later = evenMap(part, 0, {0.1, 0.0, 0.0});
  later.sequence = 2;
  // The first deposit of the program is the first line that pushes filament while it moves in x.
  const std::size_t first = program.find(" E", program.find(";LAYER:0"));
  const auto line = static_cast<std::size_t>(
      1 + std::count(program.begin(), program.begin() + static_cast<std::ptrdiff_t>(first), '\n'));
  const double bead_mm = played(program).deposited_mm / 6.0;
  const auto deposited = [&](std::size_t from_line) {
    return played(correctedProgram(program, part, {begun}, {}, {{from_line, later}}).text).deposited_mm;
  };
  EXPECT_NEAR(deposited(line), (6.0 + 3.0 * 0.1) * bead_mm, 1e-4);
  EXPECT_NEAR(deposited(line + 1), (6.0 + 0.5 + 2.0 * 0.1) * bead_mm, 1e-4);
  EXPECT_EQ(correctedProgram(program, part, {begun}, {}, {{program.size(), later}}).text,
            correctedProgram(program, part, {begun}, {}).text);
  CorrectionMap other = later;
  other.toolpath_id = "other";
  EXPECT_THROW(correctedProgram(program, part, {begun}, {}, {{line, other}}), InvalidInput);
}

}  // namespace
}  // namespace lamina
