// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "owner/executor_owner.hpp"

#include <ros/names.h>
#include <ros/ros.h>

namespace lamina {

ExecutorOwner::ExecutorOwner(const std::string& name)
    : name_(name.empty() ? "" : ros::names::resolve(name)) {}

std::string ExecutorOwner::refusal(const std::string& caller) const {
  if (isAnybody() || caller == name_) return "";
  return "orders are taken from " + name_ + " alone, and this one is from " + caller;
}

ros::ServiceServer advertiseForOwner(
    ros::NodeHandle& node, const std::string& name, const ExecutorOwner& owner,
    const std::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)>& serve) {
  using Event = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;
  const boost::function<bool(Event&)> answer = [name, owner, serve](Event& event) {
    auto request = event.getRequest();
    auto& response = event.getResponse();
    response.message = owner.refusal(event.getCallerName());
    response.success = response.message.empty();
    if (response.success) return serve(request, response);
    ROS_WARN_STREAM(name << " is refused: " << response.message);
    return true;
  };
  ros::AdvertiseServiceOptions options;
  options.initBySpecType<Event>(name, answer);
  return node.advertiseService(options);
}

}  // namespace lamina
