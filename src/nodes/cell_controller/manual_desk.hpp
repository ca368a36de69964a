// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>

#include "lamina/cell/manual_control.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "messages.hpp"

namespace lamina {

/// The mode Manual on ROS: takes steps by the service move_by_hand and passes them on to the node that jogs,
/// as jog_twist and jog_joints. It does not command the process. Holders and losses of the lease are recorded
/// in the audit.
///
/// All calls and callbacks come from one thread.
class ManualDesk {
 public:
  /// @param unit  mode, state and zone of the unit at present; called from callbacks only
  ManualDesk(ros::NodeHandle node, CellJournal& journal, std::function<ManualConditions()> unit);

  /// Passes on the motion or rest that is due now.
  void follow(CellTime now);

 private:
  using Request = lamina_msgs::MoveByHand::Request;
  bool onOrder(Request& request, lamina_msgs::MoveByHand::Response& response);
  void onJog(const lamina_msgs::JogStateConstPtr& state);
  CommandAnswer answerTo(const Request& request, const ManualConditions& found, CellTime now);
  ManualConditions conditions() const;
  void passOn(double now_s);
  void send(const ManualStep& step, double velocity) const;
  void keep(const std::string& who, const std::string& what, const std::string& result, CellTime now);
  void tell(CellTime now);

  CellJournal& journal_;
  std::function<ManualConditions()> unit_;
  ManualControl control_;
  std::string lost_;  ///< why the last lease was lost, until there is another
  lamina_msgs::JogState jog_;
  lamina_msgs::ManualState told_;
  bool is_told_ = false;
  std::optional<ManualStep> sent_;  ///< step that the machine runs
  double sent_s_ = 0.0;
  ros::Publisher state_;
  ros::Publisher twist_;
  ros::Publisher joints_;
  ros::Subscriber jog_states_;
  ros::ServiceServer orders_;
};

}  // namespace lamina
