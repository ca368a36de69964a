// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream_report.hpp"

#include <utility>

#include "stream_messages.hpp"

namespace lamina {

StreamReport::StreamReport(Publish publish) : publish_(std::move(publish)) {}

void StreamReport::begin(const std::string& job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  job_ = job;
  status_ = {};
  status_.state = PackmlState::Starting;
  tell();
}

void StreamReport::rename(const std::string& job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  job_ = job;
}

StatusNews StreamReport::take(const StreamStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // It was read before the end, and comes after it.
  if (isFinal(status_.state) && !isFinal(status.state)) return {};
  // What the port says before the session has begun: to who follows the job, Idle is another process.
  if (status.state == PackmlState::Idle) return {};
  StatusNews news;
  news.is_state = status.state != status_.state;
  news.is_warning = !status.warning.empty() && status.warning != status_.warning;
  news.is_position = status.position && (!status_.position || *status.position != *status_.position);
  status_ = status;
  if (news.is_state) tell();
  return news;
}

std::vector<lamina_msgs::StartupStep> StreamReport::takeSteps(std::vector<lamina_msgs::StartupStep> steps) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(steps_, std::move(steps));
}

void StreamReport::publish() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  tell();
}

void StreamReport::tell() const {
  lamina_msgs::MachineState message = toMachineState(status_, job_);
  message.startup = steps_;
  publish_(message, toHeaterState(status_));
}

StreamStatus StreamReport::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

std::string StreamReport::job() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return job_;
}

std::vector<lamina_msgs::StartupStep> StreamReport::steps() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return steps_;
}

}  // namespace lamina
