// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_session.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "startup/startup_code.hpp"
#include "startup/startup_session_impl.hpp"

namespace lamina {
namespace {

/// @throws InvalidConfig if a code of the settings cannot be streamed
void requireStreamable(const StartupSettings& settings, int max_line_bytes) {
  const std::vector<std::pair<const char*, std::string>> codes = {
      {"startup.check_code", settings.check_code},
      {"startup.abort_code", settings.abort_code},
      {"startup.dry_code", filled(settings.dry_code, "{target_c}", shortNumber(settings.dry_target_c))},
      {"startup.bed_code", filled(settings.bed_code, "{target_c}", shortNumber(settings.bed_target_c))},
      {"startup.home_code", filled(settings.home_code, "{axis}", "Z")},
      {"startup.vacuum_on_code", filled(settings.vacuum_on_code, "{zone}", "1")},
      {"startup.vacuum_off_code", filled(settings.vacuum_off_code, "{zone}", "1")},
      {"startup.map_code", settings.map_code}};
  for (const auto& [key, code] : codes) {
    if (code.empty()) continue;
    try {
      StreamableProgram::fromText(key, code, max_line_bytes);
    } catch (const InvalidProgram& error) {
      throw InvalidConfig(error.what());
    }
  }
}

}  // namespace

StartupSession::Impl::Impl(const StartupSettings& settings, const StreamSettings& stream, MachinePort port,
                           Observer changed)
    : settings_(settings),
      stream_(stream),
      port_(std::move(port)),
      changed_(std::move(changed)),
      startup_(settings) {
  if (isEmpty()) return;
  requireStreamable(settings, stream.max_line_bytes);
  thread_ = std::thread([this] { work(); });
}

StartupSession::Impl::~Impl() {
  if (!thread_.joinable()) return;
  {
    const Lock lock(mutex_);
    is_ending_ = true;
    wake_.notify_all();
  }
  thread_.join();
}

bool StartupSession::Impl::awaits(StartupStep step) const {
  const Lock lock(mutex_);
  return startup_.awaits(step);
}

std::vector<StartupStatus> StartupSession::Impl::steps() const {
  const Lock lock(mutex_);
  return startup_.steps();
}

bool StartupSession::Impl::isBusy() const {
  const Lock lock(mutex_);
  return task_ != Task::None;
}

void StartupSession::Impl::requireNoJob() const {
  if (port_user_ == PortUser::Job) throw Rejected("a job is under way; expected the machine to be free");
}

void StartupSession::Impl::requireIdle() const {
  requireNoJob();
  if (task_ == Task::Abort) throw Rejected("the start-up is being aborted; expected that to be over");
  if (task_ != Task::None) throw Rejected("a step is being run; expected that to be over");
}

/// Reports the observer, which must not find the session locked.
void StartupSession::Impl::tell(Lock& lock) {
  if (!changed_) return;
  const std::vector<StartupStatus> steps = startup_.steps();
  lock.unlock();
  changed_(steps);
  lock.lock();
}

void StartupSession::Impl::run(std::optional<StartupStep> step) {
  Lock lock(mutex_);
  requireIdle();
  if (step) {
    startup_.begin(*step, now());
    step_ = *step;
  } else if (!startup_.nextAutomatic()) {
    startup_.requireReady();
    throw Rejected("the machine is started up; no step is left to run");
  }
  task_ = step ? Task::Step : Task::AllSteps;
  wake_.notify_all();
  tell(lock);
}

void StartupSession::Impl::confirm(StartupStep step) {
  Lock lock(mutex_);
  requireNoJob();
  startup_.confirm(step, now());

  tell(lock);
}

void StartupSession::Impl::transferred(const ProgramIdentity& program) {
  Lock lock(mutex_);
  requireNoJob();
  startup_.transferred(program, now());
  tell(lock);
}

void StartupSession::Impl::abort() {
  const Lock lock(mutex_);
  requireNoJob();
  if (isEmpty()) throw Rejected("startup.sequence is empty; there is nothing to abort");
  task_ = Task::Abort;
  wake_.notify_all();
}

void StartupSession::Impl::beginJob(const ProgramIdentity& program) {
  Lock lock(mutex_);
  requireIdle();
  if (isEmpty()) return;
  startup_.elapse(now());
  startup_.requireReadyFor(program);
  wake_.wait(lock, [this] { return port_user_ != PortUser::Session; });
  requireIdle();
  port_user_ = PortUser::Job;
  try {
    lookBeforeJob(lock);
    startup_.requireReadyFor(program);
  } catch (const Error&) {
    port_user_ = PortUser::Nobody;
    throw;
  }
}

void StartupSession::Impl::lookBeforeJob(Lock& lock) {
  if (!startup_.hasMachineAtWork()) return;
  try {
    stream(lock, settings_.check_code, [] { return true; });
  } catch (const Error& error) {
    startup_.losePower(error.what());
    throw;
  }
}

void StartupSession::Impl::heard(const MarlinReply& reply) {
  const Lock lock(mutex_);
  startup_.read(reply, now());
}

void StartupSession::Impl::endJob(const StreamableProgram& program, const StreamStatus& status) {
  Lock lock(mutex_);
  noteSent(program, status);
  const ErrorCode code = status.failure.code;
  if (code != ErrorCode::Ok && code != ErrorCode::Cancelled) startup_.losePower(status.failure.message);
  port_user_ = PortUser::Nobody;
  wake_.notify_all();
  tell(lock);
}

StartupSession::StartupSession(const StartupSettings& settings, const StreamSettings& stream,
                               const MachinePort& port, Observer changed)
    : impl_(std::make_unique<Impl>(settings, stream, port, std::move(changed))) {}
StartupSession::~StartupSession() = default;

bool StartupSession::isEmpty() const { return impl_->isEmpty(); }
std::vector<StartupStatus> StartupSession::steps() const { return impl_->steps(); }
bool StartupSession::awaits(StartupStep step) const { return impl_->awaits(step); }
void StartupSession::run(std::optional<StartupStep> step) { impl_->run(step); }
void StartupSession::confirm(StartupStep step) { impl_->confirm(step); }
void StartupSession::transferred(const ProgramIdentity& program) { impl_->transferred(program); }
void StartupSession::abort() { impl_->abort(); }
bool StartupSession::isBusy() const { return impl_->isBusy(); }
void StartupSession::beginJob(const ProgramIdentity& program) { impl_->beginJob(program); }
void StartupSession::heard(const MarlinReply& reply) { impl_->heard(reply); }
void StartupSession::endJob(const StreamableProgram& program, const StreamStatus& status) {
  impl_->endJob(program, status);
}

}  // namespace lamina
