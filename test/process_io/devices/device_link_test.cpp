// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/devices/device_link.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Values = std::vector<double>;

/// What a device is commanded and how it is; shared with the test.
struct CommandedDevice {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Values> exchanged;
  int opened = 0;
  bool is_closed = false;
  bool is_well = true;
  bool hangs = false;
  bool hangs_at_its_end = false;

  template <class Condition>
  bool waitFor(Condition condition) {
    std::unique_lock<std::mutex> lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(60), condition);
  }
  void set(bool& field, bool value) {
    const std::lock_guard<std::mutex> lock(mutex);
    field = value;
    changed.notify_all();
  }
};

class FakeDevice final : public ProcessDevice {
 public:
  explicit FakeDevice(CommandedDevice& commanded) : commanded_(commanded) {}
  std::string open() override {
    const std::lock_guard<std::mutex> lock(commanded_.mutex);
    if (!commanded_.is_well) throw Disconnected("not there");
    ++commanded_.opened;
    return "found";
  }
  Values exchange(const Values& raw) override {
    std::unique_lock<std::mutex> lock(commanded_.mutex);
    commanded_.changed.wait(lock, [this] { return !commanded_.hangs; });
    if (!commanded_.is_well) throw Disconnected("gone");
    commanded_.exchanged.push_back(raw);
    commanded_.changed.notify_all();
    return {2.0 * raw[0]};
  }
  void close() override {
    std::unique_lock<std::mutex> lock(commanded_.mutex);
    commanded_.changed.wait(lock, [this] { return !commanded_.hangs_at_its_end; });
    commanded_.is_closed = true;
  }

 private:
  CommandedDevice& commanded_;
};

DeviceSettings quickSettings() {
  DeviceSettings settings;
  settings.name = "fake";
  settings.timeout_s = 0.02;
  settings.retry_s = 0.01;
  return settings;
}

/// Waits for a report.
bool comesTo(DeviceLink& link, const std::function<bool(const DeviceReport&)>& is_so) {
  const SteadyClock clock;
  for (const double begin_s = clock.now(); clock.now() < begin_s + 60.0;) {
    if (is_so(link.report())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(DeviceLink, FirstAndLastValuesAreSafe) {
  CommandedDevice commanded;
  const SteadyClock clock;
  {
    DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
    ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
    link.send({5.0}, clock.now());
    ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.inputs == Values{10.0}; }));
    EXPECT_EQ(link.figures().late.count(), 1U);
    EXPECT_EQ(link.figures().round_trip.count(), 1U);
  }
  EXPECT_EQ(commanded.exchanged, (std::vector<Values>{{-1.0}, {5.0}, {-1.0}}));
  EXPECT_TRUE(commanded.is_closed);
}

TEST(DeviceLink, IsEndedOnlyOnceTheDeviceHasTheSafeValues) {
  CommandedDevice commanded;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
  link.send({5.0}, clock.now());
  link.send({-1.0}, clock.now());
  ASSERT_TRUE(comesTo(link, [&link](const DeviceReport&) { return link.end(); }));
  EXPECT_EQ(commanded.exchanged.back(), Values{-1.0});
  EXPECT_TRUE(commanded.is_closed);
}

TEST(DeviceLink, ALostDeviceIsOpenedAgainAndGetsNoOldValue) {
  CommandedDevice commanded;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.note == "found"; }));
  commanded.set(commanded.is_well, false);
  link.send({5.0}, clock.now());
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return !report.is_connected; }));
  EXPECT_NE(link.report().reason, "");
  link.send({6.0}, clock.now());
  commanded.set(commanded.is_well, true);
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
  link.send({7.0}, clock.now());
  ASSERT_TRUE(commanded.waitFor([&] { return commanded.exchanged.size() == 3; }));
  EXPECT_EQ(commanded.exchanged, (std::vector<Values>{{-1.0}, {-1.0}, {7.0}}));
}

TEST(DeviceLink, ALostDeviceIsReportedBeforeItIsClosed) {
  CommandedDevice commanded;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
  commanded.set(commanded.hangs_at_its_end, true);
  commanded.set(commanded.is_well, false);
  link.send({5.0}, clock.now());
  EXPECT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.reason == "gone"; }));
  EXPECT_FALSE(link.report().is_connected);
  EXPECT_FALSE(link.report().is_hung);
  commanded.set(commanded.hangs_at_its_end, false);
}

TEST(DeviceLink, WhatWasNotSentYetIsReplacedAndLate) {
  CommandedDevice commanded;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {0.0});
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
  commanded.set(commanded.hangs, true);
  link.send({1.0}, clock.now());
  // Only then is the first under way.
  ASSERT_TRUE(comesTo(link, [](const DeviceReport& report) {
    return report.is_hung && report.reason.rfind("no answer for", 0) == 0;
  }));
  const double due_s = clock.now();
  link.send({2.0}, due_s);
  link.send({3.0}, due_s + 0.01);
  commanded.set(commanded.hangs, false);
  ASSERT_TRUE(commanded.waitFor([&] { return commanded.exchanged.size() == 3; }));
  EXPECT_EQ(commanded.exchanged, (std::vector<Values>{{0.0}, {1.0}, {3.0}}));
  EXPECT_EQ(link.figures().late.count(), 2U);
}

TEST(DeviceLink, ADeviceThatHangsAsItIsOpenedIsReported) {
  CommandedDevice commanded;
  commanded.hangs = true;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
  EXPECT_TRUE(comesTo(link, [](const DeviceReport& report) {
    return report.is_hung && !report.is_connected && report.reason.rfind("no answer for", 0) == 0;
  }));
  EXPECT_FALSE(link.end());
  commanded.set(commanded.hangs, false);
  EXPECT_TRUE(comesTo(link, [&link](const DeviceReport&) { return link.end(); }));
  EXPECT_EQ(commanded.exchanged, (std::vector<Values>{{-1.0}, {-1.0}}));
  EXPECT_TRUE(commanded.is_closed);
}

TEST(DeviceLink, DoesNotEndWhileTheLastValuesHang) {
  CommandedDevice commanded;
  const SteadyClock clock;
  DeviceLink link(std::make_unique<FakeDevice>(commanded), quickSettings(), clock, {-1.0});
  EXPECT_TRUE(comesTo(link, [](const DeviceReport& report) { return report.is_connected; }));
  commanded.set(commanded.hangs, true);
  EXPECT_FALSE(link.end());
  commanded.set(commanded.hangs, false);
  EXPECT_TRUE(comesTo(link, [&link](const DeviceReport&) { return link.end(); }));
  EXPECT_TRUE(link.end()) << "for good";
}

}  // namespace
}  // namespace lamina
