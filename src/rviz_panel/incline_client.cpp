// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline_client.hpp"

#include <actionlib/client/simple_action_client.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "messages.hpp"
#include "request_settings.hpp"

namespace lamina {
namespace {

using Clock = std::chrono::steady_clock;
using actionlib::SimpleClientGoalState;
using lamina_msgs::InclineAction;
using lamina_msgs::InclineFeedbackConstPtr;
using lamina_msgs::InclineGoal;
using lamina_msgs::InclineResultConstPtr;
using lamina_msgs::Status;

constexpr std::chrono::seconds kServerPatience(3);  // until a node that is there is connected
constexpr std::chrono::seconds kCancelPatience(5);
constexpr std::chrono::seconds kGonePatience(1);

InclineGoal goalOf(const InclineRequest& request) {
  InclineGoal goal;
  goal.program = request.program;
  goal.output = request.output;
  for (const auto& [key, text] : request.settings) goal.settings.push_back(settingMessage(key, text));
  return goal;
}

std::string summaryOf(const lamina_msgs::InclineSummary& summary) {
  std::string text = std::to_string(summary.lines) + " lines, " + std::to_string(summary.layers) + " layers";
  if (!summary.slicer.empty()) text += " of " + summary.slicer;
  char computed[40];
  std::snprintf(computed, sizeof computed, ", computed in %.3f s", summary.wall_time);
  text += computed;
  if (summary.homings_annulled > 0) text += "; home the machine before, the program does not";
  if (summary.stands_on_edge)
    text += "; the part stands on an edge: was the mesh tilted by the opposite angle?";
  return text;
}

InclineOutcome outcomeOf(const SimpleClientGoalState& state, const InclineResultConstPtr& result) {
  if (result && result->status.code == Status::OK && state == SimpleClientGoalState::SUCCEEDED)
    return {InclineOutcome::End::Written, summaryOf(result->summary), result->output};
  if (result && result->status.code == Status::CANCELLED)
    return {InclineOutcome::End::Stopped, "cancelled; nothing was written", ""};
  if (result && !result->status.message.empty())
    return {InclineOutcome::End::Failed, result->status.message, ""};
  return {InclineOutcome::End::Failed, "the node gave no result (" + state.toString() + "); look at its log",
          ""};
}

}  // namespace

/// The action client with a queue of its own, emptied by nobody else than `poll`.
class InclineClient::Connection {
 public:
  using Client = actionlib::SimpleActionClient<InclineAction>;

  Connection(InclineClient& owner, std::string action) : owner_(owner), action_(std::move(action)) {
    node_.setCallbackQueue(&queue_);
    client_ = std::make_unique<Client>(node_, action_, false);
  }

  void run(const InclineRequest& request) {
    if (isRunning()) return;
    waiting_ = goalOf(request);
    since_ = Clock::now();
  }

  bool isRunning() const { return waiting_ || is_sent_; }

  void cancel() {
    if (waiting_) return finish({InclineOutcome::End::Stopped, "cancelled; nothing was written", ""});
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
      return fail("no node offers the action " + action_ +
                  "; start one: roslaunch lamina gcode_incliner.launch");
    if (is_sent_ && Clock::now() - last_connected_ > kGonePatience)
      return fail("the node that was inclining is gone; the output is whole or was not written");
    if (is_cancelling_ && Clock::now() - since_ > kCancelPatience)
      return fail("the node does not answer the cancel; the output may still be written");
  }

 private:
  void send() {
    const InclineGoal goal = std::move(*waiting_);
    waiting_.reset();
    is_sent_ = true;
    const auto done = [this](const SimpleClientGoalState& state, const InclineResultConstPtr& result) {
      finish(outcomeOf(state, result));
    };
    const auto feedback = [this](const InclineFeedbackConstPtr& message) {
      if (owner_.progressed) owner_.progressed(message->stage, static_cast<double>(message->fraction));
    };
    client_->sendGoal(goal, done, Client::SimpleActiveCallback(), feedback);
  }

  void fail(const std::string& message) {
    if (is_sent_) client_->stopTrackingGoal();
    finish({InclineOutcome::End::Failed, message, ""});
  }

  void finish(const InclineOutcome& outcome) {
    waiting_.reset();
    is_sent_ = is_cancelling_ = false;
    if (owner_.ended) owner_.ended(outcome);
  }

  InclineClient& owner_;
  std::string action_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::unique_ptr<Client> client_;
  std::optional<InclineGoal> waiting_;  ///< for the node to be connected
  bool is_sent_ = false;
  bool is_cancelling_ = false;
  Clock::time_point since_;  ///< the run, or the cancel, was asked for
  Clock::time_point last_connected_;
};

InclineClient::InclineClient(const std::string& action)
    : connection_(std::make_unique<Connection>(*this, action)) {}
InclineClient::~InclineClient() = default;
void InclineClient::run(const InclineRequest& request) { connection_->run(request); }
void InclineClient::cancel() { connection_->cancel(); }
bool InclineClient::isRunning() const { return connection_->isRunning(); }
void InclineClient::poll() { connection_->poll(); }

}  // namespace lamina
