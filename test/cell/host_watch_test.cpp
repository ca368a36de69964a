// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/host_watch.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace lamina {
namespace {

/// Two hosts in simulated time: this one, and `sensing`, whose clock and network are as they are set.
class TwoHosts {
 public:
  explicit TwoHosts(HostWatchSettings settings = {}, bool is_needed = true)
      : watch_(std::move(settings), {{"sensing", is_needed}}, now()) {}

  CellTime now() const { return {steady_s, 1.7e9 + steady_s + own_clock_s}; }
  double thereNow() const { return 1.7e9 + steady_s + other_clock_s; }

  /// Ten questions a second, each of which meets the network twice.
  void run(double duration_s) {
    const double until_s = steady_s + duration_s;
    while (steady_s < until_s) {
      const HostDatagram question = watch_.ask("sensing", now());
      if (!isLost()) answer(question);
      if (!isLost()) watch_.onQuestion("sensing", now());
      steady_s += 0.1;
      watch_.onMaster("", now());
      for (HostAlarm& alarm : watch_.tick(now())) alarms.push_back(std::move(alarm));
    }
  }

  std::vector<int> raised() const {
    std::vector<int> ids;
    for (const HostAlarm& alarm : alarms)
      if (!alarm.is_gone) ids.push_back(alarm.id);
    return ids;
  }
  bool isGone(int id) const {
    bool is_gone = false;
    for (const HostAlarm& alarm : alarms)
      if (alarm.id == id) is_gone = alarm.is_gone;
    return is_gone;
  }

  HostWatch& watch() { return watch_; }
  const PeerStatus& sensing() const { return watch_.peers().front(); }

  double steady_s = 50.0;
  double own_clock_s = 0.0;
  double other_clock_s = 0.0;
  double way_there_s = 0.0005;
  double way_back_s = 0.0005;
  double loss = 0.0;
  std::vector<HostAlarm> alarms;

 private:
  bool isLost() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < loss; }

  void answer(HostDatagram question) {
    steady_s += way_there_s;
    question.kind = HostDatagramKind::Answer;
    question.received_s = thereNow();
    steady_s += 0.0002;
    question.answered_s = thereNow();
    steady_s += way_back_s;
    if (!isLost()) watch_.onAnswer("sensing", question, now());
  }

  std::mt19937 random_{7};
  HostWatch watch_;
};

TEST(ClockOffset, FollowsFromFourStamps) {
  // Asked at 100, there at 5 s ahead after 20 ms, answered after 1 ms, back after 40 ms.
  const ClockOffset found = offsetOf({100.0, 105.020, 105.021, 100.061});
  EXPECT_NEAR(found.offset_s, 4.990, 1e-9);
  EXPECT_NEAR(found.uncertainty_s, 0.030, 1e-9);
}

TEST(ClockComparison, NeedsSixteenExchangesAndIsNotMovedByAFewOfThem) {
  ClockComparison clocks;
  for (int i = 0; i < 15; ++i) clocks.add({1.0, 1.008, 1.008, 1.002});
  EXPECT_FALSE(clocks.offset());
  clocks.add({1.0, 1.5, 1.5, 1.9});
  ASSERT_TRUE(clocks.offset());
  EXPECT_NEAR(clocks.offset()->offset_s, 0.007, 1e-9);
  clocks.add({1.0, 0.5, 0.4, 1.1});
  clocks.add({1.0, std::numeric_limits<double>::quiet_NaN(), 2.0, 3.0});
  EXPECT_NEAR(clocks.offset()->uncertainty_s, 0.001, 1e-9)
      << "stamps that contradict each other do not count";
}

TEST(HostWatch, SaysHowFarClocksAreApart) {
  TwoHosts hosts;
  hosts.other_clock_s = 0.003;
  hosts.run(10.0);
  EXPECT_TRUE(hosts.raised().empty()) << "3 ms";
  ASSERT_TRUE(hosts.sensing().clocks.offset());
  EXPECT_NEAR(hosts.sensing().clocks.offset()->offset_s, 0.003, 1e-6);
  hosts.other_clock_s = 0.008;
  hosts.run(10.0);
  EXPECT_EQ(hosts.raised(), std::vector<int>{8003});
  EXPECT_NE(hosts.alarms.back().message.find("sensing is ahead by 8.0 ms"), std::string::npos)
      << hosts.alarms.back().message;
  hosts.other_clock_s = 0.002;
  hosts.run(10.0);
  EXPECT_TRUE(hosts.isGone(8003));
}

