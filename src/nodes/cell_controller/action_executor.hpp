// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "executor_services.hpp"
#include "followed_job.hpp"
#include "lamina/base/clock.hpp"
#include "machine_executor.hpp"
#include "names.hpp"

namespace lamina {

/// An executor whose jobs are goals of an action, and which publishes their state as `machine_state`. Reports
/// are made in the callbacks of this node.
template <class Action>
class ActionExecutor : public MachineExecutor {
 public:
  ACTION_DEFINITION(Action)

  /// @param report  receives the executor's reports
  ActionExecutor(ros::NodeHandle node, const std::string& action, const ExecutorLanguage& language,
                 std::function<void(const ExecutorReport&)> report)
      : name_(language.node),
        report_(std::move(report)),
        job_(language),
        client_(node, action, false),
        state_(node.subscribe(names::kMachineState, 100, &ActionExecutor::onState, this)),
        printed_(node.subscribe(names::kPrintProgress, 100, &ActionExecutor::onPrinted, this)),
        signs_(node.subscribe(action + "/status", 10, &ActionExecutor::onSign, this)),
        last_sign_s_(clock_.now()),
        services_(node, language.node) {}

  void start(const StartOrder& order) override {
    const std::uint64_t number = order.order;
    job_.begin(order, clock_.now(), ros::Time::now());
    client_.sendGoal(
        goalOf(order),
        [this, number](const auto& state, const auto& result) { onDone(number, state, result); },
        [this, number] { job_.takeUp(number); });
  }
  void pause() override { services_.pause(); }
  void resume() override { services_.resume(); }
  void stop() override { end("stop"); }
  void abort() override { end("abort"); }

  std::string name() const override { return name_; }
  void changeFeed(double feed) override { services_.changeFeed(feed); }
  std::optional<FeedAnswer> takeFeedAnswer() override { return services_.takeFeedAnswer(); }
  std::optional<ExecutorReport> seen() const override { return job_.seen(); }
  const lamina_msgs::MachineState& machine() const override { return job_.machine(); }
  bool isThere() const override {
    // A goal that is sent before client and server are connected is lost silently.
    return clock_.now() - last_sign_s_ < kLongestSilence && client_.isServerConnected();
  }
  std::string takeUnanswered(double patience_s) override {
    return job_.takeUntaken(clock_.now(), patience_s) ? "start" : services_.takeUnanswered(patience_s);
  }

 protected:
  virtual Goal goalOf(const StartOrder& order) const = 0;
  /// Total number of lines or waypoints that the machine has taken.
  virtual std::uint64_t takenThrough(const Result& result) const = 0;

 private:
  static constexpr double kLongestSilence = 2.0;  // [s]; signs of life come five times a second

  void end(const std::string& order) {
    // A goal that has not arrived yet would begin after the order.
    if (job_.isAwaited()) return client_.cancelGoal();
    services_.end(order);
  }

  void onSign(const actionlib_msgs::GoalStatusArrayConstPtr& /*signs*/) { last_sign_s_ = clock_.now(); }

  void onPrinted(const lamina_msgs::PrintProgressConstPtr& printed) { job_.hear(*printed); }

  void onState(const lamina_msgs::MachineStateConstPtr& state) {
    last_sign_s_ = clock_.now();
    const bool was_ordered = job_.isOrdered();
    const auto report = job_.hear(*state);
    if (was_ordered && !job_.isOrdered()) client_.stopTrackingGoal();
    if (report) report_(*report);
  }

  void onDone(std::uint64_t order, const actionlib::SimpleClientGoalState& state,
              const ResultConstPtr& result) {
    JobEnd end{state == actionlib::SimpleClientGoalState::SUCCEEDED, state.toString(), std::nullopt, 0};
    if (result) {
      end.status = result->status;
      end.taken_through = takenThrough(*result);
    }
    if (const auto report = job_.end(order, end)) report_(*report);
  }

  std::string name_;
  std::function<void(const ExecutorReport&)> report_;
  SteadyClock clock_;
  FollowedJob job_;
  actionlib::SimpleActionClient<Action> client_;
  ros::Subscriber state_;
  ros::Subscriber printed_;
  ros::Subscriber signs_;
  double last_sign_s_;
  ExecutorServices services_;
};

}  // namespace lamina
