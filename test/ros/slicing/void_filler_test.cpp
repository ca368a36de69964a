// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Calls the running node void_filler as a client would.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "service_call.hpp"
#include "support/drop_programs.hpp"
#include "support/plain_job.hpp"
#include "support/scratch_folder.hpp"

namespace {

using lamina_msgs::FillVoids;
using lamina_msgs::Status;

constexpr double kFillPatience = 240.0;  // s: far above what a job takes, for loaded machines

class VoidFiller : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForExistence(ros::Duration(kFillPatience))); }

  FillVoids::Response call(const std::string& program, const std::string& part = "",
                           const std::vector<lamina_msgs::Setting>& settings = {}) {
    FillVoids service;
    service.request.program = program;
    service.request.output = output_;
    service.request.part = part;
    service.request.settings = settings;
    EXPECT_TRUE(lamina::callService(client_.getService(), service)) << "the node does not answer";
    return service.response;
  }

  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }

  /// A box of 20 mm whose infill leaves every other line open.
  std::string slicedBox() const {
    lamina::SliceJob job = lamina::test::plainJob();
    job.part = "box";
    job.output = folder_.file("box.gcode");
    job.settings.planning.infill.density = 0.5;
    job.settings.slicing.layer_height_mm = 0.4;
    job.settings.slicing.first_layer_height_mm = 0.4;
    lamina::NoProgress progress;
    runSliceJob(job, progress);
    return job.output;
  }

  /// A tube filled by a Hilbert curve, which leaves voids along its round walls.
  std::string slicedTube() const {
    lamina::SliceJob job = lamina::test::plainJob();
    job.part = "tube";
    job.output = folder_.file("tube.gcode");
    job.settings.planning.infill.strategy = "hilbert";
    job.settings.planning.infill.density = 1.0;
    job.settings.planning.bead.width_mm = 0.8;
    job.settings.slicing.layer_height_mm = 0.5;
    job.settings.slicing.first_layer_height_mm = 0.5;
    lamina::NoProgress progress;
    runSliceJob(job, progress);
    return job.output;
  }

  void expectRefused(const FillVoids::Response& response, std::uint8_t code, const std::string& word) {
    EXPECT_EQ(response.status.code + 0, code + 0) << response.status.message;
    EXPECT_NE(response.status.message.find(word), std::string::npos) << response.status.message;
    EXPECT_FALSE(std::filesystem::exists(output_)) << "something was written";
  }

  ros::NodeHandle node_;
  ros::ServiceClient client_ = node_.serviceClient<FillVoids>(lamina::names::kFillVoids);
  lamina::test::ScratchFolder folder_;
  std::string output_ = folder_.file("filled.gcode");
};

TEST_F(VoidFiller, PutsMissingDropsIntoAProgramOfDrops) {
  const std::string text = lamina::test::squareProgram({{4, 4}, lamina::test::kNoneMissing, {2, 6}});
  const auto response = call(written("drops.gcode", text));
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  const auto& summary = response.summary;
  EXPECT_TRUE(summary.lays_drops);
  EXPECT_EQ(summary.layers, 3U);
  EXPECT_EQ(summary.layers_filled, 2U);
  EXPECT_EQ(summary.voids, 2U);
  EXPECT_EQ(summary.drops_added, 2U);
  EXPECT_EQ(summary.runs_added, 0U);
  EXPECT_TRUE(summary.is_worth_it);
  EXPECT_LT(summary.uncovered_after, summary.uncovered_before);
  EXPECT_NEAR(summary.greatest_overlap, 0.0, 1e-9);
  std::uint32_t classed = 0;
  for (const auto& each : summary.voids_by_class) classed += each.count;
  EXPECT_EQ(classed, 2U);
  ASSERT_EQ(response.voids.size(), 2U);
  EXPECT_EQ(response.voids[1].layer, 2U);
  EXPECT_NEAR(response.voids[1].greatest_clearance, 0.001, 1e-12) << "a pitch, in metres";
  ASSERT_EQ(response.voids[1].drops.size(), 1U);
  EXPECT_NEAR(response.voids[1].drops[0].x, 0.012, 1e-9);
  EXPECT_NEAR(response.voids[1].drops[0].y, 0.026, 1e-9);
  EXPECT_NEAR(response.voids[1].drops[0].z, 0.003, 1e-9);
  const std::string filled = lamina::readFile(output_);
  EXPECT_NE(filled.find("G1 X12 Y26\nM780 P3\n"), std::string::npos);
}

TEST_F(VoidFiller, ShowsTheNewDropsAsMarkers) {
  const std::string text = lamina::test::squareProgram({{4, 4}, {3, 3}});
  ASSERT_EQ(call(written("drops.gcode", text)).status.code, Status::OK + 0);
  const auto markers = ros::topic::waitForMessage<visualization_msgs::MarkerArray>(
      lamina::names::kVoidMarkers, node_, ros::Duration(kFillPatience));
  ASSERT_TRUE(markers);
  std::size_t points = 0;
  for (const auto& marker : markers->markers) {
    EXPECT_EQ(marker.header.frame_id, lamina::names::kBedFrame);
    points += marker.points.size();
  }
  EXPECT_EQ(points, 2U);
}

TEST_F(VoidFiller, LaysRunsIntoTheVoidsOfAProgramOfBeads) {
  const auto response = call(slicedTube(), "tube");
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  const auto& summary = response.summary;
  EXPECT_FALSE(summary.lays_drops);
  EXPECT_EQ(summary.layers, summary.layers_filled);
  EXPECT_GT(summary.runs_added, summary.layers);
  EXPECT_EQ(summary.drops_added, 0U);
  EXPECT_LT(summary.uncovered_after, 0.5 * summary.uncovered_before);
  EXPECT_GT(std::filesystem::file_size(output_), std::filesystem::file_size(folder_.file("tube.gcode")));
}

