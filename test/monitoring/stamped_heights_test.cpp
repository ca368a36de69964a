// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/stamped_heights.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

#include "lamina/monitoring/layer_height_csv.hpp"
#include "support/scanned_plates.hpp"

namespace lamina {
namespace {

const Box2 kStampedHeightsPlate{Point2(5, 5), Point2(10, 8)};
constexpr std::size_t kLayers = 5;
constexpr std::int64_t kStep = 1'000'000;  // ns between two profiles
constexpr std::int64_t kScan = 100 * kStep;

double printHeight(std::size_t layer) { return 0.2 * static_cast<double>(layer + 1); }
double scanHeightOf(std::size_t layer) { return printHeight(layer) + 1.1; }
/// By how much a layer lies too high [mm]: another one each.
double offsetOf(std::size_t layer) { return 0.01 * static_cast<double>(layer + 1); }

/// What a machine and its sensor report of a print, each in the order of its stamps.
struct Recording {
  std::vector<StampedTip> poses;
  std::vector<StampedProfile> profiles;
};

/// A profile across the plate, a point a cell of 0.1 mm.
StampedProfile profileAt(std::int64_t stamp_ns, double y, double height) {
  StampedProfile profile{stamp_ns, {}};
  for (double x = 4.05; x < 11.0; x += 0.1) profile.points.emplace_back(x, y, height);
  return profile;
}

/// A layer is printed and scanned, a profile every 0.1 mm and a pose every 0.5 mm; the lift after it ends
/// with a profile that shows nothing.
void recordLayer(Recording& recording, std::size_t layer) {
  const auto begin = static_cast<std::int64_t>(layer) * kScan + kStep;
  for (std::int64_t i = 0; i < 3; ++i)
    recording.poses.push_back({begin + i * kStep, Point3(5.0 + double(i), 5.0, printHeight(layer))});
  recording.poses.push_back({begin + 3 * kStep, Point3(0, 4.05, scanHeightOf(layer))});
  for (std::int64_t i = 0; i <= 50; ++i) {
    const std::int64_t stamp_ns = begin + (4 + i) * kStep;
    const double y = 4.05 + 0.1 * double(i);
    if (i % 5 == 0) recording.poses.push_back({stamp_ns, Point3(0, y, scanHeightOf(layer))});
    recording.profiles.push_back(profileAt(stamp_ns, y, printHeight(layer) + offsetOf(layer)));
  }
  recording.poses.push_back({begin + 60 * kStep, Point3(0, 9, scanHeightOf(layer) + 5.0)});
  recording.profiles.push_back({begin + 60 * kStep, {}});
}

Recording recordingOf(const std::vector<std::size_t>& layers) {
  Recording recording;
  for (const std::size_t layer : layers) recordLayer(recording, layer);
  return recording;
}

Recording wholePrint() { return recordingOf({0, 1, 2, 3, 4}); }

StampedHeights plates(const MonitorSettings& settings = {}) {
  return StampedHeights(scannedPlates(std::vector<Box2>(kLayers, kStampedHeightsPlate)),
                        Eigen::Isometry3d::Identity(), settings);
}

/// Poses and profiles as they come, and the reports that they give.
class Feed {
 public:
  explicit Feed(StampedHeights& heights) : heights_(heights) {}

  void pose(const StampedTip& pose) { keep(heights_.observe(pose)); }
  void profile(const StampedProfile& profile) { keep(heights_.insert(profile)); }
  void all(const Recording& recording) {
    for (const StampedTip& each : recording.poses) pose(each);
    for (const StampedProfile& each : recording.profiles) profile(each);
  }
  void restartClock() { keep(heights_.restartClock()); }
  LayerHeightReports end() {
    keep(heights_.finish());
    return reports_;
  }
  const LayerHeightReports& reports() const { return reports_; }

 private:
  void keep(LayerHeightReports more) { std::move(more.begin(), more.end(), std::back_inserter(reports_)); }

