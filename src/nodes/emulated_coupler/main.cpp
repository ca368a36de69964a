// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "coupler_settings.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"

namespace {

constexpr double kLookPeriod = 0.05;  // s

/// Logs when the coupler goes into service, and when its watchdog takes it out.
class StateLog {
 public:
  void look(lamina::CouplerServer& coupler) {
    const std::uint16_t state = coupler.at(lamina::kCouplerState);
    if (state == state_) return;
    state_ = state;
    if (state == 1)
      ROS_INFO("outputs are written");
    else
      ROS_WARN("no output was written in time: all have their fault values");
  }

 private:
  std::uint16_t state_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"emulated_coupler"}, [] {
    lamina::EmulatedCouplerSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    lamina::ModbusServerSettings server;
    server.bind = settings.bind;
    server.port = static_cast<std::uint16_t>(settings.port);
    lamina::CouplerServer coupler(settings.coupler, server);
    coupler.setReady(settings.is_ready);
    ros::NodeHandle("~").setParam("port", static_cast<int>(coupler.port()));
    ROS_INFO("coupler at %s:%d", settings.bind.c_str(), static_cast<int>(coupler.port()));
    StateLog log;
    const ros::WallTimer timer = ros::NodeHandle().createWallTimer(
        ros::WallDuration(kLookPeriod), [&](const ros::WallTimerEvent&) { log.look(coupler); });
    ros::spin();
  });
}
