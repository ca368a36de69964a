// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>

namespace lamina {

/// The node that alone may order an executor about. Nodes say their own names, and nobody proves them: this
/// keeps orders from being given by mistake, and nobody out who means harm.
class ExecutorOwner {
 public:
  /// @param name  of a node, relative to this node's namespace; empty for anybody
  explicit ExecutorOwner(const std::string& name);

  bool isAnybody() const { return name_.empty(); }

  /// Why an order of that node is not followed; empty if it is.
  std::string refusal(const std::string& caller) const;

 private:
  std::string name_;
};

/// A service of an executor, which others than its owner are refused with the reason.
ros::ServiceServer advertiseForOwner(
    ros::NodeHandle& node, const std::string& name, const ExecutorOwner& owner,
    const std::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)>& serve);

}  // namespace lamina
