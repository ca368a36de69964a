// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "startup/startup_checks.hpp"
#include "startup/startup_code.hpp"

namespace lamina {
namespace {

/// The entry of a step, or null.
template <class Entries>
auto* findIn(Entries& entries, StartupStep step) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.status.step == step; });
  return found == entries.end() ? nullptr : &*found;
}

// Between two looks at a bed that is still to become hot [s].
constexpr double kBedPoll = 10.0;

std::string withChecks(const std::string& code, const StartupSettings& settings) {
  return code + "\n" + settings.check_code + "\n";
}

}  // namespace

Startup::Startup(const StartupSettings& settings)
    : settings_(settings), reports_(settings), vacuum_off_(vacuumOffCommands(settings)) {
  for (SequencedStep& sequenced : makeStartupSequence(settings)) {
    Entry entry;
    entry.after = std::move(sequenced.after);
    entry.status.step = sequenced.step;
    if (sequenced.is_skipped) {
      entry.status.state = StartupState::Skipped;
      entry.status.reason = "left out by startup.skip";
    }
    entries_.push_back(std::move(entry));
  }
}

Startup::Entry* Startup::find(StartupStep step) { return findIn(entries_, step); }

const Startup::Entry* Startup::find(StartupStep step) const { return findIn(entries_, step); }

Startup::Entry& Startup::entryOf(StartupStep step) {
  Entry* const entry = find(step);
  if (entry == nullptr)
    throw InvalidInput(std::string("step ") + toString(step) + " is not in startup.sequence, which is '" +
                       settings_.sequence + "'");
  return *entry;
}

bool Startup::isSatisfiedAt(StartupStep step) const {
  const Entry* const entry = find(step);
  return entry == nullptr || isSatisfied(entry->status);
}

const Prerequisite* Startup::firstUnmet(const Entry& entry) const {
  const auto found = std::find_if(entry.after.begin(), entry.after.end(),
                                  [&](const Prerequisite& before) { return !isSatisfiedAt(before.step); });
  return found == entry.after.end() ? nullptr : &*found;
}

std::string Startup::reasonOf(const Entry& entry) const {
  if (entry.status.state != StartupState::Pending) return entry.status.reason;
  const std::string so_far = entry.status.reason.empty() ? "not done yet" : entry.status.reason;
  if (const Prerequisite* const before = firstUnmet(entry))
    return so_far + "; waits for " + toString(before->step) + ": " + before->because;
  if (entry.status.step == StartupStep::TransferProgram)
    return so_far + "; to be confirmed with the program's length and checksum";
  return so_far +
         (isDoneByHand(entry.status.step, settings_) ? "; to be confirmed by the operator" : "; to be run");
}

std::vector<StartupStatus> Startup::steps() const {
  std::vector<StartupStatus> steps;
  for (const Entry& entry : entries_) {
    steps.push_back(entry.status);
    steps.back().reason = reasonOf(entry);
  }
  return steps;
}

bool Startup::awaits(StartupStep step) const {
  const Entry* const entry = find(step);
  return entry != nullptr && entry->status.state != StartupState::Skipped;
}

bool Startup::hasMachineAtWork() const {
  return std::any_of(entries_.begin(), entries_.end(), [this](const Entry& entry) {
    const StartupState state = entry.status.state;
    const bool concerns =
        !isDoneByHand(entry.status.step, settings_) || isReported(entry.status.step, settings_);
    return concerns && (state == StartupState::Running || state == StartupState::Done);
  });
}

bool Startup::isReady() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return isSatisfied(entry.status); });
}

void Startup::requireReady() const {
  for (const Entry& entry : entries_)
    if (!isSatisfied(entry.status))
      throw Rejected(std::string("the machine is not started up: ") + toString(entry.status.step) + " is " +
                     toString(entry.status.state) + ": " + reasonOf(entry));
}

