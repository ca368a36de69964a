// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop under all faults at random, through all nodes: its sensor fails in every way, it is killed,
// switched off and on. What is laid stays within its limits, and the job ends.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "correction_messages.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "ros/loop/faulty_sensor.hpp"
#include "ros/loop/scanned_wall.hpp"
#include "ros/loop/streamed_cell.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::kLayer;
using test::kLength;
using test::kSpeed;
using test::waitUntil;

constexpr std::size_t kLayers = 20;

std::uint32_t seed() {
  const char* const stated = std::getenv("LAMINA_SEED");
  return stated != nullptr ? static_cast<std::uint32_t>(std::strtoul(stated, nullptr, 10)) : 20261120U;
}

enum class Event { Kill, SwitchOff, SwitchOn, Unplug, PlugIn };

/// What happens to the loop when the machine comes to a layer; in the last layers it is on, and sees.
std::multimap<std::int32_t, Event> randomEvents(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto layer = [&](int first, int last) {
    return static_cast<std::int32_t>(std::uniform_int_distribution<>(first, last)(random));
  };
  std::multimap<std::int32_t, Event> events;
  for (const auto& [first, last] : {std::pair{2, 5}, {6, 9}, {10, 16}})
    events.emplace(layer(first, last), Event::Kill);
  const std::int32_t off = layer(3, 7);
  events.emplace(off, Event::SwitchOff);
  events.emplace(off + layer(1, 3), Event::SwitchOn);
  const std::int32_t unplugged = layer(9, 13);
  events.emplace(unplugged, Event::Unplug);
  events.emplace(unplugged + layer(1, 3), Event::PlugIn);
  return events;
}

class FaultyCell : public test::StreamedCell {
 public:
  explicit FaultyCell(std::string memory)
      : StreamedCell("faulty"),
        memory_(std::move(memory)),
        sensor_(ros::NodeHandle("faulty"), seed()),
        events_(randomEvents(seed())) {
    const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> on_state =
        [this](const auto& message) { come(message->layer); };
    machine_ = node_.subscribe<lamina_msgs::MachineState>(names::kMachineState, 0, on_state);
    startLoop();
  }

  /// Whether the loop has ended by itself at any time.
  bool hasCrashed() {
    has_crashed_ = has_crashed_ || loop_->isOver();
    return has_crashed_;
  }
  bool areEventsOver() const { return events_.empty(); }
  const std::map<std::string, int>& faults() const { return sensor_.faults(); }

 private:
  void startLoop() {
    const std::vector<std::string> arguments = {"__ns:=/faulty",
                                                "/tf:=/faulty/tf",
                                                "/tf_static:=/faulty/tf_static",
                                                std::string(names::kProfile) + ":=" + test::kFaultyProfile,
                                                "_request:=active",
                                                "_sensor/time_offset_trusted:=true",
                                                "_sensor/place_trusted:=true",
                                                "_pauses_print:=false",
                                                "_memory_file:=" + memory_};
    loop_ = std::make_unique<test::NodeProcess>(LAMINA_LOOP_NODE, arguments);
  }
  void come(std::int32_t layer) {
    while (!events_.empty() && events_.begin()->first <= layer) {
      const Event event = events_.begin()->second;
      events_.erase(events_.begin());
      happen(event);
    }
  }
  void happen(Event event) {
    switch (event) {
      case Event::Kill:
        hasCrashed();
        loop_->end(SIGKILL);
        return startLoop();
      case Event::SwitchOff:
        return ask(lamina_msgs::SetLoop::Request::OFF);
      case Event::SwitchOn:
        return ask(lamina_msgs::SetLoop::Request::ACTIVE);
      case Event::Unplug:
        sensor_.is_unplugged = true;
        return;
      case Event::PlugIn:
        sensor_.is_unplugged = false;
        return;
    }
  }
  /// A loop that was just started may not answer.
  void ask(std::uint8_t request) {
    lamina_msgs::SetLoop call;
    call.request.request = request;
    callService(node_.resolveName(names::kSetLoop), call);
  }

