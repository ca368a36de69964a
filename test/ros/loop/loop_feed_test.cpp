// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/loop_feed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/make_shared.hpp>

#include "correction_messages.hpp"
#include "lamina/base/error.hpp"
#include "ros/loop/wall_messages.hpp"
#include "ros/set_time.hpp"

namespace lamina {
namespace {

using test::SensedWall;

constexpr std::int64_t kWentBack = 900'000'000'000;  // ns

/// Poses of the nozzle and the clouds up to each, in ROS time.
void feedWall(LoopFeed& feed, const SensedWall& wall, const test::SetTime& time) {
  std::size_t cloud = 0;
  for (const StampedTip& tip : wall.tips) {
    time.set(test::timeOf(tip.stamp_ns));
    feed.add(test::nozzleMessage(tip).transforms[0], "test");
    feed.pass();
    for (; cloud < wall.clouds.size() && wall.clouds[cloud].stamp_ns <= tip.stamp_ns; ++cloud)
      feed.add(boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(wall.clouds[cloud])));
    feed.pass();
  }
}

/// Its first layers, or those after them by a clock that was set.
SensedWall partOf(const SensedWall& wall, std::int64_t from_ns, std::int64_t until_ns, std::int64_t back_ns) {
  SensedWall part;
  for (StampedTip tip : wall.tips) {
    if (tip.stamp_ns < from_ns || tip.stamp_ns >= until_ns) continue;
    tip.stamp_ns -= back_ns;
    part.tips.push_back(tip);
  }
  for (SensedCloud cloud : wall.clouds) {
    if (cloud.stamp_ns < from_ns || cloud.stamp_ns >= until_ns) continue;
    cloud.stamp_ns -= back_ns;
    part.clouds.push_back(std::move(cloud));
  }
  return part;
}

TEST(LoopFeed, GoesOnWithThePrintWhenRosTimeGoesBack) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  const SensedWall printed = test::sensedWall(wall);
  const std::int64_t half_ns = printed.tips[printed.tips.size() / 2].stamp_ns;
  const std::int64_t end_ns = printed.tips.back().stamp_ns + 1;
  const test::SetTime time;
  LoopFeed feed(wall.settings, 100.0);
  feed.add(test::toolpathMessage(printed));
  feed.addFixed(test::sensorMessage().transforms[0], "test");
  feedWall(feed, partOf(printed, 0, half_ns, 0), time);
  feedWall(feed, partOf(printed, half_ns, end_ns, kWentBack), time);
  feed.finish();
  const LoopCounts& counts = feed.run()->counts();
  EXPECT_GT(10 * counts.poses, 9 * printed.tips.size());
  EXPECT_EQ(counts.poses_late, 0U);
  EXPECT_EQ(counts.clouds_late, 0U);
  EXPECT_EQ(feed.run()->takeNews().layers.size(), wall.layers);
}

/// All of a print comes before its toolpath, and clouds of a sensor that tf does not know among them.
TEST(LoopFeed, PlacesWhatCameBeforeTheToolpath) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  const SensedWall printed = test::sensedWall(wall);
  const test::SetTime time;
  time.set(test::timeOf(printed.tips.back().stamp_ns));
  wall.settings.calibration.other_time_offsets_s = {{"nowhere", "0"}};
  LoopFeed feed(wall.settings, 1000.0);
  feed.addFixed(test::sensorMessage().transforms[0], "test");
  for (const SensedCloud& cloud : printed.clouds) {
    auto known = boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(cloud));
    auto unknown = boost::make_shared<sensor_msgs::PointCloud2>(*known);
    unknown->header.frame_id = "nowhere";
    feed.add(unknown);
    feed.add(known);
  }
  for (const StampedTip& tip : printed.tips) feed.add(test::nozzleMessage(tip).transforms[0], "test");
  feed.pass();
  EXPECT_EQ(feed.counts().waiting, 2 * printed.clouds.size());
  feed.add(test::toolpathMessage(printed));
  feed.finish();
  EXPECT_EQ(feed.counts().waiting, printed.clouds.size());
  EXPECT_EQ(feed.counts().placed + feed.counts().without_transform, printed.clouds.size());
  EXPECT_GT(10 * feed.counts().placed, 9 * printed.clouds.size());
  EXPECT_EQ(feed.run()->takeNews().layers.size(), wall.layers);
}