void Startup::requireReadyFor(const ProgramIdentity& program) const {
  requireReady();
  const Entry* const transfer = find(StartupStep::TransferProgram);
  if (transfer == nullptr || transfer->status.state == StartupState::Skipped || program == program_) return;
  if (program.name == program_.name)
    throw Rejected("the machine is not started up: transfer_program: " + program.name +
                   " was changed after it was transferred");
  throw Rejected("the machine is not started up: transfer_program: " + program_.name +
                 " was transferred; the job asks for " + program.name);
}

StartupState Startup::stateOf(StartupStep step) const {
  const Entry* const entry = find(step);
  return entry == nullptr ? StartupState::Skipped : entry->status.state;
}

std::optional<StartupStep> Startup::nextAutomatic() const {
  for (const Entry& entry : entries_) {
    const bool is_open =
        entry.status.state == StartupState::Pending || entry.status.state == StartupState::Failed;
    if (is_open && firstUnmet(entry) == nullptr && !isDoneByHand(entry.status.step, settings_))
      return entry.status.step;
  }
  return std::nullopt;
}

void Startup::requireMayBegin(const Entry& entry) const {
  const std::string name = toString(entry.status.step);
  if (entry.status.state == StartupState::Running)
    throw Rejected(name + " is running: " + entry.status.reason);
  if (entry.status.state == StartupState::Skipped) throw Rejected(name + " is " + entry.status.reason);
  if (const Prerequisite* const before = firstUnmet(entry))
    throw Rejected(name + " must wait for " + toString(before->step) + ": " + before->because);
  if (entry.status.state != StartupState::Done) return;
  for (const Entry& later : entries_)
    for (const Prerequisite& before : later.after)
      if (before.step == entry.status.step && before.on_loss == OnLoss::Spreads &&
          (later.status.state == StartupState::Running || later.status.state == StartupState::Done))
        throw Rejected(name + " is done, and " + toString(later.status.step) +
                       " after it; expected that to be " + "lost first");
}

/// The step is Running from now on.
void Startup::enter(StartupStep step, double now_s) {
  Entry& entry = *find(step);
  StartupStatus status;
  status.step = step;
  status.state = StartupState::Running;
  status.reason = "running";
  entry.status = status;
  entry.since_s = now_s;
  entry.phase = 0;
  if (step == StartupStep::HeatBed) reports_.watchBed();
  if (step == StartupStep::MapHeights) reports_.forgetHeights();
  if (step == StartupStep::DrawVacuum) reports_.forgetZones();
  if (homedAxis(step)) reports_.forgetHomed();
  if (step == StartupStep::DryPellets) {
    dried_s_ = 0.0;
    was_dryer_hot_ = settings_.dry_label.empty();
    dryer_looked_at_s_ = now_s;
    reports_.forgetDryer();
  }
  measure(entry);
}

void Startup::begin(StartupStep step, double now_s) {
  const Entry& entry = entryOf(step);
  requireMayBegin(entry);
  if (isDoneByHand(step, settings_))
    throw Rejected(std::string(toString(step)) + " is done by the operator; expected it to be confirmed");
  enter(step, now_s);
}

void Startup::confirm(StartupStep step, double now_s) {
  Entry& entry = entryOf(step);
  requireMayBegin(entry);
  if (step == StartupStep::TransferProgram)
    throw Rejected("transfer_program needs program, bytes and crc32; expected them to be given");
  if (!isDoneByHand(step, settings_))
    throw Rejected(std::string(toString(step)) + " is done by the machine; expected it to be run");
  enter(step, now_s);
  if (step != StartupStep::DryPellets && step != StartupStep::HeatBed)
    complete(entry, "confirmed by the operator", now_s);
}

void Startup::onTransferred(const ProgramIdentity& program, double now_s) {
  Entry& entry = entryOf(StartupStep::TransferProgram);
  requireMayBegin(entry);
  program_ = program;
  entry.status.value = static_cast<double>(program.bytes);
  entry.status.unit = "bytes";
  complete(entry, program.name + " came whole: " + std::to_string(program.bytes) + " bytes", now_s);
}