TEST(HostWatch, HoldsForAClockOnlyWhereJobsNeedIt) {
  HostWatchSettings settings;
  settings.is_clock_needed = true;
  TwoHosts needed(settings);
  needed.other_clock_s = -0.050;
  needed.run(10.0);
  EXPECT_EQ(needed.raised(), std::vector<int>{8004});
  TwoHosts not_needed;
  not_needed.other_clock_s = -0.050;
  not_needed.run(10.0);
  EXPECT_EQ(not_needed.raised(), std::vector<int>{8003});
}

TEST(HostWatch, DoesNotTakeTheNetworkForTheClock) {
  TwoHosts hosts;
  hosts.way_there_s = 0.2;  // one way only: looks like 100 ms
  hosts.way_back_s = 0.0;
  hosts.run(30.0);
  EXPECT_EQ(hosts.raised(), std::vector<int>{8003}) << "it cannot be known";
  EXPECT_NE(hosts.alarms.back().message.find("give or take 100.0 ms"), std::string::npos);
  hosts.way_there_s = 0.010;
  hosts.run(30.0);
  EXPECT_TRUE(hosts.isGone(8003));
}

TEST(HostWatch, SeesItsOwnClockBeingSet) {
  HostWatchSettings settings;
  settings.is_clock_needed = true;
  TwoHosts hosts(settings);
  hosts.run(5.0);
  for (int i = 0; i < 100; ++i) {
    hosts.own_clock_s += 0.00005;  // led by 500 ppm
    hosts.run(0.1);
  }
  EXPECT_TRUE(hosts.raised().empty());
  hosts.own_clock_s -= 0.030;
  hosts.other_clock_s = hosts.own_clock_s;
  hosts.run(1.0);
  EXPECT_EQ(hosts.raised(), std::vector<int>{8004});
  EXPECT_NE(hosts.alarms.back().message.find("motion was set by -30.0 ms"), std::string::npos)
      << hosts.alarms.back().message;
  hosts.run(15.0);
  EXPECT_TRUE(hosts.isGone(8004)) << "the clocks were compared anew";
}

std::vector<int> presentIn(TwoHosts& hosts) {
  std::vector<int> ids;
  for (const HostAlarm& alarm : hosts.watch().present())
    if (!alarm.is_gone) ids.push_back(alarm.id);
  return ids;
}

TEST(HostWatch, ReportsAHostThatIsSilentAndComesBack) {
  TwoHosts hosts;
  hosts.run(5.0);
  hosts.loss = 1.0;
  hosts.run(1.8);
  EXPECT_TRUE(hosts.raised().empty());
  hosts.run(0.5);
  EXPECT_EQ(hosts.raised(), std::vector<int>{8001});
  EXPECT_EQ(presentIn(hosts), std::vector<int>{8001});
  EXPECT_TRUE(hosts.sensing().is_lost);
  hosts.loss = 0.0;
  hosts.run(0.5);
  EXPECT_TRUE(hosts.isGone(8001));
  EXPECT_TRUE(presentIn(hosts).empty());
  const std::vector<HostAlarm> reported = hosts.watch().present();
  EXPECT_TRUE(std::any_of(reported.begin(), reported.end(), [](const HostAlarm& alarm) {
    return alarm.id == 8001 && alarm.is_gone;
  })) << "whoever begins to listen may wait for its end";
}

TEST(HostWatch, LosesAHostThatIsNotNeededWithoutAnAlarm) {
  TwoHosts hosts({}, false);
  hosts.loss = 1.0;
  hosts.run(10.0);
  EXPECT_TRUE(hosts.raised().empty());
  EXPECT_TRUE(hosts.sensing().is_lost);
  EXPECT_FALSE(hosts.sensing().was_heard);
}

