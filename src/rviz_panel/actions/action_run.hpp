// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "actions/run_outcome.hpp"

namespace lamina {

/// What a person reads of an action that does not answer.
struct ActionWords {
  std::string remedy;     ///< how its node is started
  std::string activity;   ///< what its node does, "slicing"
  std::string if_gone;    ///< what has become of the work if the node is gone
  std::string if_deaf;    ///< what may become of it if a cancel is not answered
  std::string withdrawn;  ///< what is said of a goal that was cancelled before it was sent
};

/// Client of an action, one goal at a time, that never waits: `poll` does what there is to do and returns at
/// once, and calls the functions below. All calls come from one thread, that of the panel's window. ROS must
/// have been started.
template <class Action>
class ActionRun {
 public:
  using Client = actionlib::SimpleActionClient<Action>;
  using State = actionlib::SimpleClientGoalState;
  using Goal = typename Action::_action_goal_type::_goal_type;
  using FeedbackPtr = boost::shared_ptr<const typename Action::_action_feedback_type::_feedback_type>;
  using ResultPtr = boost::shared_ptr<const typename Action::_action_result_type::_result_type>;

  ActionRun(std::string action, ActionWords words) : action_(std::move(action)), words_(std::move(words)) {
    node_.setCallbackQueue(&queue_);
    client_ = std::make_unique<Client>(node_, action_, false);
  }

  std::function<void(const FeedbackPtr& feedback)> progressed;
  /// What an answer of the node means; called once for each answer.
  std::function<RunOutcome(const State& state, const ResultPtr& result)> read;
  /// Once for each run; also if there is no node, if it does not answer a cancel, or if it dies meanwhile.
  std::function<void(const RunOutcome& outcome)> ended;

  /// Does nothing while a run is under way.
  void run(Goal goal) {
    if (isRunning()) return;
    waiting_ = std::move(goal);
    since_ = Clock::now();
  }

  bool isRunning() const { return waiting_ || is_sent_; }

  void cancel() {
    if (waiting_) return finish({RunOutcome::End::Stopped, words_.withdrawn, ""});
    if (!is_sent_ || is_cancelling_) return;
    client_->cancelGoal();
    is_cancelling_ = true;
    since_ = Clock::now();
  }

  void poll() {
    queue_.callAvailable();
    if (!isRunning()) return;
    const bool is_connected = client_->isServerConnected();
    if (is_connected) last_connected_ = Clock::now();
    if (waiting_ && is_connected) return send();
    if (waiting_ && Clock::now() - since_ > kServerPatience)
      return fail("no node offers the action " + action_ + "; start one: " + words_.remedy);
    if (is_sent_ && Clock::now() - last_connected_ > kGonePatience)
      return fail("the node that was " + words_.activity + " is gone; " + words_.if_gone);
    if (is_cancelling_ && Clock::now() - since_ > cancel_patience)
      return fail("the node does not answer the cancel; " + words_.if_deaf);
  }

  std::chrono::seconds cancel_patience{5};

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kServerPatience{3};  // until a node that is there is connected
  static constexpr std::chrono::seconds kGonePatience{1};

  void send() {
    const Goal goal = std::move(*waiting_);
    waiting_.reset();
    is_sent_ = true;
    const auto done = [this](const State& state, const ResultPtr& result) { finish(read(state, result)); };
    const auto feedback = [this](const FeedbackPtr& message) {
      if (progressed) progressed(message);
    };
    client_->sendGoal(goal, done, typename Client::SimpleActiveCallback(), feedback);
  }

  void fail(const std::string& message) {
    if (is_sent_) client_->stopTrackingGoal();
    finish({RunOutcome::End::Failed, message, ""});
  }

  void finish(const RunOutcome& outcome) {
    waiting_.reset();
    is_sent_ = is_cancelling_ = false;
    if (ended) ended(outcome);
  }

  std::string action_;
  ActionWords words_;
  ros::CallbackQueue queue_;  ///< emptied by nobody else than `poll`
  ros::NodeHandle node_;
  std::unique_ptr<Client> client_;
  std::optional<Goal> waiting_;  ///< for the node to be connected
  bool is_sent_ = false;
  bool is_cancelling_ = false;
  Clock::time_point since_;  ///< the run, or the cancel, was asked for
  Clock::time_point last_connected_;
};

/// What there is to say of an answer that is no success: cancelled, refused, or no result at all.
/// @param result   null if there is none
/// @param stopped  what a cancel has left
template <class State, class ResultPtr>
RunOutcome failureOf(const State& state, const ResultPtr& result, const std::string& stopped) {
  using Status = std::decay_t<decltype(result->status)>;
  if (result && result->status.code == Status::CANCELLED) return {RunOutcome::End::Stopped, stopped, ""};
  if (result && !result->status.message.empty()) return {RunOutcome::End::Failed, result->status.message, ""};
  return {RunOutcome::End::Failed, "the node gave no result (" + state.toString() + "); look at its log", ""};
}

}  // namespace lamina