  StampedHeights& heights_;
  LayerHeightReports reports_;
};

LayerHeightReports reportsOf(const Recording& recording) {
  StampedHeights heights = plates();
  Feed feed(heights);
  feed.all(recording);
  return feed.end();
}

/// Every bit of a report.
std::vector<std::uint64_t> bitsOf(const LayerHeightReports& reports) {
  std::vector<std::uint64_t> bits;
  for (const LayerHeightReport& report : reports) {
    const HeightStatistics& of = report.statistics;
    for (const double value : {report.expected_height_mm, of.mean_mm, of.rms_mm, of.worst_mm, of.coverage}) {
      std::uint64_t word = 0;
      std::memcpy(&word, &value, sizeof word);
      bits.push_back(word);
    }
    bits.insert(bits.end(),
                {report.layer, of.cells, report.profiles, static_cast<std::uint64_t>(report.sight)});
  }
  return bits;
}

/// Nothing is lost without a name.
void expectAccounted(const ProfileUse& use) {
  EXPECT_EQ(use.received.profiles, use.of_layers.profiles + use.of_no_layer.profiles + use.waiting.profiles +
                                       use.late.profiles + use.in_gap.profiles);
  EXPECT_EQ(use.received.points, use.of_layers.points + use.of_no_layer.points + use.waiting.points +
                                     use.late.points + use.in_gap.points);
}

void expectOffset(const LayerHeightReport& report) {
  EXPECT_EQ(report.sight, LayerSight::Seen) << "layer " << report.layer;
  EXPECT_DOUBLE_EQ(report.statistics.coverage, 1.0) << "layer " << report.layer;
  EXPECT_NEAR(report.statistics.mean_mm, offsetOf(report.layer), 1e-12) << "layer " << report.layer;
  EXPECT_NEAR(report.statistics.worst_mm, offsetOf(report.layer), 1e-12) << "layer " << report.layer;
}

/// Of a machine without a sensor nothing is kept without end.
TEST(StampedHeights, KeepTheLatestPosesThatNoProfileComesUpTo) {
  StampedHeights heights = plates();
  Feed feed(heights);
  const auto poses = static_cast<std::int64_t>(StampedHeights::kMostPoses) + 1000;
  for (std::int64_t i = 1; i <= poses; ++i) feed.pose({i * kStep, Point3(0.0, 0.0, 50.0)});
  feed.profile({500 * kStep, {Point3(6.0, 6.0, 0.2)}});
  EXPECT_EQ(heights.use().late.profiles, 1u) << "nobody knows any more where it was taken";
  feed.profile({2000 * kStep, {Point3(6.0, 6.0, 0.2)}});
  EXPECT_EQ(heights.use().of_no_layer.profiles, 1u);
  expectAccounted(heights.use());
}

TEST(StampedHeights, EachLayerHasItsOwnHeightAndAllIsAccountedFor) {
  StampedHeights heights = plates();
  Feed feed(heights);
  feed.all(wholePrint());
  const auto before_the_end = feed.reports().size();
  EXPECT_EQ(before_the_end, kLayers) << "the lift after the last scan ends it by the stamps";
  const LayerHeightReports reports = feed.end();
  ASSERT_EQ(reports.size(), kLayers);
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    EXPECT_EQ(reports[layer].layer, layer);
    EXPECT_EQ(reports[layer].profiles, 51u);
    expectOffset(reports[layer]);
  }
  const ProfileUse use = heights.use();
  expectAccounted(use);
  EXPECT_EQ(use.of_layers.profiles, 51u * kLayers);
  EXPECT_EQ(use.of_no_layer.profiles, kLayers);
  EXPECT_EQ(use.waiting.profiles, 0u);
}

TEST(StampedHeights, ProfilesWaitForPosesHoweverLateTheseAre) {
  const Recording recording = wholePrint();
  StampedHeights heights = plates();
  Feed feed(heights);
  for (const StampedProfile& profile : recording.profiles) feed.profile(profile);
  EXPECT_TRUE(feed.reports().empty());
  EXPECT_EQ(heights.use().waiting.profiles, recording.profiles.size());
  for (const StampedTip& pose : recording.poses) feed.pose(pose);
  EXPECT_EQ(heights.use().waiting.profiles, 0u);
  EXPECT_EQ(bitsOf(feed.end()), bitsOf(reportsOf(recording)));
}

TEST(StampedHeights, AnyInterleavingGivesTheSameReportsToTheBit) {
  const Recording recording = wholePrint();
  const auto expected = bitsOf(reportsOf(recording));
  EXPECT_TRUE(rc::check([&] {
    // So many poses come, then so many profiles, and so on; what is left comes at the end.
    const auto turns = *rc::gen::arbitrary<std::vector<std::pair<std::uint8_t, std::uint8_t>>>();
    StampedHeights heights = plates();
    Feed feed(heights);
    std::size_t pose = 0;
    std::size_t profile = 0;
    for (const auto& [poses, profiles] : turns) {
      for (std::size_t i = 0; i < poses && pose < recording.poses.size(); ++i)
        feed.pose(recording.poses[pose++]);
      for (std::size_t i = 0; i < profiles && profile < recording.profiles.size(); ++i)
        feed.profile(recording.profiles[profile++]);
    }
    while (profile < recording.profiles.size()) feed.profile(recording.profiles[profile++]);
    while (pose < recording.poses.size()) feed.pose(recording.poses[pose++]);
    RC_ASSERT(bitsOf(feed.end()) == expected);
    RC_ASSERT(heights.use().of_layers.profiles == 51u * kLayers);
  }));
}

TEST(StampedHeights, WhateverIsLostNoLayerIsGivenAnotherOnesPoints) {
  const Recording whole = wholePrint();
  EXPECT_TRUE(rc::check([&] {
    Recording left;
    const auto lost =
        *rc::gen::container<std::vector<bool>>(whole.profiles.size(), rc::gen::arbitrary<bool>());
    const auto dark = *rc::gen::container<std::vector<bool>>(kLayers, rc::gen::arbitrary<bool>());
    left.poses = whole.poses;
    std::size_t last_seen = 0;
    for (std::size_t i = 0; i < whole.profiles.size(); ++i) {
      const std::size_t layer = i / 52;
      if (lost[i] || dark[layer]) continue;
      left.profiles.push_back(whole.profiles[i]);
      last_seen = layer;
    }
    RC_PRE(!left.profiles.empty());
    const LayerHeightReports reports = reportsOf(left);
    RC_ASSERT(reports.size() == kLayers);
    for (std::size_t layer = 0; layer < kLayers; ++layer) {
      const LayerHeightReport& report = reports[layer];
      RC_ASSERT(report.layer == layer);
      RC_ASSERT(!dark[layer] || report.sight == LayerSight::NotSeen);
      RC_ASSERT((report.sight == LayerSight::NotSeen) == (report.statistics.cells == 0));
      if (report.statistics.cells == 0) continue;
      RC_ASSERT(std::abs(report.statistics.mean_mm - offsetOf(layer)) < 1e-12);
      RC_ASSERT(std::abs(report.statistics.worst_mm - offsetOf(layer)) < 1e-12);
    }
    RC_ASSERT(last_seen < kLayers);
  }));
}

TEST(StampedHeights, ALayerWhoseProfilesAllGotLostIsNotSeenAndTheOthersAreAsTheyAre) {
  Recording recording = wholePrint();
  auto& profiles = recording.profiles;
  profiles.erase(profiles.begin() + 52, profiles.begin() + 104);
  const LayerHeightReports reports = reportsOf(recording);
  ASSERT_EQ(reports.size(), kLayers);
  EXPECT_EQ(reports[1].layer, 1u);
  EXPECT_EQ(reports[1].sight, LayerSight::NotSeen);
  for (const std::size_t layer : {0u, 2u, 3u, 4u}) expectOffset(reports[layer]);
}

TEST(StampedHeights, ALostLastLayerIsNotSeenAtTheEnd) {
  Recording recording = wholePrint();
  recording.profiles.erase(recording.profiles.end() - 52, recording.profiles.end());
  const LayerHeightReports reports = reportsOf(recording);
  ASSERT_EQ(reports.size(), kLayers);
  EXPECT_EQ(reports[4].sight, LayerSight::NotSeen);
  expectOffset(reports[3]);
}

TEST(StampedHeights, ALayerThatIsScannedAfterALaterOneGivesItsPointsToNoOther) {
  Recording recording = recordingOf({0, 2, 1, 3, 4});
  for (std::size_t i = 0; i < recording.profiles.size(); ++i)
    recording.profiles[i].stamp_ns =
        static_cast<std::int64_t>(i / 52) * kScan + recording.profiles[i].stamp_ns % kScan;
  const std::size_t poses_a_layer = recording.poses.size() / kLayers;
  for (std::size_t i = 0; i < recording.poses.size(); ++i)
    recording.poses[i].stamp_ns =
        static_cast<std::int64_t>(i / poses_a_layer) * kScan + recording.poses[i].stamp_ns % kScan;
  const LayerHeightReports reports = reportsOf(recording);
  ASSERT_EQ(reports.size(), kLayers);
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    EXPECT_EQ(reports[layer].layer, layer);
    if (layer == 1)
      EXPECT_EQ(reports[layer].sight, LayerSight::NotSeen);
    else
      expectOffset(reports[layer]);
  }
}

