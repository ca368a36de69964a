// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {

/// Interface of the kinds of sessions. A session runs a job in a thread of its own; all calls may come from
/// any thread.
class SessionKind {
 public:
  virtual ~SessionKind() = default;

  virtual void pause() = 0;
  virtual void resume() = 0;
  virtual std::string change(const LiveChange& change) = 0;
  virtual void ask(const std::string& commands) = 0;
  virtual void abort(const Failure& why) = 0;
  virtual StreamStatus status() const = 0;
  virtual bool isOver() const = 0;
  virtual bool waitFor(double timeout_s) const = 0;
};

/// The answer of a session's thread to a change, or a message that it did not answer in time.
inline std::string answerOf(std::future<std::string> answer) {
  constexpr std::chrono::seconds kPatience{2};
  if (answer.wait_for(kPatience) == std::future_status::ready) return answer.get();
  return "the session did not answer within 2 s; the change may still be done";
}

/// The status of a session for other threads, and the observer that is called with it.
class SessionRecord {
 public:
  /// @param port  name with which messages of failures begin
  SessionRecord(std::string port, StreamSession::Observer observer)
      : port_(std::move(port)), observer_(std::move(observer)) {}

  /// Copies the job's status and the states that it has entered; to be called from the session's thread.
  /// Progress without a change of state is passed on at most twenty times a second.
  void publish(StreamStatus status, const std::vector<PackmlState>& entered, double now);
  void finish();

  StreamStatus status() const;
  bool isOver() const;
  bool waitFor(double timeout_s) const;

 private:
  std::string port_;
  StreamSession::Observer observer_;
  double next_progress_ = 0.0;
  mutable std::mutex mutex_;
  mutable std::condition_variable over_;
  StreamStatus snapshot_;
  bool is_over_ = false;
};

/// A session that uploads the program to a print server.
/// @throws Disconnected, FileError, InvalidProgram, InvalidInput, InvalidConfig
std::unique_ptr<SessionKind> beginUpload(const StreamableProgram& program, const StreamSettings& settings,
                                         const MachinePort& port, StreamSession::Observer observer,
                                         const SessionOptions& options);

}  // namespace lamina
