// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/overhang_markers.hpp"

#include <gtest/gtest.h>

#include <map>

namespace {

using lamina::OverhangReport;
using lamina::StretchKind;
using lamina::UnsupportedStretch;
using visualization_msgs::Marker;

UnsupportedStretch stretch(StretchKind kind, bool begins_run) {
  UnsupportedStretch found;
  found.kind = kind;
  found.begins_run = begins_run;
  found.width_mm = 0.4;
  found.points = {{0, 0, 1}, {1, 0, 1}, {1, 2, 1}};
  return found;
}

TEST(OverhangMarkers, OfNothingDeleteTheOldOnes) {
  const auto markers = lamina::overhangMarkers(OverhangReport(), "part").markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
}

TEST(OverhangMarkers, HoldEverySegmentInTheNamespaceOfItsKindAndEachStart) {
  OverhangReport report;
  const int count = 15000;
  for (int i = 0; i < count; ++i) report.stretches.push_back(stretch(StretchKind::Overhang, i % 2 == 0));
  report.stretches.push_back(stretch(StretchKind::Bridge, false));
  std::map<std::string, std::size_t> points;
  std::map<std::string, std::size_t> markers;
  for (const Marker& marker : lamina::overhangMarkers(report, "part").markers) {
    EXPECT_EQ(marker.header.frame_id, "part");
    if (marker.action != Marker::ADD) continue;
    EXPECT_TRUE(marker.frame_locked);
    points[marker.ns] += marker.points.size();
    EXPECT_EQ(marker.id, static_cast<int>(markers[marker.ns]++)) << "unique in its namespace";
  }
  EXPECT_EQ(points.at("overhang"), 4U * count);
  EXPECT_EQ(points.at("bridge"), 4U);
  EXPECT_EQ(points.at("start_in_air"), count / 2U);
  EXPECT_EQ(markers.at("overhang"), 2U);
}

TEST(OverhangMarkers, AreAsWideAsTheBeadInMetres) {
  OverhangReport report;
  report.stretches = {stretch(StretchKind::Bridge, false)};
  const auto markers = lamina::overhangMarkers(report, "part").markers;
  ASSERT_EQ(markers.size(), 2U);
  EXPECT_DOUBLE_EQ(markers[1].scale.x, 0.0004);
  EXPECT_DOUBLE_EQ(markers[1].points[3].y, 0.002);
}

}  // namespace