TEST(StampedHeights, AProfileThatComesAfterALaterOneIsCountedAndNotUsed) {
  Recording recording = wholePrint();
  std::swap(recording.profiles[40], recording.profiles[70]);  // of layers 0 and 1
  StampedHeights heights = plates();
  Feed feed(heights);
  feed.all(recording);
  const LayerHeightReports reports = feed.end();
  const ProfileUse use = heights.use();
  expectAccounted(use);
  EXPECT_EQ(use.late.profiles, 30u) << "those between the two, and the older of them";
  EXPECT_EQ(use.late.points, 70u * 29u) << "one of them shows nothing";
  ASSERT_EQ(reports.size(), kLayers);
  for (const LayerHeightReport& report : reports)
    EXPECT_NEAR(report.statistics.worst_mm, offsetOf(report.layer), 1e-12);
}

TEST(StampedHeights, GoesOnWhenTheClockOfTheStampsGoesBack) {
  Recording after = recordingOf({2, 3, 4});
  for (StampedTip& pose : after.poses) pose.stamp_ns -= 2 * kScan;
  for (StampedProfile& profile : after.profiles) profile.stamp_ns -= 2 * kScan;
  StampedHeights heights = plates();
  Feed feed(heights);
  feed.all(recordingOf({0, 1}));
  feed.profile(profileAt(10 * kScan, 4.05, 0.0));  // of which no pose comes any more
  feed.restartClock();
  feed.all(after);
  const LayerHeightReports reports = feed.end();
  expectAccounted(heights.use());
  EXPECT_EQ(heights.use().late.profiles, 1u);
  ASSERT_EQ(reports.size(), kLayers);
  for (const LayerHeightReport& report : reports) expectOffset(report);
}