TEST_F(VoidFiller, TakesWhatIsDepositedBesideThePartForOverfill) {
  // 0.6 mm of filament of 1.75 mm along 10 mm, in a layer of 0.4 mm; with round ends.
  const double width = 0.6e-3 * M_PI / 4.0 * 1.75e-3 * 1.75e-3 / (10e-3 * 0.4e-3);
  const double area = width * 10e-3 + M_PI / 4.0 * width * width;
  std::string text = lamina::readFile(slicedBox());
  const auto usual = call(folder_.file("box.gcode"), "box").summary;
  text.insert(text.rfind("; end of the part"), "G0 X130 Y105 F9000\nG1 Y115 E0.6 F1800\n");
  const auto beside = call(written("beside.gcode", text), "box").summary;
  EXPECT_NEAR(beside.overfill_before - usual.overfill_before, area, 0.02 * area);
  EXPECT_NEAR(beside.overfill_after - usual.overfill_after, area, 0.02 * area);
}

double areaWithin(const std::vector<geometry_msgs::Point>& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
    doubled += outline[j].x * outline[i].y - outline[i].x * outline[j].y;
  return 0.5 * doubled;
}

TEST_F(VoidFiller, ReportsEachVoidBetweenBeads) {
  const auto response = call(slicedBox(), "box");
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  ASSERT_EQ(response.voids.size(), response.summary.voids);
  std::map<std::string, std::uint32_t> classes;
  double uncovered = 0.0;
  for (const auto& each : response.voids) {
    EXPECT_LT(each.layer, response.summary.layers);
    ++classes[each.kind];
    uncovered += each.uncovered_before;
    EXPECT_TRUE(std::isnan(each.uncovered_after) && std::isnan(each.greatest_clearance));
    EXPECT_TRUE(each.drops.empty());
    ASSERT_GE(each.outline.size(), 3U);
    EXPECT_GT(areaWithin(each.outline), 0.0);
    EXPECT_NEAR(each.outline.front().z, 0.4e-3 * (each.layer + 1), 1e-9) << "the top of its layer";
  }
  for (const auto& counted : response.summary.voids_by_class)
    EXPECT_EQ(classes[counted.kind], counted.count) << counted.kind;
  EXPECT_LE(uncovered, response.summary.uncovered_before * (1.0 + 1e-9));
  EXPECT_GT(uncovered, 0.9 * response.summary.uncovered_before) << "all but the smallest are listed";
}

TEST_F(VoidFiller, DrawsLinesRoundTheVoidsBetweenBeads) {
  const auto response = call(slicedBox(), "box");
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  const auto markers = ros::topic::waitForMessage<visualization_msgs::MarkerArray>(
      lamina::names::kVoidMarkers, node_, ros::Duration(kFillPatience));
  ASSERT_TRUE(markers);
  ASSERT_EQ(markers->markers.size(), 1 + response.summary.voids_by_class.size());
  std::size_t sides = 0;
  for (const auto& each : response.voids) sides += each.outline.size();
  std::size_t points = 0;
  for (std::size_t i = 1; i < markers->markers.size(); ++i) {
    const auto& marker = markers->markers[i];
    EXPECT_EQ(marker.header.frame_id, lamina::names::kBedFrame);
    EXPECT_EQ(marker.type, visualization_msgs::Marker::LINE_LIST + 0);
    points += marker.points.size();
  }
  EXPECT_GE(points, 2 * sides) << "a line per side, and those of holes";
}

TEST_F(VoidFiller, OverridesItsSettingsForOneRequestOnly) {
  const std::string program =
      written("drops.gcode", lamina::test::squareProgram({lamina::test::kNoneMissing}));
  lamina_msgs::Setting overlap;
  overlap.key = "drop_voids.overlap";
  overlap.value = "0.3";
  const auto filled = call(program, "", {overlap}).summary;
  EXPECT_GE(filled.drops_added, 64U) << "the pores of a square lattice";
  // Each overlaps four drops, their centres apart by sqrt(1/2) of a diameter, by a lens of 1/2 - 1/pi.
  const double lenses = 4.0 * (0.5 - M_1_PI) * filled.drops_added;
  EXPECT_NEAR(filled.overlap_per_drop, lenses / (81.0 + filled.drops_added), 1e-6);
  EXPECT_EQ(call(program).summary.drops_added, 0U);
}

TEST_F(VoidFiller, RefusesAProgramOfBeadsWithoutItsPart) {
  expectRefused(call(slicedBox()), Status::INVALID_INPUT, "part");
}

TEST_F(VoidFiller, RefusesAMissingProgramAndAnUnknownSetting) {
  expectRefused(call(folder_.file("none.gcode")), Status::FILE_ERROR, "none.gcode");
  expectRefused(call(written("d.gcode", lamina::test::squareProgram({{4, 4}})), "",
                     {lamina::settingMessage("drop_voids.overlapp", "0.3")}),
                Status::INVALID_CONFIG, "drop_voids.overlap");
}

TEST_F(VoidFiller, NeverOverwritesTheProgramItReads) {
  const std::string text = lamina::test::squareProgram({{4, 4}});
  output_ = written("drops.gcode", text);
  EXPECT_EQ(call(output_).status.code, Status::INVALID_INPUT + 0);
  EXPECT_EQ(lamina::readFile(output_), text);
}

}  // namespace
