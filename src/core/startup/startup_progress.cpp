// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a running step sends, and what is made of the machine's reports.
#include "lamina/startup/startup.hpp"
#include "startup/startup_checks.hpp"
#include "startup/startup_code.hpp"

namespace lamina {
namespace {

using ProgressStep = StartupStep;

// Between two looks at a bed that is still to become hot [s].
constexpr double kBedPoll = 10.0;

std::string withChecks(const std::string& code, const StartupSettings& settings) {
  return code + "\n" + settings.check_code + "\n";
}

/// Whether firmware refuses to move before homing: Marlin's "echo:Home XYZ First", RepRapFirmware's "Error:
/// G0/G1: insufficient axes homed".
bool asksForHoming(const std::string& text) {
  if (text.find("insufficient axes homed") != std::string::npos) return true;
  return text.compare(0, 10, "echo:Home ") == 0 && text.find("irst") != std::string::npos;
}

}  // namespace

std::optional<std::string> Startup::nextCode(StartupStep step) {
  Entry* const entry = find(step);
  if (entry == nullptr || entry->status.state != StartupState::Running) return std::nullopt;
  const int phase = entry->phase;
  if (const auto axis = homedAxis(step))
    return withChecks(filled(settings_.home_code, "{axis}", std::string(1, *axis)), settings_);
  switch (step) {
    case ProgressStep::DryPellets:
      if (phase > 0 || settings_.dry_code.empty()) return std::nullopt;
      return withChecks(filled(settings_.dry_code, "{target_c}", shortNumber(settings_.dry_target_c)),
                        settings_);
    case ProgressStep::HeatBed:
      if (!reports_.bed()) {
        entry->phase = -1;
        return withChecks("M105\n" + dwell(1.0), settings_);
      }
      if (phase == 0 && !settings_.bed_code.empty())
        return withChecks(bedRamp(settings_, *reports_.bed()), settings_);
      return withChecks(dwell(kBedPoll) + "M105", settings_);
    case ProgressStep::DrawVacuum:
      if (phase == 0) return withChecks(vacuumOn(settings_) + dwell(settings_.vacuum_evacuate_s), settings_);
      return withChecks(dwell(settings_.vacuum_hold_s), settings_);
    case ProgressStep::MapHeights:
      return withChecks(settings_.map_code, settings_);
    default:
      return std::nullopt;
  }
}

void Startup::finished(StartupStep step, double now_s) {
  Entry* const entry = find(step);
  if (entry == nullptr || entry->status.state != StartupState::Running) return;
  ++entry->phase;
  if (const auto axis = homedAxis(step)) {
    const StartupCheck check = checkHomed(*axis, reports_);
    if (!settings_.home_label.empty() && check.verdict != Verdict::Met) return fail(step, check.reason);
    complete(*entry, std::string("the machine has homed ") + *axis, now_s);
  } else if (step == ProgressStep::HeatBed) {
    finishBed(*entry, now_s);
  } else if (step == ProgressStep::DrawVacuum) {
    finishVacuum(*entry, now_s);
  } else if (step == ProgressStep::MapHeights) {
    const StartupCheck check = checkHeights(reports_, settings_);
    if (check.verdict != Verdict::Met) return fail(step, check.reason);
    complete(*entry, check.reason, now_s);
  }
}

void Startup::finishBed(Entry& entry, double now_s) {
  const StartupCheck check = checkBed(reports_, settings_, Strictness::Reaching);
  if (check.verdict == Verdict::Met) return complete(entry, check.reason, now_s);
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
    case ProgressStep::DryPellets:
      check = checkDrying(dried_s_, settings_);
      break;
    case ProgressStep::HeatBed:
      check = checkBed(reports_, settings_, Strictness::Reaching);
      break;
    case ProgressStep::DrawVacuum:
      if (settings_.vacuum_label.empty()) return;
      check = checkVacuum(reports_, settings_);
      break;
    case ProgressStep::MapHeights:
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

void Startup::read(const MarlinReply& reply, double now_s) {
  reports_.read(reply, now_s);
  for (Entry& entry : entries_) {
    if (entry.status.state == StartupState::Running || entry.status.state == StartupState::Done) {
      measure(entry);
      watch(entry);
    }
  }
  if (reply.kind == ReplyKind::Start) losePower("the machine was reset");
  if (reply.kind == ReplyKind::Fatal) halt("the machine halted: \"" + reply.text + "\"");
  if (asksForHoming(reply.text)) loseHoming("XYZ", "the machine says \"" + reply.text + "\"");
  elapse(now_s);
}

void Startup::halt(const std::string& why) {
  for (const Entry& entry : entries_)
    if (!isDoneByHand(entry.status.step, settings_)) fail(entry.status.step, why);
  losePower(why);
}

/// Fails a step that runs out of its bounds, loses one that no longer holds.
void Startup::watch(Entry& entry) {
  const ProgressStep step = entry.status.step;
  const bool is_done = entry.status.state == StartupState::Done;
  if (step == ProgressStep::HeatBed && !is_done) {
    const StartupCheck rate = checkBedRate(reports_, settings_);
    if (rate.verdict == Verdict::NotMet) fail(step, rate.reason);
  }
  if (!is_done) return;
  StartupCheck check;
  if (step == ProgressStep::HeatBed) check = checkBed(reports_, settings_, Strictness::Keeping);
  if (step == ProgressStep::DrawVacuum && !settings_.vacuum_label.empty())
    check = checkVacuum(reports_, settings_);
  if (homedAxis(step) && !settings_.home_label.empty()) check = checkHomed(*homedAxis(step), reports_);
  if (check.verdict == Verdict::NotMet) lose(step, check.reason);
}

}  // namespace lamina