bool isWithoutTransforms(LoopFeed& feed) {
  const LoopNews news = feed.run()->takeNews();
  return std::any_of(news.alarms.begin(), news.alarms.end(),
                     [](const RaisedAlarm& alarm) { return alarm.alarm == LoopAlarm::NoTransform; });
}

std_msgs::Header heardAt(const ros::Time& stamp, const std::string& frame = names::kSensorFrame) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frame;
  return header;
}

TEST(LoopFeed, ASingleStampFarAheadSaysNothingOfTf) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  const SensedWall printed = test::sensedWall(wall);
  const test::SetTime time;
  LoopFeed feed(wall.settings, 100.0);
  feed.add(test::toolpathMessage(printed));
  feed.addFixed(test::sensorMessage().transforms[0], "test");
  feed.request(LoopRequest::Active);
  for (const StampedTip& tip : printed.tips) {
    const ros::Time now = test::timeOf(tip.stamp_ns);
    time.set(now);
    feed.add(test::nozzleMessage(tip).transforms[0], "test");
    feed.hear(heardAt(now));
    feed.pass();
    if (feed.run()->place().is_scanning) break;
  }
  ASSERT_TRUE(feed.run()->place().is_scanning);
  const ros::Time ahead = ros::Time::now() + ros::Duration(100.0);
  feed.hear(heardAt(ahead));
  feed.hear(heardAt(ros::Time::now()));
  feed.pass();
  EXPECT_FALSE(isWithoutTransforms(feed));
  feed.hear(heardAt(ahead));
  feed.pass();
  EXPECT_FALSE(isWithoutTransforms(feed));
  feed.hear(heardAt(ahead + ros::Duration(0.02)));
  feed.pass();
  EXPECT_TRUE(isWithoutTransforms(feed));
}

/// A print whose sensor is calibrated and whose clouds come a second time, by a sensor half a metre beside
/// it.
std::uint64_t pointsUsed(const SensedWall& printed, LoopRunSettings settings, const std::string& second) {
  settings.calibration.nozzle_from_sensor = test::sensorOfWall();
  settings.calibration.other_time_offsets_s = {{"second_sensor", "0"}};
  const test::SetTime time;
  time.set(test::timeOf(printed.tips.back().stamp_ns));
  LoopFeed feed(settings, 1000.0);
  tf2_msgs::TFMessage beside = test::sensorMessage(Point3(500.0, 0.0, 0.0));
  beside.transforms[0].child_frame_id = "second_sensor";
  feed.addFixed(beside.transforms[0], "test");
  feed.add(test::toolpathMessage(printed));
  for (const SensedCloud& cloud : printed.clouds) {
    auto first = boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(cloud));
    auto other = boost::make_shared<sensor_msgs::PointCloud2>(*first);
    other->header.frame_id = second;
    if (!second.empty()) feed.add(other);
    feed.add(first);
  }
  for (const StampedTip& tip : printed.tips) feed.add(test::nozzleMessage(tip).transforms[0], "test");
  feed.finish();
  EXPECT_EQ(feed.counts().without_transform + feed.counts().placed, feed.counts().received);
  return feed.run()->counts().points.used;
}

/// How a wall came out of a print that two sensors of different clocks see, 20 ms and 70 ms late.
struct SeenTwice {
  FeedCounts counts;
  std::vector<LayerOutcome> layers;
};

SeenTwice seenTwice(const SensedWall& printed, LoopRunSettings settings) {
  settings.calibration.time_offset_s = 0.02;
  const test::SetTime time;
  time.set(test::timeOf(printed.tips.back().stamp_ns));
  LoopFeed feed(settings, 1000.0);
  tf2_msgs::TFMessage fixed = test::sensorMessage();
  feed.addFixed(fixed.transforms[0], "test");
  fixed.transforms[0].child_frame_id = "left";
  feed.addFixed(fixed.transforms[0], "test");
  feed.add(test::toolpathMessage(printed));
  for (const SensedCloud& cloud : printed.clouds) {
    auto left = boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(cloud, 0.07));
    left->header.frame_id = "/left";  // as drivers from before tf2 write it
    feed.add(left);
    feed.add(boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(cloud, 0.02)));
  }
  for (const StampedTip& tip : printed.tips) feed.add(test::nozzleMessage(tip).transforms[0], "test");
  feed.finish();
  return {feed.counts(), feed.run()->takeNews().layers};
}

