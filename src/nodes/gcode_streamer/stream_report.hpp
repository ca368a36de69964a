// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "lamina/streaming/job/stream_job.hpp"
#include "messages.hpp"

namespace lamina {

/// What is new in a status.
struct StatusNews {
  bool is_state = false;  ///< another state
  bool is_warning = false;
  bool is_position = false;
};

/// The status of the job under way, or of the last one, and of the start-up, as it is published. Messages of
/// all threads are published one after the other: the last one holds. All functions may be called from any
/// thread.
class StreamReport {
 public:
  /// Called with messages without stamps; must not call the report.
  using Publish = std::function<void(const lamina_msgs::MachineState&, const lamina_msgs::HeaterState&)>;

  explicit StreamReport(Publish publish);

  /// States that a job is accepted, and publishes its state, Starting.
  /// @param job  file or toolpath
  void begin(const std::string& job);
  /// @param job  toolpath with which the job continues
  void rename(const std::string& job);
  /// Takes the present status of the job, and publishes it if the state has changed. After the end of the job
  /// a status that is not final is ignored.
  StatusNews take(const StreamStatus& status);
  /// Takes the present steps of the start-up.
  /// @return those taken before
  std::vector<lamina_msgs::StartupStep> takeSteps(std::vector<lamina_msgs::StartupStep> steps);
  /// Publishes the present state again.
  void publish() const;

  StreamStatus status() const;
  std::string job() const;
  std::vector<lamina_msgs::StartupStep> steps() const;

 private:
  void tell() const;

  Publish publish_;
  mutable std::mutex mutex_;  ///< guards everything below; also held during publication
  StreamStatus status_;
  std::string job_;
  std::vector<lamina_msgs::StartupStep> steps_;
};

}  // namespace lamina
