// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "names.hpp"

namespace lamina::test {

/// Where a loop hears its sensor, which the test stands before.
inline constexpr char kFaultyProfile[] = "faulty_profile";

/// Hands on the clouds of a sensor, and spoils two of five by faults at random: values that are no numbers,
/// stamps of other centuries, fields and bytes that are missing, mirror images, spray, a sensor that has
/// moved or is stuck, clouds that come twice, late or not at all. All is chosen by the number of the cloud
/// and the seed.
class FaultySensor {
 public:
  FaultySensor(ros::NodeHandle node, std::uint32_t seed)
      : random_(seed), out_(node.advertise<sensor_msgs::PointCloud2>(kFaultyProfile, 0)) {
    const boost::function<void(const sensor_msgs::PointCloud2::ConstPtr&)> on_cloud =
        [this](const auto& cloud) { hear(*cloud); };
    in_ = node.subscribe<sensor_msgs::PointCloud2>(names::kProfile, 0, on_cloud);
  }

  /// Kinds of faults, and how many clouds had each.
  const std::map<std::string, int>& faults() const { return faults_; }

  bool is_unplugged = false;

 private:
  using Cloud = sensor_msgs::PointCloud2;

  struct Coordinates {
    float x, y, z;
  };

  double share() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }

  /// The sensor's clouds begin with x, y and z.
  template <class Change>
  static void changePoints(Cloud& cloud, Change change) {
    const std::size_t points = cloud.point_step == 0 ? 0 : cloud.data.size() / cloud.point_step;
    for (std::size_t i = 0; i < points; ++i) {
      Coordinates at{};
      std::memcpy(&at, cloud.data.data() + i * cloud.point_step, sizeof at);
      change(at);
      std::memcpy(cloud.data.data() + i * cloud.point_step, &at, sizeof at);
    }
  }

  static Cloud many(const Cloud& cloud) {
    Cloud dense = cloud;
    while (dense.data.size() < std::size_t{20000} * dense.point_step && !cloud.data.empty())
      dense.data.insert(dense.data.end(), cloud.data.begin(), cloud.data.end());
    dense.width = static_cast<std::uint32_t>(dense.data.size() / dense.point_step);
    dense.row_step = static_cast<std::uint32_t>(dense.data.size());
    return dense;
  }

  void hear(const Cloud& cloud) {
    if (is_unplugged) return count("unplugged");
    if (late_) out_.publish(*std::exchange(late_, std::nullopt));
    spoil(cloud, share());
    last_ = cloud;
  }

  void spoil(Cloud cloud, double chosen) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    const auto gives = [&](const char* kind, double up_to) {
      if (chosen >= up_to) return false;
      count(kind);
      return true;
    };
    if (gives("dropped", 0.03)) return;
    if (gives("late", 0.06)) {
      late_ = std::move(cloud);
      return;
    }
    if (gives("twice", 0.09)) {
      out_.publish(cloud);
    } else if (gives("not a number", 0.12)) {
      changePoints(cloud, [](Coordinates& at) { at.z = kNone; });
    } else if (gives("endless", 0.15)) {
      changePoints(cloud, [](Coordinates& at) { at = {kEndless, -kEndless, kEndless}; });
    } else if (gives("empty", 0.18)) {
      cloud.data.clear();
      cloud.width = cloud.row_step = 0;
    } else if (gives("cut", 0.21)) {
      cloud.data.resize(cloud.data.size() / 2 + 1);
    } else if (gives("other fields", 0.23)) {
      cloud.fields.pop_back();
      cloud.fields.front().name = "q";
    } else if (gives("of 1970", 0.25)) {
      cloud.header.stamp = ros::Time(1.0);
    } else if (gives("of 2100", 0.27)) {
      cloud.header.stamp = ros::Time(4102444800.0);
    } else if (gives("of another frame", 0.29)) {
      cloud.header.frame_id = "nowhere";
    } else if (gives("mirrored", 0.31)) {
      changePoints(cloud, [](Coordinates& at) { at.z = -at.z; });
    } else if (gives("moved", 0.33)) {
      changePoints(cloud, [](Coordinates& at) { at.z += 0.3F; });
    } else if (gives("spray", 0.36)) {
      changePoints(cloud, [this](Coordinates& at) { at.z += static_cast<float>(0.02 * share() - 0.01); });
    } else if (last_ && gives("stuck", 0.39)) {
      cloud.data = last_->data;
    } else if (gives("many points", 0.40)) {
      cloud = many(cloud);
    }
    out_.publish(cloud);
  }

  void count(const char* kind) { ++faults_[kind]; }

  std::mt19937 random_;
  std::map<std::string, int> faults_;
  std::optional<Cloud> last_, late_;
  ros::Publisher out_;
  ros::Subscriber in_;
};

}  // namespace lamina::test
