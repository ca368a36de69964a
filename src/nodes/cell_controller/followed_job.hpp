// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lamina/cell/executor.hpp"
#include "messages.hpp"

namespace lamina {

/// Which states of the machine belong to the ordered job.
enum class StateMatch : std::uint8_t {
  AnyJob,   ///< all states that arrive after the order
  SameJob,  ///< states that name the job's file and are stamped after the order
};

/// The alarm of a job's end that is the same for all executors' nodes, 0 for none; nothing if the alarm
/// depends on the node. A job whose node was ended does not count as given up.
std::optional<int> alarmOfAnyNode(const lamina_msgs::Status& status);

/// How messages of an executor's node are interpreted.
struct ExecutorLanguage {
  std::string node;  ///< its name
  /// Alarm that a job's end raises; 0 for none.
  std::function<int(const lamina_msgs::Status&)> alarm_of;
  /// Whether an end with this status has stopped the machine, or told it to stop: accepted motions are lost.
  std::function<bool(const lamina_msgs::Status&)> is_stopped_by;
  StateMatch match = StateMatch::AnyJob;
};

/// The end of a job as the result of its action states it.
struct JobEnd {
  bool has_succeeded = false;                 ///< of the action
  std::string outcome;                        ///< of the action, in words
  std::optional<lamina_msgs::Status> status;  ///< nothing if there was no result
  std::uint64_t taken_through = 0;
};

/// The job of an executor, as reported by its node: states on one topic, results on another, in any order. A
/// job ordered here ends by its result only, as a state may belong to the previous job.
class FollowedJob {
 public:
  explicit FollowedJob(ExecutorLanguage language);

  void begin(const StartOrder& order, double now_s, const ros::Time& now);
  /// States that the order has arrived; its file may still be read.
  void takeUp(std::uint64_t order);
  /// Whether an ordered job has not ended.
  bool isOrdered() const { return order_.has_value(); }
  /// Whether the machine has not reported on the ordered job yet.
  bool isAwaited() const { return order_ && !has_begun_; }
  /// Whether the order to start has not arrived for `patience_s` [s]; the time then begins anew.
  bool takeUntaken(double now_s, double patience_s);

  /// @return the report; nothing if the state contains nothing new on the job
  std::optional<ExecutorReport> hear(const lamina_msgs::MachineState& state);
  std::optional<ExecutorReport> end(std::uint64_t order, const JobEnd& end);
  /// What is printed of the job; of another, or from before the order, it counts for nothing.
  void hear(const lamina_msgs::PrintProgress& printed) { printed_ = printed; }

  const lamina_msgs::MachineState& machine() const { return machine_; }
  /// The last report; nothing if there was none.
  std::optional<ExecutorReport> seen() const;

 private:
  bool isOfOrder(const lamina_msgs::MachineState& state) const;
  ExecutorReport restarted(ExecutorReport report);
  ExecutorReport reportOf(const lamina_msgs::MachineState& state) const;
  void addPrinted(ExecutorReport& report) const;

  ExecutorLanguage language_;
  lamina_msgs::MachineState machine_;
  bool has_machine_ = false;
  lamina_msgs::PrintProgress printed_;
  std::optional<std::uint64_t> order_;  ///< under way
  std::string program_;                 ///< program of the last order
  ros::Time ordered_;
  double ordered_s_ = 0.0;
  bool is_taken_up_ = false;  ///< whether the last order has arrived
  bool has_begun_ = false;    ///< whether its job has begun, by the machine's state
  bool has_run_ = false;      ///< whether the job has run since
  ExecutorReport last_;       ///< of it
};

/// The phase of an executor whose node is in that state.
ExecutorPhase phaseOf(const lamina_msgs::MachineState& state);

}  // namespace lamina