void Startup::complete(Entry& entry, const std::string& reason, double now_s) {
  entry.status.state = StartupState::Done;
  entry.status.reason = reason;
  entry.since_s = now_s;
}

void Startup::fail(StartupStep step, const std::string& why) {
  Entry* const entry = find(step);
  if (entry == nullptr || entry->status.state != StartupState::Running) return;
  entry->status.state = StartupState::Failed;
  entry->status.reason = why;
}

void Startup::addRemark(StartupStep step, const std::string& remark) {
  if (stateOf(step) == StartupState::Failed) find(step)->status.reason += remark;
}

void Startup::giveUp(StartupStep step, const std::string& why) {
  // A dryer that the operator has switched on goes on drying.
  const bool goes_on = step == StartupStep::DryPellets && isDoneByHand(step, settings_);
  if (stateOf(step) == StartupState::Running && !goes_on) lose(step, why);
}

// What a running step sends, and what is made of the machine's reports.

std::optional<std::string> Startup::nextCode(StartupStep step) {
  Entry* const entry = find(step);
  if (entry == nullptr || entry->status.state != StartupState::Running) return std::nullopt;
  const int phase = entry->phase;
  if (const auto axis = homedAxis(step))
    return withChecks(filled(settings_.home_code, "{axis}", std::string(1, *axis)), settings_);
  switch (step) {
    case StartupStep::DryPellets:
      if (phase > 0 || settings_.dry_code.empty()) return std::nullopt;
      return withChecks(filled(settings_.dry_code, "{target_c}", shortNumber(settings_.dry_target_c)),
                        settings_);
    case StartupStep::HeatBed:
      if (!reports_.bed()) {
        entry->phase = -1;
        return withChecks("M105\n" + dwell(1.0), settings_);
      }
      if (phase == 0 && !settings_.bed_code.empty())
        return withChecks(bedRamp(settings_, *reports_.bed()), settings_);
      return withChecks(dwell(kBedPoll) + "M105", settings_);
    case StartupStep::DrawVacuum:
      if (phase == 0) return withChecks(vacuumOn(settings_) + dwell(settings_.vacuum_evacuate_s), settings_);
      return withChecks(dwell(settings_.vacuum_hold_s), settings_);
    case StartupStep::MapHeights:
      return withChecks(settings_.map_code, settings_);
    default:
      return std::nullopt;
  }
}

void Startup::onCodeFinished(StartupStep step, double now_s) {
  Entry* const entry = find(step);
  if (entry == nullptr || entry->status.state != StartupState::Running) return;
  ++entry->phase;
  if (const auto axis = homedAxis(step)) {
    const StartupCheck check = checkHomed(*axis, reports_);
    if (!settings_.home_label.empty() && check.verdict != Verdict::Met) return fail(step, check.reason);
    complete(*entry, std::string("the machine has homed ") + *axis, now_s);
  } else if (step == StartupStep::HeatBed) {
    finishBed(*entry, now_s);
  } else if (step == StartupStep::DrawVacuum) {
    finishVacuum(*entry, now_s);
  } else if (step == StartupStep::MapHeights) {
    const StartupCheck check = checkHeights(reports_, settings_);
    if (check.verdict != Verdict::Met) return fail(step, check.reason);
    complete(*entry, check.reason, now_s);
  }
}

void Startup::finishBed(Entry& entry, double now_s) {
  const StartupCheck check = checkBed(reports_, settings_, Strictness::Reaching);
  // A board that was reset leaves a hot bed without a target: it would cool during the job.
  const bool is_commanded = settings_.bed_code.empty() || entry.phase > 0;
  if (is_commanded && check.verdict == Verdict::Met) return complete(entry, check.reason, now_s);
  const double passed_min = (now_s - entry.since_s) / 60.0;
  if (passed_min > settings_.bed_timeout_min)
    fail(entry.status.step, check.reason + " within " + shortNumber(settings_.bed_timeout_min) + " min");
}

