// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/drop_void_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/drop_programs.hpp"

namespace lamina {
namespace {

using test::kNoneMissing;
using test::squareProgram;

FilledDropProgram filled(const std::string& text, const DropVoidSettings& settings = {}) {
  NoProgress progress;
  return fillDropProgram(parseDropProgram(text, {}), settings, {}, progress);
}

TEST(DropVoidJob, LeavesAProgramWithoutVoidsByteForByte) {
  const std::string text = squareProgram({kNoneMissing, kNoneMissing});
  const FilledDropProgram result = filled(text);
  EXPECT_EQ(result.text, text);
  EXPECT_EQ(result.report.count(), 0U);
  EXPECT_EQ(result.report.overlap.prior, 162U);
  EXPECT_FALSE(result.report.is_worth_it);
}

TEST(DropVoidJob, PutsTheMissingDropBackIntoItsLayerOnly) {
  const std::string text = squareProgram({kNoneMissing, {4, 4}, kNoneMissing});
  const FilledDropProgram result = filled(text);
  const std::string before = text.substr(0, text.find("M117 layer 1 done"));
  const std::string block = ";TYPE:VOIDFILL\nG1 X14 Y24\nM780 P3\nG1 X17 Y27\n;TYPE:INFILL\n";
  EXPECT_EQ(result.text.substr(before.size(), block.size()), block);
  EXPECT_TRUE(result.text == before + block + text.substr(before.size()));
  ASSERT_EQ(result.report.voids.size(), 3U);
  EXPECT_TRUE(result.report.voids[0].empty());
  EXPECT_EQ(result.report.voids[1].size(), 1U);
  EXPECT_TRUE(result.report.voids[2].empty());
  EXPECT_EQ(result.report.heights_mm, (std::vector<double>{1, 2, 3}));
  EXPECT_NEAR(result.report.overlap.greatest_linear, 0.0, 1e-9);
}

TEST(DropVoidJob, FindsNothingMoreInWhatItFilled) {
  const FilledDropProgram once = filled(squareProgram({{4, 4}, {2, 6}}));
  EXPECT_EQ(filled(once.text).text, once.text);
}

TEST(DropVoidJob, MeasuresWhatTheDropsCover) {
  const DropVoidReport report = filled(squareProgram({{4, 4}, {2, 6}})).report;
  EXPECT_EQ(report.count(), 2U);
  std::size_t classed = 0;
  for (const auto& each : report.countByClass()) classed += each.second;
  EXPECT_EQ(classed, 2U);
  EXPECT_GT(report.uncoveredBefore() - report.uncoveredAfter(), 2 * 0.7) << "nearly the area of two drops";
  EXPECT_GT(report.largestBefore(), report.largestAfter());
}

TEST(DropVoidJob, SaysWhenFewDropsAreNotWorthIt) {
  DropVoidSettings settings;
  settings.least_share = 2.0 / 160.0;
  EXPECT_TRUE(filled(squareProgram({{4, 4}, {2, 6}}), settings).report.is_worth_it) << "2 of 160";
  EXPECT_FALSE(filled(squareProgram({{4, 4}, kNoneMissing}), settings).report.is_worth_it) << "1 of 161";
}

TEST(DropVoidJob, FindsTheContourOfAProgramWithoutRoles) {
  std::string text = squareProgram({{4, 4}});
  for (const char* role : {";TYPE:CONTOUR\n", ";TYPE:INFILL\n"})
    text.erase(text.find(role), std::strlen(role));
  const FilledDropProgram result = filled(text);
  EXPECT_EQ(result.report.layers_without_contour, 0U);
  EXPECT_EQ(result.report.overlap.added, 1U);
}

TEST(DropVoidJob, DistinguishesContoursOfOneRoleByTheirDistance) {
  // Outline and hole behind one comment; the hole must stay open.
  std::vector<Point2> hole = test::squareRing(5, {14, 24});
  std::reverse(hole.begin(), hole.end());
  std::vector<Point2> infill;
  for (const Point2& drop : test::squareInside(13, {10, 20}, {1, 1}))
    if ((drop - Point2(16, 26)).cwiseAbs().maxCoeff() > 2.5) infill.push_back(drop);
  const std::string text = test::kDropHeader + ";LAYER:0\nG1 Z1\n;TYPE:CONTOUR\n" +
                           test::dropLines(test::squareRing(13, {10, 20})) + test::dropLines(hole) +
                           ";TYPE:INFILL\n" + test::dropLines(infill);
  const FilledDropProgram result = filled(text);
  ASSERT_EQ(result.report.overlap.added, 1U);
  EXPECT_TRUE(result.report.voids[0][0].drops[0].isApprox(Point2(11, 21), 1e-6));
}

TEST(DropVoidJob, KeepsAContourWholeThatMissesDrops) {
  std::vector<Point2> ring = test::squareRing(9, {10, 20});
  ring.erase(ring.begin() + 10, ring.begin() + 13);  // a gap of four pitches in the second side
  const std::string text = test::kDropHeader + ";LAYER:0\nG1 Z1\n;TYPE:CONTOUR\n" + test::dropLines(ring) +
                           ";TYPE:INFILL\n" + test::dropLines(test::squareInside(9, {10, 20}, {3, 3}));
  const DropVoidReport report = filled(text).report;
  EXPECT_EQ(report.layers_without_contour, 0U);
  std::vector<Point2> added;
  for (const DropVoid& each : report.voids[0])
    added.insert(added.end(), each.drops.begin(), each.drops.end());
  EXPECT_TRUE(std::any_of(added.begin(), added.end(),
                          [](const Point2& drop) { return drop.isApprox(Point2(13, 23), 1e-6); }));
}

TEST(DropVoidJob, LeavesALayerWithoutContourAlone) {
  const std::string text = test::kDropHeader + ";LAYER:0\nG1 Z1\n;TYPE:INFILL\n" +
                           test::dropLines({{1, 1}, {4, 1}, {1, 4}, {4, 4}});
  const FilledDropProgram result = filled(text);
  EXPECT_EQ(result.report.layers_without_contour, 1U);
  EXPECT_EQ(result.text, text);
}

TEST(DropVoidJob, RefusesProgramsWithoutDropsOrDiameter) {
  EXPECT_THROW(filled(test::kDropHeader), InvalidProgram);
  EXPECT_THROW(filled("G1 X1 Y1 Z1 F60\nM780\n"), InvalidProgram);
}

SlicedPart slicedBox(const std::string& strategy, bool fills) {
  SliceJob job;
  job.part = "box";
  job.settings.planning.infill.strategy = strategy;
  job.settings.planning.infill.density = 1.0;
  job.settings.planning.fill.drops.diameter_mm = 1.1;
  job.settings.planning.fill.drops.pitch_mm = 1.1;
  job.settings.planning.bead.width_mm = 1.2;
  job.settings.slicing.layer_height_mm = 1.0;
  job.settings.slicing.first_layer_height_mm = 1.0;
  job.settings.drop_voids.is_on = fills;
  NoProgress progress;
  return runSliceJob(job, progress);
}

TEST(DropVoidJob, AsAStepOfSlicingFillsAsTheCommandDoes) {
  const Toolpath plain = slicedBox("drops_raster", false).toolpath;
  const Toolpath full = slicedBox("drops_raster", true).toolpath;
  EXPECT_NO_THROW(validate(full));
  ASSERT_EQ(full.layers.size(), plain.layers.size());
  std::size_t added = 0;
  for (const ToolpathLayer& layer : full.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::GapFill) added += path.points.size();
  EXPECT_GT(added, 0U);
  for (std::size_t l = 0; l < plain.layers.size(); ++l)
    for (std::size_t p = 0; p < plain.layers[l].paths.size(); ++p)
      EXPECT_EQ(full.layers[l].paths[p].points, plain.layers[l].paths[p].points) << "prior drops stay";
}

TEST(DropVoidJob, LeavesBeadsAlone) {
  const Toolpath beads = slicedBox("zigzag", false).toolpath;
  DropVoidSettings settings;
  settings.is_on = true;
  NoProgress progress;
  EXPECT_EQ(toolpathId(withDropVoidsFilled(beads, settings, 100.0, progress)), toolpathId(beads));
}

}  // namespace
}  // namespace lamina
