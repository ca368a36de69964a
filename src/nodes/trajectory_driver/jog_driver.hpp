// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TwistStamped.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "controller_client.hpp"
#include "driver_settings.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/trajectory/jog.hpp"
#include "messages.hpp"
#include "owner/executor_owner.hpp"
#include "present_joints.hpp"
#include "process_publisher.hpp"

namespace lamina {

/// The connections of a jog.
struct JogLinks {
  ControllerClient& controller;
  ProcessPublisher& process;
  const PresentJoints& joints;
  /// Rotation of the part against the bed, for the toolpath published last.
  std::function<Eigen::Matrix3d()> bed_from_part;
  /// Called with where the machine rests, before it is moved from there.
  std::function<void(const JointValues&)> departs;
};

/// Moves the machine by hand while no job runs: topics jog_twist, jog_joints and jog_state
/// (docs/nodes/trajectory_driver.md).
class JogDriver {
 public:
  /// The objects referred to must outlive it.
  JogDriver(ros::NodeHandle& node, const DriverSettings& settings, const KinematicModel& model,
            const ExecutorOwner& owner, JogLinks links);

  /// Refuses orders until `allow`. Returns once a jog under way has come to rest.
  /// @param is_cancelled  whether the job that waits is no longer wanted
  /// @throws Cancelled if so, DeviceError if the controller does not come to rest; the controller is then
  ///   told to stop
  void block(const std::function<bool()>& is_cancelled);
  void allow();
  /// Whether the controller may be following an order. Does not wait.
  bool isUnderWay() const { return is_under_way_; }

 private:
  template <class Message>
  using Event = ros::MessageEvent<const Message>;
  /// Makes an order in the bed frame from the machine's position at the time when the order takes effect.
  using MakeOrder = std::function<JogOrder(const JointValues& position)>;

  void onTwist(const Event<geometry_msgs::TwistStamped>& event);
  void onJoints(const Event<sensor_msgs::JointState>& event);
  void give(const std::string& holder, const std::string& frame, const MakeOrder& make);
  JogAnswer follow(const std::string& holder, const MakeOrder& make);
  void dropIfTimeWentBack(const ros::Time& now);
  void beginIfAtRest(const ros::Time& now);
  JogOrder orderOf(const geometry_msgs::TwistStamped& message, const JointValues& position) const;
  JogOrder orderOf(const sensor_msgs::JointState& message) const;
  Eigen::Matrix3d bedFromBase(const JointValues& position) const;
  std::string collisionOn(const std::vector<JointValues>& places);
  bool isMoving(const ros::Time& now) const;
  bool isOver(double waited_s, bool is_cancelled);
  void tell(const ros::Time& now);

  const DriverSettings& settings_;
  const KinematicModel& model_;
  ExecutorOwner owner_;
  JogLinks links_;
  ros::Publisher publisher_;

  std::mutex mutex_;         ///< of what follows up to the subscribers
  SteadyClock lease_clock_;  ///< ROS time may be set back
  JogLease lease_;
  std::optional<Jog> jog_;
  std::optional<LinkBodies> bodies_;  ///< made before the first jog begins
  ros::Time begin_;                   ///< when the clock of the jog is 0
  ros::Time looked_at_;               ///< when it was looked whether ROS time goes on
  std::string failure_;               ///< of the last jog, while its holder's lease goes on
  bool is_blocked_ = false;
  bool is_rest_reported_ = true;  ///< that the machine is at rest
  lamina_msgs::JogState state_;
  std::atomic<bool> is_under_way_{false};

  ros::Subscriber twist_;
  ros::Subscriber joints_;
  ros::Timer timer_;
};

}  // namespace lamina