TEST(HostWatch, RaisesNoFalseAlarmOnABadNetwork) {
  TwoHosts hosts;
  hosts.loss = 0.01;
  hosts.way_there_s = hosts.way_back_s = 0.010;
  hosts.run(8 * 3600.0);
  EXPECT_TRUE(hosts.raised().empty()) << "8 h at 1 % and 20 ms";
  hosts.loss = 0.3;
  hosts.run(3600.0);
  EXPECT_TRUE(hosts.raised().empty()) << "1 h at 30 %";
}

TEST(HostWatch, ReportsTheMasterAfterAWhileOnly) {
  HostWatch watch({}, {}, {0.0, 1.7e9});
  EXPECT_EQ(watch.tick({0.0, 1.7e9}).size(), 5U) << "what is not there is said to be gone";
  watch.onMaster("the master does not know this node: it was started anew", {2.0, 1.7e9 + 2.0});
  EXPECT_TRUE(watch.tick({4.9, 1.7e9 + 4.9}).empty());
  const auto lost = watch.tick({5.1, 1.7e9 + 5.1});
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].id, 8002);
  EXPECT_NE(lost[0].message.find("started anew"), std::string::npos);
  EXPECT_FALSE(watch.hasMaster());
  watch.onMaster("", {6.0, 1.7e9 + 6.0});
  const auto back = watch.tick({6.0, 1.7e9 + 6.0});
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back[0].is_gone);
}

TEST(HostWatch, ReportsADiskAndNodesThatWereStartedAnew) {
  HostWatch watch({}, {}, {0.0, 1.7e9});
  watch.onFreeSpace(1.5 * 1024 * 1024 * 1024);
  auto alarms = watch.tick({0.1, 1.7e9 + 0.1});
  ASSERT_FALSE(alarms.empty());
  EXPECT_EQ(alarms[0].id, 7002);
  EXPECT_NE(alarms[0].message.find("1536 MiB left; expected at least 2048 MiB"), std::string::npos);
  watch.onNode("/gcode_streamer", 41);
  watch.onNode("/gcode_streamer", std::nullopt);
  EXPECT_FALSE(watch.nodes()[0].answers);
  EXPECT_TRUE(watch.tick({0.2, 1.7e9 + 0.2}).empty());
  watch.onNode("/gcode_streamer", 42);
  alarms = watch.tick({0.3, 1.7e9 + 0.3});
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].id, 8005);
  EXPECT_EQ(watch.nodes()[0].restarts, 1);
}

TEST(HostDatagram, IsReadBackAsItWasWritten) {
  const HostDatagram answer{HostDatagramKind::Answer, 0x01020304, 1.7e9 + 0.25, 1.7e9 + 0.5};
  const std::string bytes = encoded(answer);
  ASSERT_EQ(bytes.size(), kHostDatagramBytes);
  EXPECT_EQ(bytes.substr(0, 12), std::string("LMHW\1\2\0\0\1\2\3\4", 12));
  const auto read = hostDatagramIn(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->kind, HostDatagramKind::Answer);
  EXPECT_EQ(read->sequence, 0x01020304U);
  EXPECT_EQ(read->received_s, 1.7e9 + 0.25);
  EXPECT_EQ(read->answered_s, 1.7e9 + 0.5);
  EXPECT_FALSE(hostDatagramIn(bytes.substr(1)));
  EXPECT_FALSE(hostDatagramIn(bytes + '\0'));
}

TEST(HostDatagram, AnyBytesAreRefusedOrWrittenBackAsTheyCame) {
  ASSERT_TRUE(rc::check([](std::string bytes) {
    bytes.resize(kHostDatagramBytes);
    if (bytes[0] % 2 == 0) bytes.replace(0, 6, "LMHW\1\2");
    bytes.replace(6, 2, 2, '\0');
    const auto read = hostDatagramIn(bytes);
    RC_ASSERT((!read || encoded(*read) == bytes));
  }));
}

}  // namespace
}  // namespace lamina
