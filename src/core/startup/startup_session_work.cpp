// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the thread of a start-up session does.
#include <chrono>

#include "lamina/base/error.hpp"
#include "startup/startup_session_impl.hpp"

namespace lamina {
namespace {

constexpr double kPoll = 0.1;  // s

/// Leaves a mutex alone while it lives.
class Unlocked {
 public:
  explicit Unlocked(std::unique_lock<std::mutex>& lock) : lock_(lock) { lock_.unlock(); }
  ~Unlocked() { lock_.lock(); }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  std::unique_lock<std::mutex>& lock_;
};

}  // namespace

void StartupSession::Impl::work() {
  Lock lock(mutex_);
  const std::chrono::duration<double> interval(settings_.check_interval_s);
  while (!is_ending_) {
    wake_.wait_for(lock, interval, [this] { return is_ending_ || task_ != Task::None; });
    if (is_ending_) break;
    const Task task = task_;
    if (task == Task::Step) drive(lock, step_);
    if (task == Task::AllSteps) driveAll(lock);
    if (task == Task::Abort) giveUpAll(lock);
    if (task == Task::None) look(lock);
    // Aborted meanwhile: that is the next task.
    if (task_ == task) task_ = Task::None;
    tell(lock);
  }
  if (startup_.hasMachineAtWork()) leaveSafe(lock);
}

bool StartupSession::Impl::isInterrupted() const { return is_ending_ || task_ == Task::Abort; }

bool StartupSession::Impl::isWanted(StartupStep step) const {
  const Lock lock(mutex_);
  return !isInterrupted() && startup_.stateOf(step) == StartupState::Running;
}

void StartupSession::Impl::drive(Lock& lock, StartupStep step) {
  try {
    while (!isInterrupted()) {
      const auto code = startup_.nextCode(step);
      if (!code) break;
      stream(lock, *code, [this, step] { return isWanted(step); });
      startup_.finished(step, now());
      tell(lock);
    }
    // A bed that does not heat as it should must not go on.
    if (step == StartupStep::HeatBed && startup_.stateOf(step) == StartupState::Failed)
      startup_.addRemark(step, leaveSafe(lock));
  } catch (const Error& error) {
    onFailure(lock, step, error);
  }
}

void StartupSession::Impl::onFailure(Lock& lock, StartupStep step, const Error& error) {
  if (isInterrupted()) return;
  startup_.fail(step, error.what());
  if (error.code() != ErrorCode::Cancelled) startup_.losePower(error.what());
  startup_.addRemark(step, leaveSafe(lock));
}

void StartupSession::Impl::driveAll(Lock& lock) {
  while (!isInterrupted()) {
    const auto step = startup_.nextAutomatic();
    if (!step) return;
    startup_.begin(*step, now());
    drive(lock, *step);
    const StartupState state = startup_.stateOf(*step);
    if (state != StartupState::Running && state != StartupState::Done) return;
  }
}

/// Asks the machine how it is, as long as it does anything.
void StartupSession::Impl::look(Lock& lock) {
  startup_.elapse(now());
  if (port_user_ != PortUser::Nobody || !startup_.hasMachineAtWork()) return;
  port_user_ = PortUser::Session;
  try {
    stream(lock, settings_.check_code, [this] {
      const Lock asking(mutex_);
      return !isInterrupted();
    });
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Cancelled) startup_.losePower(error.what());
  }
  // A bed that the operator heats has nobody else who looks when it is hot.
  if (task_ == Task::None) startup_.finished(StartupStep::HeatBed, now());
  port_user_ = PortUser::Nobody;
  wake_.notify_all();
}

void StartupSession::Impl::giveUpAll(Lock& lock) {
  const std::string remark = leaveSafe(lock);
  for (const StartupStep step : allStartupSteps()) startup_.giveUp(step, "aborted on request" + remark);
}

/// @return what must be reported if it was not possible; empty if it was
std::string StartupSession::Impl::leaveSafe(Lock& lock) {
  if (settings_.abort_code.empty()) return {};
  try {
    stream(lock, settings_.abort_code, [] { return true; });
    return {};
  } catch (const Error& error) {
    startup_.losePower(error.what());
    return std::string("; the machine could not be left safe, look after it: ") + error.what();
  }
}

void StartupSession::Impl::stream(Lock& lock, const std::string& code, const MayGoOn& mayGoOn) {
  const auto program = StreamableProgram::fromText("start-up", code, stream_.max_line_bytes);
  StreamStatus status;
  {
    const Unlocked unlocked(lock);
    status = runSession(program, mayGoOn);
  }
  noteSent(program, status);
  throwIfFailed(status);
}

StreamStatus StartupSession::Impl::runSession(const StreamableProgram& program, const MayGoOn& mayGoOn) {
  StreamSession session(program, stream_, port_, {}, [this](const MarlinReply& reply) { heard(reply); });
  while (!session.waitFor(kPoll)) {
    if (changed_) changed_(steps());
    if (!mayGoOn()) session.abort({ErrorCode::Cancelled, "the start-up was aborted"});
  }
  return session.status();
}

/// Whatever was sent counts as run, so that nothing is believed that may be lost.
void StartupSession::Impl::noteSent(const StreamableProgram& program, const StreamStatus& status) {
  const ErrorCode code = status.failure.code;
  if (program.hasChanged()) return startup_.losePower(program.name() + " was changed while it was streamed");
  ProgramCursor cursor = program.open();
  for (std::uint64_t line = 0; line < status.lines_sent; ++line) {
    const auto command = cursor.next();
    if (!command) break;
    startup_.sent(command->command);
  }
  if (code != ErrorCode::Cancelled) return;
  startup_.sent("M410");
  if (!stream_.keep_heaters_on) startup_.sent("M140 S0");
}

}  // namespace lamina
