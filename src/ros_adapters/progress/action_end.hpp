// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>

#include "messages.hpp"

namespace lamina {

/// Ends the current goal of an action server by the status of the result: succeeded; preempted if it was
/// cancelled; or aborted, with the status's message.
/// @tparam Result  has a `status`
template <class Action, class Result>
void endGoal(actionlib::SimpleActionServer<Action>& server, const Result& result) {
  const lamina_msgs::Status& status = result.status;
  if (status.code == lamina_msgs::Status::OK)
    server.setSucceeded(result, status.message);
  else if (status.code == lamina_msgs::Status::CANCELLED)
    server.setPreempted(result, status.message);
  else
    server.setAborted(result, status.message);
}

}  // namespace lamina
