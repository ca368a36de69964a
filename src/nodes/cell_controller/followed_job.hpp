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

/// Which states of the machine are of the job that was ordered.
enum class StateMatch : std::uint8_t {
  AnyJob,   ///< all that come after the order
  SameJob,  ///< those that name its file and are stamped after the order
};

/// The alarm of an end that is alike for all executors' nodes, 0 for none; nothing if it is the node's own to
/// tell. Nobody has given up a job whose node was ended.
std::optional<int> alarmOfAnyNode(const lamina_msgs::Status& status);

/// How what an executor's node says is to be taken.
struct ExecutorLanguage {
  std::string node;  ///< its name
  /// Alarm that a job's end raises; 0 for none.
  std::function<int(const lamina_msgs::Status&)> alarm_of;
  /// Whether such an end has stopped the machine, or told it to stop: motions that it had accepted are lost.
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

/// The job of an executor, by what its node says: states on one topic, results on another, in any order. A
/// job that was ordered here ends by its result alone, as a state may be that of the job before.
class FollowedJob {
 public:
  explicit FollowedJob(ExecutorLanguage language);

  void begin(const StartOrder& order, double now_s, const ros::Time& now);
  /// The order has come through; its file may still be read.
  void takeUp(std::uint64_t order);
  /// Whether a job was ordered that has not ended.
  bool isOrdered() const { return order_.has_value(); }
  /// Whether the machine has said nothing yet of the job that was ordered.
  bool isAwaited() const { return order_ && !has_begun_; }
  /// Whether the order to start has not come through for so long; then the time begins anew. [s]
  bool takeUntaken(double now_s, double patience_s);

  /// @return what is to be reported; nothing if it says nothing new of the job
  std::optional<ExecutorReport> hear(const lamina_msgs::MachineState& state);
  std::optional<ExecutorReport> end(std::uint64_t order, const JobEnd& end);
  /// What is printed of the job; of another, or from before the order, it counts for nothing.
  void hear(const lamina_msgs::PrintProgress& printed) { printed_ = printed; }

  const lamina_msgs::MachineState& machine() const { return machine_; }
  /// What was said last; nothing if nothing was.
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
  std::string program_;                 ///< of what was ordered last
  ros::Time ordered_;
  double ordered_s_ = 0.0;
  bool is_taken_up_ = false;  ///< what was ordered last
  bool has_begun_ = false;    ///< the same, by the state of the machine
  bool has_run_ = false;      ///< whether it has been run since
  ExecutorReport last_;       ///< of it
};

/// The phase of an executor whose node is in that state.
ExecutorPhase phaseOf(const lamina_msgs::MachineState& state);

}  // namespace lamina