/// Of each sensor the clouds are placed by its own clock: with that of the first one the second one would see
/// everything 2.4 mm off.
TEST(LoopFeed, TakesTheTimeOffsetOfEachSensor) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = 3;
  wall.befalls = [](std::size_t, std::vector<double>& heights) {
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += i % 20 < 10 ? 0.1 : -0.1;  // steps
  };
  const SensedWall printed = test::sensedWall(wall);
  wall.settings.calibration.other_time_offsets_s = {{"left", "0.07"}};
  const SeenTwice both = seenTwice(printed, wall.settings);
  EXPECT_EQ(both.counts.without_offset, 0U);
  ASSERT_EQ(both.layers.size(), wall.layers);
  EXPECT_NEAR(both.layers[2].figures.rmse_mm, printed.layers[2].figures.rmse_mm, 0.002);
  wall.settings.calibration.other_time_offsets_s = {};
  const SeenTwice one = seenTwice(printed, wall.settings);
  EXPECT_EQ(one.counts.without_offset, printed.clouds.size() - 1)
      << "the first one came before the calibrated sensor's";
  EXPECT_EQ(one.counts.last_without_offset, "/left");
  EXPECT_EQ(one.counts.received,
            one.counts.placed + one.counts.without_transform + one.counts.without_offset);
  ASSERT_EQ(one.layers.size(), wall.layers);
  EXPECT_NEAR(one.layers[2].figures.rmse_mm, printed.layers[2].figures.rmse_mm, 0.002);
}

/// Of 100 clouds of a print before 7 still wait, of which the next one gets none.
TEST(LoopFeed, CountsTheCloudsOfEachPrint) {
  FeedCounts then;
  then.received = 100;
  then.placed = 80;
  then.without_frame = 1;
  then.without_offset = 2;
  then.malformed = 3;
  then.without_transform = 4;
  then.pushed_out = 3;
  then.waiting = 7;
  FeedCounts now = then;
  now.received = 160;
  now.placed = 130;
  now.without_offset = 12;
  now.of_former_print = 7;
  now.waiting = 0;
  const FeedCounts counts = since(then, now);
  EXPECT_EQ(counts.received, 67U) << "60 that came and 7 that waited";
  EXPECT_EQ(counts.placed, 50U);
  EXPECT_EQ(counts.without_offset, 10U);
  EXPECT_EQ(counts.received, counts.placed + counts.without_frame + counts.without_offset + counts.malformed +
                                 counts.without_transform + counts.pushed_out + counts.waiting +
                                 counts.of_former_print);
}

/// By the digest of what a layer was deposited by the loop knows that this was its coasting map.
TEST(LoopFeed, KnowsACoastingMapByTheDigestThatIsReported) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  const SensedWall printed = test::sensedWall(wall);
  const test::SetTime time;
  LoopFeed feed(wall.settings, 100.0);
  feed.add(test::toolpathMessage(printed));
  feed.addFixed(test::sensorMessage().transforms[0], "test");
  ASSERT_NE(feed.run()->coastingMap(1), nullptr);
  const std::string digest = toMessage(*feed.run()->coastingMap(1)).digest;
  const std::string& id = printed.part.toolpath_id;
  EXPECT_TRUE(feed.add(toMessage(MissedMap{1, 2.0, {}, {}, true}, id, digest)));
  feedWall(feed, printed, time);
  feed.finish();
  const LoopNews news = feed.run()->takeNews();
  ASSERT_GT(news.layers.size(), 2U);
  EXPECT_EQ(news.layers[1].state, LoopState::Coasting);
  ASSERT_FALSE(news.layers[1].alarms.empty());
  EXPECT_EQ(news.layers[1].alarms[0].reason,
            "layer 1 is deposited by its coasting map, not by its map: none came within 2 s");
  EXPECT_EQ(news.layers[2].state, LoopState::Active);
}

TEST(LoopFeed, RefusesATimeOffsetThatIsNone) {
  LoopRunSettings settings;
  settings.calibration.other_time_offsets_s = {{"left", "70 ms"}};
  try {
    const LoopFeed feed(settings, 1.0);
    FAIL() << "expected it to be refused";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("sensor.other_time_offsets_s.left"), std::string::npos)
        << error.what();
  }
}

/// What a camera sees elsewhere is not taken to lie below the calibrated sensor.
TEST(LoopFeed, PlacesOnlyTheCalibratedSensorByItsCalibration) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = 2;
  const SensedWall printed = test::sensedWall(wall);
  const std::uint64_t alone = pointsUsed(printed, wall.settings, "");
  EXPECT_GT(alone, 1000U);
  EXPECT_EQ(pointsUsed(printed, wall.settings, "second_sensor"), alone);
}

