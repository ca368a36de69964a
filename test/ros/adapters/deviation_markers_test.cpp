// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/deviation_markers.hpp"

#include <gtest/gtest.h>

namespace {

using lamina::CellOutcome;
using lamina::deviationColour;
using lamina::deviationMarkers;
using lamina::LayerOutcome;
using lamina::Point3;
using visualization_msgs::Marker;

CellOutcome cellAt(double x, double error_mm, bool is_seen) {
  CellOutcome cell;
  cell.at = {x, 5.0, 3.0};
  cell.error_mm = error_mm;
  cell.is_seen = is_seen;
  cell.along_mm = {0.5, 0.0, 0.0};
  cell.width_mm = 3.0;
  return cell;
}

/// Two layers of 1.5 mm: one cell too low by half a layer, one too high by an eighth, one not seen.
LayerOutcome shownLayer() {
  LayerOutcome outcome;
  outcome.figures.layer = 1;
  outcome.figures.height_mm = 1.5;
  outcome.figures.rmse_mm = 0.25;
  outcome.figures.mean_error_mm = 0.125;
  outcome.cells = {cellAt(10.0, 0.75, true), cellAt(10.5, -0.1875, true), cellAt(11.0, 0.4, false)};
  return outcome;
}

TEST(DeviationMarkers, AreBeadsInTheColoursOfTheirDeviation) {
  const Eigen::Isometry3d bed_from_part(Eigen::Translation3d(100.0, 0.0, 0.0));
  const auto markers = deviationMarkers(shownLayer(), 0, "bed", bed_from_part).markers;
  ASSERT_EQ(markers.size(), 3U);
  const Marker& beads = markers[0];
  EXPECT_EQ(beads.header.frame_id, "bed");
  EXPECT_EQ(beads.ns, "beads");
  EXPECT_EQ(beads.id, 1) << "of the layer: the one below stays";
  EXPECT_EQ(beads.type, Marker::LINE_LIST + 0);
  EXPECT_DOUBLE_EQ(beads.scale.x, 0.003);
  ASSERT_EQ(beads.points.size(), 6U);
  ASSERT_EQ(beads.colors.size(), 6U);
  EXPECT_DOUBLE_EQ(beads.points[0].x, 0.10975);
  EXPECT_DOUBLE_EQ(beads.points[1].x, 0.11025);
  EXPECT_DOUBLE_EQ(beads.points[1].z, 0.003);
  EXPECT_FLOAT_EQ(beads.colors[0].b, 1.0F) << "too low: blue";
  EXPECT_FLOAT_EQ(beads.colors[0].r, 0.12F);
  EXPECT_FLOAT_EQ(beads.colors[2].r, 1.0F) << "too high: red";
  EXPECT_FLOAT_EQ(beads.colors[3].b, 0.56F) << "half of the scale";
  EXPECT_FLOAT_EQ(beads.colors[4].r, beads.colors[4].b) << "not seen: grey";
}

TEST(DeviationMarkers, SayWhatTheColoursMean) {
  const auto markers = deviationMarkers(shownLayer(), 0, "bed", Eigen::Isometry3d::Identity()).markers;
  ASSERT_EQ(markers.size(), 3U);
  const Marker& layer = markers[1];
  const Marker& scale = markers[2];
  EXPECT_EQ(layer.text, "layer 1: off by 0.250 mm (rms), -0.125 mm in the mean");
  EXPECT_EQ(scale.text, "red: 0.38 mm too high, blue: too low, grey: not seen");
  for (std::int32_t line = 0; line < 2; ++line) {
    const Marker& text = markers[1 + static_cast<std::size_t>(line)];
    EXPECT_EQ(text.ns, "scale");
    EXPECT_EQ(text.type, Marker::TEXT_VIEW_FACING + 0);
    EXPECT_EQ(text.id, line) << "one for all layers";
    EXPECT_DOUBLE_EQ(text.pose.position.x, 0.0105);
    EXPECT_DOUBLE_EQ(text.scale.z, 0.0005) << "of a layer of 1 mm";
    EXPECT_EQ(text.text.find('\n'), std::string::npos) << "RViz sets lines a centimetre apart";
  }
  EXPECT_DOUBLE_EQ(scale.pose.position.z, 0.0075) << "three layers of 1.5 mm above one at 3 mm";
  EXPECT_DOUBLE_EQ(layer.pose.position.z, 0.0083) << "1.6 heights of its letters above it";
}

/// A print whose layers from the twelfth on were planned anew: the plan counts from 0.
TEST(DeviationMarkers, OfAPlanStandBesideThoseOfTheLayersBelowIt) {
  const auto markers = deviationMarkers(shownLayer(), 12, "bed", Eigen::Isometry3d::Identity()).markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].id, 13) << "the one of layer 1 of the print stays";
  EXPECT_EQ(markers[1].text, "layer 13: off by 0.250 mm (rms), -0.125 mm in the mean");
  EXPECT_EQ(markers[1].id, 0) << "one for all layers";
}

TEST(DeviationMarkers, AreFullAtTheEndOfTheirScaleAndBeyond) {
  EXPECT_FLOAT_EQ(deviationColour(0.0, 0.5).r, 1.0F);
  EXPECT_FLOAT_EQ(deviationColour(0.0, 0.5).b, 1.0F);
  EXPECT_FLOAT_EQ(deviationColour(9.0, 0.5).g, 0.12F);
  EXPECT_FLOAT_EQ(deviationColour(-9.0, 0.5).r, 0.12F);
}

TEST(DeviationMarkers, OfNothingAreNone) {
  EXPECT_TRUE(deviationMarkers({}, 0, "bed", Eigen::Isometry3d::Identity()).markers.empty());
  const auto markers = lamina::noDeviationMarkers("bed").markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
}

}  // namespace
