// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "lamina/base/clock.hpp"
#include "lamina/cell/production_cell.hpp"
#include "messages.hpp"
#include "order_thread.hpp"
#include "unanswered_order.hpp"

namespace lamina {

/// The node gcode_streamer as the cell's executor. Reports come from the node's own callbacks.
class StreamExecutor final : public Executor {
 public:
  /// @param report  takes what the executor says
  StreamExecutor(ros::NodeHandle node, std::function<void(const ExecutorReport&)> report);

  void start(const StartOrder& order) override;
  void pause() override;
  void resume() override;
  void stop() override;
  void abort() override;

  /// Has the job run at that part of its programmed speed.
  void changeFeed(double feed);
  /// What became of the last change of the speed, once.
  struct FeedAnswer {
    double feed = 1.0;
    std::string refusal;  ///< empty if it was taken
  };
  std::optional<FeedAnswer> takeFeedAnswer();

  /// What the executor said last of a job that nobody here has started; nothing if it has said nothing.
  std::optional<ExecutorReport> seen() const;

  /// The last state of the machine.
  const lamina_msgs::MachineState& machine() const { return machine_; }

  /// Whether it gives signs of life, and would take a job.
  bool isThere() const;

  /// Which order has waited that long for its answer, once; empty if none has. [s]
  std::string takeUnanswered(double patience_s);

 private:
  using Client = actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction>;

  void onState(const lamina_msgs::MachineStateConstPtr& state);
  void endJob(const std::string& order);
  void onRestart(ExecutorReport report);
  void onDone(std::uint64_t order, const actionlib::SimpleClientGoalState& state,
              const lamina_msgs::StreamProgramResultConstPtr& result);
  void onSign(const actionlib_msgs::GoalStatusArrayConstPtr& signs);
  void call(OrderThread& thread, ros::ServiceClient& service, const std::string& order);
  ExecutorReport reportOf(const lamina_msgs::MachineState& state) const;

  std::function<void(const ExecutorReport&)> report_;
  SteadyClock clock_;
  Client client_;
  ros::ServiceClient pause_;
  ros::ServiceClient resume_;
  ros::ServiceClient abort_;
  ros::ServiceClient change_;
  ros::Subscriber state_;
  ros::Subscriber signs_;
  lamina_msgs::MachineState machine_;
  bool has_machine_ = false;
  std::optional<std::uint64_t> order_;  ///< under way
  bool is_taken_up_ = false;            ///< what was ordered last; its program may still be read
  bool has_begun_ = false;              ///< the same, by the state of the machine
  bool has_run_ = false;                ///< whether its lines have been sent since
  ExecutorReport last_;                 ///< of it
  double ordered_s_ = 0.0;
  double last_sign_s_;
  std::mutex mutex_;  ///< of the order under way
  UnansweredOrder waiting_;
  std::optional<FeedAnswer> feed_answer_;
  // Last, so that they end before what they use. What ends a job does not wait behind what pauses it.
  OrderThread orders_;
  OrderThread ends_;
};

}  // namespace lamina