  ros::NodeHandle node_{"faulty"};
  std::string memory_;
  test::FaultySensor sensor_;
  std::multimap<std::int32_t, Event> events_;
  std::unique_ptr<test::NodeProcess> loop_;
  bool has_crashed_ = false;
  ros::Subscriber machine_;
};

/// Limits of a free process, and what a feeder of 0.5 /s follows.
void expectWithinLimits(const CorrectionMap& map) {
  SCOPED_TRACE("map " + std::to_string(map.sequence) + " of layer " + std::to_string(map.layer));
  EXPECT_NO_THROW(validate(map));
  for (const PathCorrection& path : map.paths) {
    const double most_step = 0.5 / kSpeed * path.spacing_mm * (1.0 + 1e-9);
    for (std::size_t i = 0; i < path.stations.size(); ++i) {
      const PointCorrection& place = path.stations[i];
      ASSERT_TRUE(std::isfinite(place.amount) && std::isfinite(place.dz_mm) && place.speed == 0.0) << i;
      ASSERT_GE(place.amount, -0.4 - 1e-9) << i;
      ASSERT_LE(place.amount, 0.5 + 1e-9) << i;
      ASSERT_LE(std::abs(place.dz_mm), kLayer) << i;
      if (i > 0) {
        ASSERT_LE(std::abs(place.amount - path.stations[i - 1].amount), most_step) << i;
      }
    }
  }
}

/// Each millimetre of the wall has its layers: none was left out, and none laid twice.
void expectWhole(const std::vector<Point3>& surface) {
  std::map<int, double> tops;
  for (const Point3& point : surface)
    if (std::abs(point.y()) < 0.5 && point.x() > 0.0 && point.x() < kLength)
      tops[static_cast<int>(point.x())] = std::max(tops[static_cast<int>(point.x())], point.z());
  EXPECT_EQ(tops.size(), static_cast<std::size_t>(kLength));
  const double planned = kLayer * static_cast<double>(kLayers);
  for (const auto& [place, top] : tops) {
    EXPECT_GT(top, 0.5 * planned) << place << " mm";
    EXPECT_LT(top, 1.5 * planned) << place << " mm";
  }
}

TEST(FaultyLoop, KeepsItsLimitsAndEndsTheJobWhateverHappens) {
  const test::ScratchFolder folder;
  FaultyCell cell(folder.file("memory.yaml"));
  RecordProperty("seed", std::to_string(seed()));
  const MachineToolpath wall = test::scannedWall(kLayers);
  cell.print(wall);
  ASSERT_TRUE(waitUntil([&] { return cell.isOver(); })) << cell.layers.size() << " layers; seed " << seed();
  EXPECT_EQ(cell.status().code, lamina_msgs::Status::OK + 0) << cell.status().message;
  EXPECT_FALSE(cell.hasCrashed()) << "it was killed, and did not end by itself";
  EXPECT_TRUE(cell.areEventsOver());
  EXPECT_GE(cell.faults().size(), 10U) << "kinds of faults";
  for (const auto& [kind, count] : cell.faults()) ROS_INFO("%d clouds: %s", count, kind.c_str());
  std::set<std::size_t> layers;
  for (const lamina_msgs::CorrectionMap& map : cell.maps) {
    expectWithinLimits(toCore(map));
    layers.insert(map.layer);
  }
  EXPECT_GT(layers.size(), kLayers / 2) << "layers with a map";
  for (const FiledMap& applied : readCorrectionFiles(test::inRosHome("faulty_loop_maps")))
    expectWithinLimits(applied.map);
  EXPECT_TRUE(waitUntil([&] { return !cell.surface(wall.bed_from_part.inverse()).empty(); }));
  expectWhole(cell.surface(wall.bed_from_part.inverse()));
}

}  // namespace
}  // namespace lamina
