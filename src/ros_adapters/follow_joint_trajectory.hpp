// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The action that drives joint controllers: that of control_msgs if it is installed, otherwise Lamina's own
// with the same fields.

#ifdef LAMINA_HAS_CONTROL_MSGS
#include <control_msgs/FollowJointTrajectoryAction.h>
namespace lamina::follow {
using Action = control_msgs::FollowJointTrajectoryAction;
using Goal = control_msgs::FollowJointTrajectoryGoal;
using Result = control_msgs::FollowJointTrajectoryResult;
using Feedback = control_msgs::FollowJointTrajectoryFeedback;
}  // namespace lamina::follow
#else
#include "messages.hpp"
namespace lamina::follow {
using Action = lamina_msgs::FollowJointTrajectoryAction;
using Goal = lamina_msgs::FollowJointTrajectoryGoal;
using Result = lamina_msgs::FollowJointTrajectoryResult;
using Feedback = lamina_msgs::FollowJointTrajectoryFeedback;
}  // namespace lamina::follow
#endif
