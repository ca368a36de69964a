// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/report/loop_report.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// Layers of 200 cells, each a piece of the picture: too low by 0.5 mm in the first half, as planned behind.
/// Those from `measured` on were not measured.
LoopRecord recordOf(std::size_t layers, std::size_t measured = 1000) {
  LoopRecord record("wall", "0123456789abcdef");
  for (std::size_t k = 0; k < layers; ++k) {
    LayerOutcome layer;
    layer.figures.layer = k;
    layer.figures.is_measured = k < measured;
    layer.figures.coverage = 1.0;
    for (int i = 0; i < 200; ++i) {
      CellOutcome cell;
      cell.error_mm = k >= measured ? 9.0 : i < 100 ? 0.5 : 0.0;
      cell.along_mm = {0.5, 0.0, 0.0};
      layer.cells.push_back(cell);
    }
    record.add(layer, "00000000000000aa");
  }
  return record;
}

std::size_t countOf(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

TEST(LoopReport, SaysWhatItsColoursMean) {
  const std::string page = loopReport(recordOf(3));
  EXPECT_NE(page.find(">0.50 mm too low</text>"), std::string::npos);
  EXPECT_NE(page.find(">as planned</text>"), std::string::npos);
  EXPECT_NE(page.find(">0.50 mm too high</text>"), std::string::npos);
}

TEST(LoopReport, NamesALayerInTwelfthsOfThePicture) {
  // Beside the numbers of layers there are the four words of the scale.
  EXPECT_EQ(countOf(loopReport(recordOf(3)), "</text>"), 3U + 4U);
  EXPECT_EQ(countOf(loopReport(recordOf(24)), "</text>"), 12U + 4U);
}

TEST(LoopReport, ShowsLayersThatWereNotMeasuredWithoutAnError) {
  const std::string grey = "fill=\"#a8a8a8\"";  // 0.66 of 255
  EXPECT_EQ(countOf(loopReport(recordOf(3)), grey), 1U) << "of the scale";
  const std::string page = loopReport(recordOf(3, 1));
  EXPECT_EQ(countOf(page, grey), 1U + 2U * 200U);
  EXPECT_NE(page.find(">not measured</text>"), std::string::npos);
  EXPECT_NE(page.find(">0.50 mm too low</text>"), std::string::npos) << "by what was measured";
}

TEST(LoopReport, OfNoLayerSaysSo) {
  EXPECT_NE(loopReport(LoopRecord("wall", "id")).find("No layer was done."), std::string::npos);
}

}  // namespace
}  // namespace lamina