TEST(StampedHeights, ProfilesInAGapOfThePosesAreCountedAndNotUsed) {
  Recording recording = wholePrint();
  const auto is_lost = [](const StampedTip& pose) {
    return pose.stamp_ns > 20 * kStep && pose.stamp_ns < 40 * kStep;  // in the middle of the first scan
  };
  recording.poses.erase(std::remove_if(recording.poses.begin(), recording.poses.end(), is_lost),
                        recording.poses.end());
  MonitorSettings settings;
  settings.pose_gap_mm = 1.0;
  StampedHeights heights = plates(settings);
  Feed feed(heights);
  feed.all(recording);
  const LayerHeightReports reports = feed.end();
  const ProfileUse use = heights.use();
  expectAccounted(use);
  // Poses are left at 5 + 5 i ms: one at 20 ms and one at 40 ms, with 19 profiles in between.
  EXPECT_EQ(use.in_gap.profiles, 19u);
  ASSERT_EQ(reports.size(), kLayers);
  EXPECT_EQ(reports[0].profiles, 51u - 19u);
  EXPECT_NEAR(reports[0].statistics.worst_mm, offsetOf(0), 1e-12);
  EXPECT_LT(reports[0].statistics.coverage, 0.5);
  expectOffset(reports[1]);
}

TEST(StampedHeights, AScanFallsQuietByTheStampsAlone) {
  Recording recording = recordingOf({0});
  recording.poses.pop_back();
  recording.profiles.pop_back();
  // The nozzle stays where the scan ended, and the sensor goes on.
  const StampedTip rest = recording.poses.back();
  for (std::int64_t i = 1; i <= 30; ++i) {
    recording.poses.push_back({rest.stamp_ns + i * 100 * kStep, rest.tip});
    recording.profiles.push_back(profileAt(rest.stamp_ns + i * 100 * kStep, 9.05, 0.0));
  }
  for (const double quiet_s : {1.0, 2.0}) {
    MonitorSettings settings;
    settings.quiet_s = quiet_s;
    StampedHeights heights = plates(settings);
    Feed feed(heights);
    feed.all(recording);
    ASSERT_EQ(feed.reports().size(), 1u);
    EXPECT_EQ(feed.reports()[0].sight, LayerSight::Seen);
    EXPECT_EQ(static_cast<double>(feed.reports()[0].profiles), 51.0 + 10.0 * quiet_s + 1.0)
        << "until more than that time has passed";
  }
}

