// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_session.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "startup/startup_code.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"

namespace lamina {

/// What a start-up session does, behind its interface. One thread at a time has the port: that of the
/// session, or that of the job it is lent to.
class StartupSession::Impl {
 public:
  Impl(const StartupSettings& settings, const StreamSettings& stream, MachinePort port, Observer changed);
  ~Impl() {
    {
      const Lock lock(mutex_);
      port_user_ = PortUser::Nobody;  // nobody is left who would say that a job has ended
    }
    end();
  }

  bool isEmpty() const { return startup_.isEmpty(); }
  bool awaits(StartupStep step) const;
  StartupReport report() const;
  void run(std::optional<StartupStep> step);
  void confirm(StartupStep step);
  void transferred(const ProgramIdentity& program);
  void abort();
  bool isBusy() const;
  void beginJob(const ProgramIdentity& program, const MayGoOn& mayGoOn);
  void watchJob(const StreamableProgram& program, WatchedLines lines);
  std::vector<JobLoss> losses(const StreamStatus& status);
  std::string questions() const;
  void heard(const FirmwareReply& reply);
  void endJob(const StreamableProgram& program, const StreamStatus& status);
  void end();

 private:
  using Lock = std::unique_lock<std::mutex>;

  /// What the session's own thread has to do.
  enum class Task { None, Step, AllSteps, Abort };
  /// Who has the port.
  enum class PortUser { Nobody, Session, Job };

  double now() const { return clock_.now() * settings_.speed_up; }
  void requireNoJob() const;
  void requireIdle() const;
  void notify(Lock& lock);
  StartupReport known() const;
  bool isToBeWatched() const { return startup_.hasMachineAtWork() || may_be_on_; }

  void awaitPort(Lock& lock, const MayGoOn& mayGoOn);
  void lookBeforeJob(Lock& lock, const MayGoOn& mayGoOn);
  void work();
  void drive(Lock& lock, StartupStep step);
  void onFailure(Lock& lock, StartupStep step, const Error& error);
  void driveAll(Lock& lock);
  void look(Lock& lock);
  void giveUpAll(Lock& lock);
  /// Since when nothing was answered, and how many answers came before.
  struct Patience {
    double since_s = 0.0;
    std::uint64_t answers = 0;
  };
  bool hasPatience(Patience& patience);
  std::string leaveSafe(Lock& lock);
  void stream(Lock& lock, const std::string& code, const MayGoOn& mayGoOn);
  void streamStep(Lock& lock, const std::string& code, const MayGoOn& mayGoOn);
  StreamStatus send(Lock& lock, const std::string& code, const MayGoOn& mayGoOn);
  StreamStatus runSession(const StreamableProgram& program, const MayGoOn& mayGoOn);
  void noteSent(const StreamableProgram& program, const StreamStatus& status);
  std::vector<std::string> linesUpTo(std::uint64_t sent);
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
  bool may_be_on_ = false;  ///< whether what a step has switched on is not known to be off
  struct WatchedJob {
    JobWatch watch;
    bool was_dry = false;  ///< when it began
  };
  std::optional<WatchedJob> job_;
  std::uint64_t answers_ = 0;  ///< oks of the machine
  bool is_ending_ = false;
  std::thread thread_;
  /// Lines of the job that were sent. Of the job's thread alone: while it waits for a disk, what the machine
  /// says is heard.
  struct SentLines {
    ProgramCursor cursor;
    std::uint64_t read = 0;
  };
  std::optional<SentLines> sent_lines_;
};

namespace {

/// @throws InvalidConfig if a code of the settings cannot be streamed
void requireStreamable(const StartupSettings& settings, const StreamSettings& stream) {
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
      StreamableProgram::fromText(key, code, stream);
    } catch (const InvalidProgram& error) {
      throw InvalidConfig(error.what());
    }
  }
}

/// A machine that has started anew or halted has switched its heaters off.
bool saysThatAllIsOff(const FirmwareReply& reply) {
  if (reply.kind == ReplyKind::Start || reply.kind == ReplyKind::Fatal) return true;
  return reply.temperatures && heatsNothing(*reply.temperatures);
}

constexpr double kPoll = 0.1;  // s
constexpr const char* kEnded = "the start-up's process was ended";

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

