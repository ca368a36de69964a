// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>

namespace lamina {

/// The only node that may command an executor. Nodes state their own names, without proof: this prevents
/// commands by mistake, not by intent.
class ExecutorOwner {
 public:
  /// @param name  name of a node, relative to this node's namespace; empty if any node may
  explicit ExecutorOwner(const std::string& name);

  bool isAnybody() const { return name_.empty(); }

  /// Why a command of that node is refused; empty if it is not.
  std::string refusal(const std::string& caller) const;

 private:
  std::string name_;
};

/// Advertises a service of an executor that refuses all callers but the owner, with the reason.
ros::ServiceServer advertiseForOwner(
    ros::NodeHandle& node, const std::string& name, const ExecutorOwner& owner,
    const std::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)>& serve);

}  // namespace lamina