TEST(StampedHeights, ARestOfTheMachineInItsScanDoesNotEndIt) {
  // After its 30th profile the machine waits for its host for a minute; its sensor takes no profiles
  // meanwhile.
  Recording recording = recordingOf({0});
  const std::int64_t rest_begin = recording.profiles[29].stamp_ns;
  constexpr std::int64_t kRest = 60'000 * kStep;
  const StampedTip last{rest_begin, Point3(0, 4.05 + 0.1 * 29, scanHeightOf(0))};
  for (StampedTip& pose : recording.poses)
    if (pose.stamp_ns > rest_begin) pose.stamp_ns += kRest;
  recording.poses.push_back(last);
  recording.poses.push_back({last.stamp_ns + kRest, last.tip});
  for (StampedProfile& profile : recording.profiles)
    if (profile.stamp_ns > rest_begin) profile.stamp_ns += kRest;
  // The first profile after it shows nothing new.
  recording.profiles.insert(recording.profiles.begin() + 30,
                            profileAt(rest_begin + kRest, 4.05 + 0.1 * 29, 0.21));
  const LayerHeightReports reports = reportsOf(recording);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].profiles, 52u);
  EXPECT_DOUBLE_EQ(reports[0].statistics.coverage, 1.0);
}

TEST(StampedHeights, AScanThatIsGivenUpIsCutShort) {
  const Recording recording = recordingOf({0});
  StampedHeights heights = plates();
  for (std::size_t i = 0; i < 30; ++i) heights.insert(recording.profiles[i]);
  for (const StampedTip& pose : recording.poses) EXPECT_TRUE(heights.observe(pose).empty());
  const LayerHeightReports reports = heights.cutShort();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].sight, LayerSight::CutShort);
  EXPECT_EQ(reports[0].profiles, 30u);
  EXPECT_TRUE(heights.finish().empty());
}

}  // namespace
}  // namespace lamina