StartupSession::Impl::Impl(const StartupSettings& settings, const StreamSettings& stream, MachinePort port,
                           Observer changed)
    : settings_(settings),
      stream_(stream),
      port_(std::move(port)),
      changed_(std::move(changed)),
      startup_(settings) {
  if (isEmpty()) return;
  requireStreamable(settings, stream);
  thread_ = std::thread([this] { work(); });
}

void StartupSession::Impl::end() {
  {
    const Lock lock(mutex_);
    is_ending_ = true;
    wake_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

bool StartupSession::Impl::awaits(StartupStep step) const {
  const Lock lock(mutex_);
  return startup_.awaits(step);
}

StartupReport StartupSession::Impl::report() const {
  const Lock lock(mutex_);
  return known();
}

/// The report, to be called while the session is locked. A bed that the operator heats is switched off at the
/// end, too.
StartupReport StartupSession::Impl::known() const {
  return {startup_.steps(), may_be_on_ || startup_.stateOf(StartupStep::HeatBed) == StartupState::Done};
}

bool StartupSession::Impl::isBusy() const {
  const Lock lock(mutex_);
  return task_ != Task::None;
}

void StartupSession::Impl::requireNoJob() const {
  if (is_ending_) throw Rejected(kEnded);
  if (port_user_ == PortUser::Job) throw Rejected("a job is under way; expected the machine to be free");
}

void StartupSession::Impl::requireIdle() const {
  requireNoJob();
  if (task_ == Task::Abort) throw Rejected("the start-up is being aborted; expected that to be over");
  if (task_ != Task::None) throw Rejected("a step is being run; expected that to be over");
}

/// Reports the observer, which must not find the session locked.
void StartupSession::Impl::notify(Lock& lock) {
  if (!changed_) return;
  const StartupReport report = known();
  lock.unlock();
  changed_(report);
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
  notify(lock);
}

void StartupSession::Impl::confirm(StartupStep step) {
  Lock lock(mutex_);
  requireNoJob();
  startup_.confirm(step, now());

  notify(lock);
}

void StartupSession::Impl::transferred(const ProgramIdentity& program) {
  Lock lock(mutex_);
  requireNoJob();
  startup_.onTransferred(program, now());
  notify(lock);
}

void StartupSession::Impl::abort() {
  const Lock lock(mutex_);
  requireNoJob();
  if (isEmpty()) throw Rejected("startup.sequence is empty; there is nothing to abort");
  task_ = Task::Abort;
  wake_.notify_all();
}

void StartupSession::Impl::beginJob(const ProgramIdentity& program, const MayGoOn& mayGoOn) {
  Lock lock(mutex_);
  requireIdle();
  if (isEmpty()) return;
  startup_.elapse(now());
  startup_.requireReadyFor(program);
  awaitPort(lock, mayGoOn);
  requireIdle();
  port_user_ = PortUser::Job;
  try {
    lookBeforeJob(lock, mayGoOn);
    startup_.requireReadyFor(program);
  } catch (const Error&) {
    port_user_ = PortUser::Nobody;
    wake_.notify_all();
    throw;
  }
}

void StartupSession::Impl::awaitPort(Lock& lock, const MayGoOn& mayGoOn) {
  constexpr std::chrono::duration<double> kInterval(kPoll);
  for (;;) {
    {
      const Unlocked unlocked(lock);
      if (!mayGoOn()) throw Cancelled("the job is not to begin any more");
    }
    if (wake_.wait_for(lock, kInterval, [this] { return port_user_ != PortUser::Session; })) return;
  }
}

void StartupSession::Impl::lookBeforeJob(Lock& lock, const MayGoOn& mayGoOn) {
  if (!isToBeWatched()) return;
  try {
    stream(lock, settings_.check_code, mayGoOn);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Cancelled) startup_.forgetMachine(error.what());
    throw;
  }
}

void StartupSession::Impl::heard(const FirmwareReply& reply) {
  const Lock lock(mutex_);
  if (reply.kind == ReplyKind::Ok) ++answers_;
  startup_.onReply(reply, now());
  if (saysThatAllIsOff(reply)) may_be_on_ = false;
  if (job_) job_->watch.onReply(reply, now());
}

void StartupSession::Impl::watchJob(const StreamableProgram& program, WatchedLines lines) {
  if (isEmpty()) return;
  sent_lines_.emplace(SentLines{program.open(), 0});
  const Lock lock(mutex_);
  // Of a dryer that reports nothing, the clock alone would end a long job.
  const bool is_dry =
      !settings_.dry_label.empty() && startup_.stateOf(StartupStep::DryPellets) == StartupState::Done;
  job_.emplace(WatchedJob{JobWatch(settings_, lines), is_dry});
}

/// Those that were sent since the last call.
std::vector<std::string> StartupSession::Impl::linesUpTo(std::uint64_t sent) {
  std::vector<std::string> lines;
  if (!sent_lines_) return lines;
  for (; sent_lines_->read < sent; ++sent_lines_->read) {
    auto line = sent_lines_->cursor.next();
    if (!line) break;
    lines.push_back(std::move(line->command));
  }
  return lines;
}

std::vector<JobLoss> StartupSession::Impl::losses(const StreamStatus& status) {
  const std::vector<std::string> sent = linesUpTo(status.lines_sent);
  const Lock lock(mutex_);
  if (!job_) return {};
  for (const std::string& command : sent) job_->watch.onSent(command);
  startup_.elapse(now());
  std::vector<JobLoss> losses = job_->watch.losses();
  if (job_->was_dry && startup_.stateOf(StartupStep::DryPellets) != StartupState::Done)
    for (const StartupStatus& step : startup_.steps())
      if (step.step == StartupStep::DryPellets) losses.push_back({KeptCondition::Dryness, step.reason, 0.0});
  return losses;
}

/// Temperatures come by themselves.
std::string StartupSession::Impl::questions() const {
  if (isEmpty()) return {};
  std::istringstream lines(settings_.check_code);
  std::string questions;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && codeOf(line) != "M105") questions += line + '\n';
  return questions;
}

