// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "latched.hpp"
#include "ros/loop/wall_messages.hpp"
#include "ros/node_process.hpp"
#include "ros/wait_until.hpp"
#include "support/sensed_wall.hpp"

namespace lamina::test {

/// A node of its own: stamps of a replay go back.
class Controller {
 public:
  explicit Controller(std::vector<std::string> parameters = {}) {
    const std::vector<std::string> calibrated = {"_sensor/time_offset_trusted:=true",
                                                 "_sensor/place_trusted:=true", "_request:=active",
                                                 "_sight/sigma_mm:=0.01", "_loop/reading_correlation:=0.0"};
    parameters.insert(parameters.begin(), calibrated.begin(), calibrated.end());
    ros::param::del("/height_controller");  // of the node before
    const boost::function<void(const lamina_msgs::CorrectionMapConstPtr&)> on_map = [this](const auto& map) {
      if (is_listening_) (map->sequence == 0 ? coasting_maps : maps).push_back(*map);
    };
    const boost::function<void(const lamina_msgs::LoopFiguresConstPtr&)> on_layer =
        [this](const auto& layer) {
          if (is_listening_) layers.push_back(*layer);
        };
    const boost::function<void(const lamina_msgs::LoopStateConstPtr&)> on_state = [this](const auto& state) {
      if (is_listening_) states.push_back(*state);
    };
    const boost::function<void(const lamina_msgs::AlarmReportConstPtr&)> on_alarm =
        [this](const auto& alarm) {
          if (is_listening_) alarms.push_back(*alarm);
        };
    maps_ = node_.subscribe<lamina_msgs::CorrectionMap>(names::kCorrection, 0, on_map);
    layers_ = node_.subscribe<lamina_msgs::LoopFigures>(names::kLoopFigures, 0, on_layer);
    states_ = node_.subscribe<lamina_msgs::LoopState>(names::kLoopState, 0, on_state);
    alarms_ = node_.subscribe<lamina_msgs::AlarmReport>(names::kAlarmReports, 0, on_alarm);
    process_.emplace(LAMINA_LOOP_NODE, parameters);
    waitUntil(
        [this] { return !states.empty() && maps_.getNumPublishers() > 0 && layers_.getNumPublishers() > 0; });
  }
  ~Controller() {
    is_listening_ = false;
    process_.reset();
    waitUntil([this] { return is_killed_ || maps_.getNumPublishers() == 0; });
  }

  /// A node that is killed says no farewell to the master.
  int end(int signal) {
    is_killed_ = signal == SIGKILL;
    return process_->end(signal);
  }
  std::vector<std::string> digests() const {
    std::vector<std::string> all;
    for (const auto& map : maps) all.push_back(map.digest);
    return all;
  }
  /// Whether an alarm was raised to the unit, and then reported as gone.
  bool hasRaised(std::uint16_t id) const { return raisedFirst(id) != alarms.end(); }
  bool hasEnded(std::uint16_t id) const {
    const auto raised = raisedFirst(id);
    return std::any_of(raised, alarms.end(),
                       [id](const auto& each) { return each.id == id && each.is_gone != 0; });
  }
  bool isIn(std::uint8_t state) const { return !states.empty() && states.back().state == state; }

  std::vector<lamina_msgs::CorrectionMap> maps;
  std::vector<lamina_msgs::CorrectionMap> coasting_maps;
  std::vector<lamina_msgs::LoopFigures> layers;
  std::vector<lamina_msgs::LoopState> states;
  std::vector<lamina_msgs::AlarmReport> alarms;

 private:
  std::vector<lamina_msgs::AlarmReport>::const_iterator raisedFirst(std::uint16_t id) const {
    return std::find_if(alarms.begin(), alarms.end(),
                        [id](const auto& each) { return each.id == id && each.is_gone == 0; });
  }

  ros::NodeHandle node_;
  bool is_listening_ = true;
  bool is_killed_ = false;
  ros::Subscriber maps_, layers_, states_, alarms_;
  std::optional<NodeProcess> process_;
};

/// Says what a cell says, at most as fast as a real one, stamped from now on.
class LiveWall {
 public:
  explicit LiveWall(SensedWallCase wall) {
    now_ns_ = static_cast<std::int64_t>(ros::Time::now().toNSec());
    wall.start_ns = now_ns_ + 500'000'000;
    printed = sensedWall(wall);
    toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
    profile_ = node_.advertise<sensor_msgs::PointCloud2>(names::kProfile, 1000);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 1000);
    tf_static_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    toolpath = toolpathMessage(printed);
    toolpath.header.stamp = now();
    announce(toolpath);
    publishLatched(tf_static_, sensorMessage());
    waitUntilHeard();
  }

  void announce(const lamina_msgs::Toolpath& message) { publishLatched(toolpath_, message); }

  void waitUntilHeard() {
    EXPECT_TRUE(waitUntil([this] {
      return profile_.getNumSubscribers() > 0 && tf_.getNumSubscribers() > 0 &&
             tf_static_.getNumSubscribers() > 0 && toolpath_.getNumSubscribers() > 0;
    }));
  }

  /// Publishes what is due until something is true, or all is said. The machine's clock stands in between,
  /// and runs slower where turns come late: a busy machine gets what it would get in time.
  void say(const std::function<bool()>& is_enough) {
    ros::SteadyTime turn = ros::SteadyTime::now();
    while (!is_enough() && (tip_ < printed.tips.size() || cloud_ < printed.clouds.size())) {
      for (; cloud_ < printed.clouds.size() && printed.clouds[cloud_].stamp_ns <= now_ns_; ++cloud_)
        profile_.publish(cloudMessage(printed.clouds[cloud_]));
      for (; tip_ < printed.tips.size() && printed.tips[tip_].stamp_ns <= now_ns_; ++tip_)
        if (printed.tips[tip_].stamp_ns < no_tf_from_ns) tf_.publish(nozzleMessage(printed.tips[tip_]));
      ros::spinOnce();
      ros::WallDuration(0.002).sleep();
      const ros::SteadyTime next = ros::SteadyTime::now();
      now_ns_ += std::min((next - turn).toNSec(), kLongestTurnNs);
      turn = next;
    }
  }

  /// By the machine's clock.
  ros::Time now() const { return timeOf(now_ns_); }

  SensedWall printed;
  lamina_msgs::Toolpath toolpath;  ///< as announced first
  std::int64_t no_tf_from_ns = std::numeric_limits<std::int64_t>::max();

 private:
  ros::NodeHandle node_;
  ros::Publisher toolpath_, profile_, tf_, tf_static_;
  static constexpr std::int64_t kLongestTurnNs = 10'000'000;
  std::int64_t now_ns_ = 0;
  std::size_t tip_ = 0;
  std::size_t cloud_ = 0;
};

/// What the machine says of its job.
class ReportedMachine {
 public:
  ReportedMachine() { state_ = node_.advertise<lamina_msgs::MachineState>(names::kMachineState, 100, true); }
  void say(std::uint8_t state, std::int32_t layer) {
    lamina_msgs::MachineState message;
    message.state = state;
    message.layer = layer;
    EXPECT_TRUE(waitUntil([this] { return state_.getNumSubscribers() > 0; }));
    publishLatched(state_, message);
  }

 private:
  ros::NodeHandle node_;
  ros::Publisher state_;
};

}  // namespace lamina::test