/// A driver that names a frame of which nobody told tf.
/// Alarms of a wall of which clouds of another sensor are heard, that none of placed, and of the calibrated
/// one a single one at the start.
std::vector<LoopAlarm> alarmsHearing(LoopRunSettings settings, double late_s, double silence_s) {
  settings.loop.silence_s = silence_s;
  test::SensedWallCase wall;
  wall.settings = settings;
  wall.layers = 2;
  const SensedWall printed = test::sensedWall(wall);
  const test::SetTime time;
  LoopFeed feed(settings, 1000.0);
  feed.add(test::toolpathMessage(printed));
  feed.hear(heardAt(test::timeOf(printed.tips[0].stamp_ns)));
  for (const StampedTip& tip : printed.tips) {
    const ros::Time now = test::timeOf(tip.stamp_ns);
    time.set(now);
    feed.add(test::nozzleMessage(tip).transforms[0], "test");
    feed.hear(heardAt(now + ros::Duration(late_s), "left"));
    feed.pass();
  }
  std::vector<LoopAlarm> alarms;
  for (const RaisedAlarm& alarm : feed.run()->takeNews().alarms) alarms.push_back(alarm.alarm);
  return alarms;
}

TEST(LoopFeed, HearsEachSensorByItsOwnTimeOffset) {
  LoopRunSettings settings = test::calibratedLoop();
  settings.calibration.other_time_offsets_s = {{"left", "5"}};
  EXPECT_TRUE(alarmsHearing(settings, 5.0, 4.0).empty()) << "scans take 1.25 s";
  settings.calibration.other_time_offsets_s = {{"left", "0"}};
  EXPECT_EQ(alarmsHearing(settings, 5.0, 4.0).at(0), LoopAlarm::NoTransform) << "tf is 5 s behind";
}

TEST(LoopFeed, DoesNotHearCloudsThatItLeavesOut) {
  const std::vector<LoopAlarm> alarms = alarmsHearing(test::calibratedLoop(), 0.0, 0.5);
  ASSERT_FALSE(alarms.empty());
  EXPECT_EQ(alarms[0], LoopAlarm::Silent);
  EXPECT_EQ(std::count(alarms.begin(), alarms.end(), LoopAlarm::NoTransform), 0);
}

/// What was heard before a print was not heard without poses of it.
TEST(LoopFeed, HearsForAPrintWhatComesAfterItsToolpath) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = 1;
  const SensedWall printed = test::sensedWall(wall);
  const ros::Time start = test::timeOf(wall.start_ns);
  const test::SetTime time;
  time.set(start);
  LoopFeed feed(wall.settings, 100.0);
  for (int i = 0; i < 3; ++i) feed.hear(heardAt(start + ros::Duration(0.1 * i)));
  feed.pass();
  feed.add(test::toolpathMessage(printed));
  feed.pass();
  for (int i = 0; i < 3; ++i) {
    feed.hear(heardAt(start + ros::Duration(5.0 + 0.1 * i)));
    feed.pass();
  }
  EXPECT_FALSE(isWithoutTransforms(feed));
}

TEST(LoopFeed, TellsCloudsOfAnUnknownFrameFromNoClouds) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.settings.loop.silence_s = 0.5;
  wall.layers = 2;
  const SensedWall printed = test::sensedWall(wall);
  const test::SetTime time;
  LoopFeed feed(wall.settings, 1000.0);
  feed.add(test::toolpathMessage(printed));
  std::size_t cloud = 0;
  for (const StampedTip& tip : printed.tips) {
    time.set(test::timeOf(tip.stamp_ns));
    feed.add(test::nozzleMessage(tip).transforms[0], "test");
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= tip.stamp_ns; ++cloud) {
      auto unknown = boost::make_shared<sensor_msgs::PointCloud2>(test::cloudMessage(printed.clouds[cloud]));
      unknown->header.frame_id = "nowhere";
      feed.add(unknown);
      feed.hear(unknown->header);
    }
    feed.pass();
  }
  const LoopNews news = feed.run()->takeNews();
  const auto has = [&](LoopAlarm alarm) {
    return std::any_of(news.alarms.begin(), news.alarms.end(),
                       [&](const RaisedAlarm& each) { return each.alarm == alarm; });
  };
  EXPECT_TRUE(has(LoopAlarm::NoTransform));
  EXPECT_FALSE(has(LoopAlarm::Silent));
}

}  // namespace
}  // namespace lamina