void StartupSession::Impl::endJob(const StreamableProgram& program, const StreamStatus& status) {
  sent_lines_.reset();
  Lock lock(mutex_);
  job_.reset();
  port_user_ = PortUser::Nobody;
  wake_.notify_all();
  noteSent(program, status);
  const ErrorCode code = status.failure.code;
  if (code != ErrorCode::Ok && code != ErrorCode::Cancelled) startup_.forgetMachine(status.failure.message);
  notify(lock);
}

StartupSession::StartupSession(const StartupSettings& settings, const StreamSettings& stream,
                               const MachinePort& port, Observer changed)
    : impl_(std::make_unique<Impl>(settings, stream, port, std::move(changed))) {}
StartupSession::~StartupSession() = default;

bool StartupSession::isEmpty() const { return impl_->isEmpty(); }
StartupReport StartupSession::report() const { return impl_->report(); }
bool StartupSession::awaits(StartupStep step) const { return impl_->awaits(step); }
void StartupSession::run(std::optional<StartupStep> step) { impl_->run(step); }
void StartupSession::confirm(StartupStep step) { impl_->confirm(step); }
void StartupSession::transferred(const ProgramIdentity& program) { impl_->transferred(program); }
void StartupSession::abort() { impl_->abort(); }
bool StartupSession::isBusy() const { return impl_->isBusy(); }
void StartupSession::beginJob(const ProgramIdentity& program, const MayGoOn& mayGoOn) {
  impl_->beginJob(program, mayGoOn);
}
void StartupSession::watchJob(const StreamableProgram& program, WatchedLines lines) {
  impl_->watchJob(program, lines);
}
std::vector<JobLoss> StartupSession::losses(const StreamStatus& status) { return impl_->losses(status); }
std::string StartupSession::questions() const { return impl_->questions(); }
void StartupSession::heard(const FirmwareReply& reply) { impl_->heard(reply); }
void StartupSession::endJob(const StreamableProgram& program, const StreamStatus& status) {
  impl_->endJob(program, status);
}
void StartupSession::end() { impl_->end(); }

// What the thread of a start-up session does.

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
    notify(lock);
  }
  wake_.wait(lock, [this] { return port_user_ != PortUser::Job; });
  if (!isToBeWatched()) return;
  const bool is_safe = leaveSafe(lock).empty() && !settings_.abort_code.empty();
  if (is_safe) startup_.forgetMachine(kEnded);
  for (const StartupStep step : allStartupSteps())
    if (is_safe) startup_.giveUp(step, kEnded);
  // A receiver whose last report is of a hot bed would have the machine stopped once more.
  notify(lock);
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
      streamStep(lock, *code, [this, step] { return isWanted(step); });
      startup_.onCodeFinished(step, now());
      notify(lock);
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
  if (error.code() != ErrorCode::Cancelled) startup_.forgetMachine(error.what());
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

