// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
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

void Startup::transferred(const ProgramIdentity& program, double now_s) {
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

}  // namespace lamina