/// The pressure must be reached, and be held.
void Startup::finishVacuum(Entry& entry, double now_s) {
  const StartupCheck check = checkVacuum(reports_, settings_);
  if (check.verdict != Verdict::Met) return fail(entry.status.step, check.reason);
  if (entry.phase < 2) {
    reports_.forgetZones();
    return;
  }
  complete(entry, check.reason + ", held for " + shortNumber(settings_.vacuum_hold_s) + " s", now_s);
}

/// Writes what was measured last into the status of a step.
void Startup::measure(Entry& entry) {
  StartupCheck check;
  switch (entry.status.step) {
    case StartupStep::DryPellets:
      check = checkDrying(dried_s_, settings_);
      break;
    case StartupStep::HeatBed:
      check = checkBed(reports_, settings_, Strictness::Reaching);
      break;
    case StartupStep::DrawVacuum:
      if (settings_.vacuum_label.empty()) return;
      check = checkVacuum(reports_, settings_);
      break;
    case StartupStep::MapHeights:
      check = checkHeights(reports_, settings_);
      break;
    default:
      return;
  }
  entry.status.value = check.value;
  entry.status.unit = check.unit;
  entry.status.expected = check.expected;
  if (entry.status.state == StartupState::Running) entry.status.reason = check.reason;
}

void Startup::onReply(const FirmwareReply& reply, double now_s) {
  reports_.read(reply, now_s);
  for (Entry& entry : entries_) {
    if (entry.status.state == StartupState::Running || entry.status.state == StartupState::Done) {
      measure(entry);
      watch(entry);
    }
  }
  if (reply.kind == ReplyKind::Start) forgetMachine("the machine was reset");
  if (reply.kind == ReplyKind::Fatal) halt("the machine halted: \"" + reply.text + "\"");
  if (asksForHoming(reply.text)) loseHoming("XYZ", "the machine says \"" + reply.text + "\"");
  elapse(now_s);
}

void Startup::halt(const std::string& why) {
  for (const Entry& entry : entries_)
    if (!isDoneByHand(entry.status.step, settings_)) fail(entry.status.step, why);
  forgetMachine(why);
}

/// Fails a step that runs out of its bounds, loses one that no longer holds.
void Startup::watch(Entry& entry) {
  const StartupStep step = entry.status.step;
  const bool is_done = entry.status.state == StartupState::Done;
  if (step == StartupStep::HeatBed && !is_done) {
    const StartupCheck rate = checkBedRate(reports_, settings_);
    if (rate.verdict == Verdict::NotMet) fail(step, rate.reason);
  }
  if (!is_done) return;
  StartupCheck check;
  if (step == StartupStep::HeatBed) check = checkBed(reports_, settings_, Strictness::Keeping);
  if (step == StartupStep::DrawVacuum && !settings_.vacuum_label.empty())
    check = checkVacuum(reports_, settings_);
  if (homedAxis(step) && !settings_.home_label.empty()) check = checkHomed(*homedAxis(step), reports_);
  if (check.verdict == Verdict::NotMet) lose(step, check.reason);
}

// How steps that were done are lost: by commands, by the machine, by time.

/// The step is Pending again, and with it what rests on it.
/// @param cause  of the first loss
void Startup::loseWith(StartupStep step, const std::string& reason, const std::string& cause) {
  Entry* const entry = find(step);
  if (entry == nullptr) return;
  const StartupState before = entry->status.state;
  if (before != StartupState::Running && before != StartupState::Done) return;
  entry->status.state = StartupState::Pending;
  entry->status.reason = reason;
  for (const Entry& later : entries_)
    for (const Prerequisite& needed : later.after)
      if (needed.step == step && needed.on_loss == OnLoss::Spreads)
        loseWith(later.status.step, std::string(toString(step)) + " was lost: " + cause, cause);
}

void Startup::lose(StartupStep step, const std::string& why) { loseWith(step, why, why); }

void Startup::loseHoming(const std::string& axes, const std::string& why) {
  for (const StartupStep step :
       {StartupStep::HomeX, StartupStep::HomeY, StartupStep::HomeZ, StartupStep::HomeZAgain})
    if (axes.find(*homedAxis(step)) != std::string::npos) lose(step, why);
}