/// Asks the machine how it is, as long as it does anything or may have something on.
void StartupSession::Impl::look(Lock& lock) {
  startup_.elapse(now());
  if (port_user_ != PortUser::Nobody || !isToBeWatched()) return;
  port_user_ = PortUser::Session;
  try {
    stream(lock, settings_.check_code, [this] {
      const Lock asking(mutex_);
      return !isInterrupted();
    });
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Cancelled) startup_.forgetMachine(error.what());
  }
  // A bed that the operator heats has nobody else who looks when it is hot.
  if (task_ == Task::None) startup_.onCodeFinished(StartupStep::HeatBed, now());
  port_user_ = PortUser::Nobody;
  wake_.notify_all();
}

void StartupSession::Impl::giveUpAll(Lock& lock) {
  const std::string remark = leaveSafe(lock);
  for (const StartupStep step : allStartupSteps()) startup_.giveUp(step, "aborted on request" + remark);
}

/// A machine that waits for a person or for heat reports that it is busy, for ever: it is waited for as long
/// as somebody may end that wait, but once the node ends only while it takes lines.
bool StartupSession::Impl::hasPatience(Patience& patience) {
  const Lock lock(mutex_);
  if (!is_ending_ || answers_ != patience.answers) patience = {clock_.now(), answers_};
  return clock_.now() - patience.since_s < stream_.safe_stop_timeout_s;
}

/// @return what must be reported if it was not possible; empty if it was
std::string StartupSession::Impl::leaveSafe(Lock& lock) {
  if (settings_.abort_code.empty()) return {};
  std::string why;
  try {
    stream(lock, settings_.abort_code,
           [this, patience = Patience{clock_.now(), answers_}]() mutable { return hasPatience(patience); });
    may_be_on_ = false;
    return {};
  } catch (const Cancelled&) {
    why = "it has not run startup.abort_code, nor a line of it within " +
          shortNumber(stream_.safe_stop_timeout_s) + " s";
  } catch (const Error& error) {
    why = error.what();
  }
  const std::string remark = "the machine could not be left safe, look after it: " + why;
  startup_.forgetMachine(remark);
  return "; " + remark;
}

void StartupSession::Impl::stream(Lock& lock, const std::string& code, const MayGoOn& mayGoOn) {
  throwIfFailed(send(lock, code, mayGoOn));
}

/// What was sent may have been run, also if the link was lost over it.
void StartupSession::Impl::streamStep(Lock& lock, const std::string& code, const MayGoOn& mayGoOn) {
  const StreamStatus status = send(lock, code, mayGoOn);
  may_be_on_ = may_be_on_ || status.lines_sent > 0;
  throwIfFailed(status);
}

StreamStatus StartupSession::Impl::send(Lock& lock, const std::string& code, const MayGoOn& mayGoOn) {
  const auto program = StreamableProgram::fromText("start-up", code, stream_);
  StreamStatus status;
  {
    const Unlocked unlocked(lock);
    status = runSession(program, mayGoOn);
  }
  noteSent(program, status);
  return status;
}

StreamStatus StartupSession::Impl::runSession(const StreamableProgram& program, const MayGoOn& mayGoOn) {
  StreamSession session(program, stream_, port_, {},
                        {[this](const FirmwareReply& reply) { heard(reply); }, {}});
  while (!session.waitFor(kPoll)) {
    if (changed_) changed_(report());
    if (!mayGoOn()) session.abort({ErrorCode::Cancelled, "the start-up was aborted"});
  }
  return session.status();
}

/// Whatever was sent counts as run, so that nothing is believed that may be lost.
void StartupSession::Impl::noteSent(const StreamableProgram& program, const StreamStatus& status) {
  const ErrorCode code = status.failure.code;
  if (program.hasChanged())
    return startup_.forgetMachine(program.name() + " was changed while it was streamed");
  try {
    ProgramCursor cursor = program.open();
    for (std::uint64_t line = 0; line < status.lines_sent; ++line) {
      const auto command = cursor.next();
      if (!command) break;
      startup_.onCommandSent(command->command);
    }
  } catch (const std::exception& error) {
    startup_.forgetMachine(error.what());  // what was sent is not known
  }
  if (code != ErrorCode::Cancelled) return;
  startup_.onCommandSent("M410");
  if (!stream_.keep_heaters_on) startup_.onCommandSent("M140 S0");
}

}  // namespace lamina
