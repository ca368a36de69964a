// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/startup/startup_session.hpp"

namespace lamina {

/// What a start-up session does, behind its interface. One thread at a time has the port: that of the
/// session, or that of the job it is lent to.
class StartupSession::Impl {
 public:
  Impl(const StartupSettings& settings, const StreamSettings& stream, MachinePort port, Observer changed);
  ~Impl();

  bool isEmpty() const { return startup_.isEmpty(); }
  bool awaits(StartupStep step) const;
  std::vector<StartupStatus> steps() const;
  void run(std::optional<StartupStep> step);
  void confirm(StartupStep step);
  void transferred(const ProgramIdentity& program);
  void abort();
  bool isBusy() const;
  void beginJob(const ProgramIdentity& program);
  void heard(const MarlinReply& reply);
  void endJob(const StreamableProgram& program, const StreamStatus& status);

 private:
  using Lock = std::unique_lock<std::mutex>;
  using MayGoOn = std::function<bool()>;

  /// What the session's own thread has to do.
  enum class Task { None, Step, AllSteps, Abort };
  /// Who has the port.
  enum class PortUser { Nobody, Session, Job };

  double now() const { return clock_.now() * settings_.speed_up; }
  void requireNoJob() const;
  void requireIdle() const;
  void tell(Lock& lock);

  void lookBeforeJob(Lock& lock);
  void work();
  void drive(Lock& lock, StartupStep step);
  void onFailure(Lock& lock, StartupStep step, const Error& error);
  void driveAll(Lock& lock);
  void look(Lock& lock);
  void giveUpAll(Lock& lock);
  std::string leaveSafe(Lock& lock);
  void stream(Lock& lock, const std::string& code, const MayGoOn& mayGoOn);
  StreamStatus runSession(const StreamableProgram& program, const MayGoOn& mayGoOn);
  void noteSent(const StreamableProgram& program, const StreamStatus& status);
  bool isWanted(StartupStep step) const;
  bool isInterrupted() const;

  StartupSettings settings_;
  StreamSettings stream_;
  MachinePort port_;
  Observer changed_;
  SteadyClock clock_;
  mutable std::mutex mutex_;  ///< of everything below
  std::condition_variable wake_;
  Startup startup_;
  Task task_ = Task::None;
  StartupStep step_ = StartupStep::PowerOn;  ///< of Task::Step
  PortUser port_user_ = PortUser::Nobody;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