void Startup::onCommandSent(const std::string& command) {
  const std::string code = codeOf(command);
  if (code == "M84" || code == "M18") {
    loseHoming(axesOf(command), command + " has switched the motors off");
  } else if (code == "M410") {
    loseHoming("XYZ", "M410 has stopped the motors without a ramp");
  } else if (code == "M112") {
    forgetMachine("M112 has stopped the machine in an emergency");
  } else if (code == "M140" || code == "M190") {
    const auto target_c = bedTargetIn(command);
    const bool is_other =
        target_c && std::abs(*target_c - settings_.bed_target_c) > settings_.bed_tolerance_c;
    const Entry* const bed = find(StartupStep::HeatBed);
    if (is_other && bed != nullptr && bed->status.state == StartupState::Done)
      lose(StartupStep::HeatBed,
           command + " has set another target than " + shortNumber(settings_.bed_target_c) + " degC");
  }
  if (std::find(vacuum_off_.begin(), vacuum_off_.end(), command) != vacuum_off_.end())
    lose(StartupStep::DrawVacuum, command + " has closed a zone");
}

void Startup::forgetMachine(const std::string& why) {
  for (const StartupStep step :
       {StartupStep::PowerOn, StartupStep::HeatBed, StartupStep::DrawVacuum, StartupStep::MapHeights})
    lose(step, why);
  loseHoming("XYZ", why);
  reports_ = MachineReports(settings_);
}

void Startup::elapse(double now_s) {
  if (Entry* const drying = find(StartupStep::DryPellets)) advanceDrying(*drying, now_s);
  expire(now_s);
}

/// Counts time between two looks at which the dryer was hot; of a dryer that reports nothing, all time.
void Startup::advanceDrying(Entry& entry, double now_s) {
  const bool is_running = entry.status.state == StartupState::Running;
  if (!is_running && entry.status.state != StartupState::Done) return;
  const bool is_reported = isReported(StartupStep::DryPellets, settings_);
  const bool is_hot = !is_reported || checkDryer(reports_, settings_).verdict == Verdict::Met;
  const double reported_s = !is_reported       ? now_s
                            : reports_.dryer() ? reports_.dryer()->time_s
                                               : dryer_looked_at_s_;
  if (is_hot && was_dryer_hot_ && is_running) dried_s_ += reported_s - dryer_looked_at_s_;
  if (is_hot && (is_reported || is_running)) last_dry_s_ = reported_s;
  was_dryer_hot_ = is_hot;
  dryer_looked_at_s_ = reported_s;
  if (!is_running) return;
  measure(entry);
  const StartupCheck check = checkDrying(dried_s_, settings_);
  if (check.verdict == Verdict::Met)
    complete(entry, check.reason, now_s);
  else if (!is_hot)
    entry.status.reason += "; " + checkDryer(reports_, settings_).reason;
}

void Startup::expire(double now_s) {
  const auto hoursPast = [&](double since_s) { return (now_s - since_s) / 3600.0; };
  const Entry* const drying = find(StartupStep::DryPellets);
  if (drying != nullptr && drying->status.state == StartupState::Done &&
      hoursPast(last_dry_s_) > settings_.dry_valid_h)
    lose(StartupStep::DryPellets, "the pellets were dry " + shortNumber(hoursPast(last_dry_s_)) +
                                      " h ago; expected at most " + shortNumber(settings_.dry_valid_h) +
                                      " h");
  const Entry* const map = find(StartupStep::MapHeights);
  if (map != nullptr && map->status.state == StartupState::Done &&
      hoursPast(map->since_s) > settings_.map_valid_h)
    lose(StartupStep::MapHeights, "the height map is " + shortNumber(hoursPast(map->since_s)) +
                                      " h old; expected at most " + shortNumber(settings_.map_valid_h) +
                                      " h");
}

}  // namespace lamina
