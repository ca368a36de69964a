// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// How steps that were done are lost: by commands, by the machine, by time.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lamina/base/text.hpp"
#include "lamina/startup/startup.hpp"
#include "startup/startup_checks.hpp"
#include "startup/startup_code.hpp"

namespace lamina {
namespace {

using StepState = StartupStep;

std::string codeOf(const std::string& command) { return command.substr(0, command.find(' ')); }

/// The number after a letter that stands after a space.
std::optional<double> wordValue(const std::string& command, char letter) {
  const std::size_t at = command.find(std::string(" ") + letter);
  if (at == std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(command.c_str() + at + 2, &end);
  return end == command.c_str() + at + 2 ? std::nullopt : std::optional<double>(value);
}

/// Axes whose motors a command switches off: those it names, or all.
std::string axesOf(const std::string& command) {
  const std::string words = command.size() > 3 ? command.substr(3) : "";
  std::string axes;
  for (const char axis : {'X', 'Y', 'Z'})
    if (words.find(axis) != std::string::npos) axes += axis;
  if (!axes.empty()) return axes;
  return words.find('E') == std::string::npos ? "XYZ" : "";
}

}  // namespace

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
  for (const StepState step : {StepState::HomeX, StepState::HomeY, StepState::HomeZ, StepState::HomeZAgain})
    if (axes.find(*homedAxis(step)) != std::string::npos) lose(step, why);
}

void Startup::sent(const std::string& command) {
  const std::string code = codeOf(command);
  if (code == "M84" || code == "M18") {
    loseHoming(axesOf(command), command + " has switched the motors off");
  } else if (code == "M410") {
    loseHoming("XYZ", "M410 has stopped the motors without a ramp");
  } else if (code == "M112") {
    losePower("M112 has stopped the machine in an emergency");
  } else if (code == "M140" || code == "M190") {
    const auto target_c = wordValue(command, 'S') ? wordValue(command, 'S') : wordValue(command, 'R');
    const bool is_other =
        target_c && std::abs(*target_c - settings_.bed_target_c) > settings_.bed_tolerance_c;
    const Entry* const bed = find(StepState::HeatBed);
    if (is_other && bed != nullptr && bed->status.state == StartupState::Done)
      lose(StepState::HeatBed,
           command + " has set another target than " + shortNumber(settings_.bed_target_c) + " degC");
  }
  if (std::find(vacuum_off_.begin(), vacuum_off_.end(), command) != vacuum_off_.end())
    lose(StepState::DrawVacuum, command + " has closed a zone");
}

void Startup::losePower(const std::string& why) {
  for (const StepState step :
       {StepState::PowerOn, StepState::HeatBed, StepState::DrawVacuum, StepState::MapHeights})
    lose(step, why);
  loseHoming("XYZ", why);
  reports_ = MachineReports(settings_);
}

void Startup::elapse(double now_s) {
  if (Entry* const drying = find(StepState::DryPellets)) advanceDrying(*drying, now_s);
  expire(now_s);
}

/// Counts time between two looks at which the dryer was hot; of a dryer that reports nothing, all time.
void Startup::advanceDrying(Entry& entry, double now_s) {
  const bool is_running = entry.status.state == StartupState::Running;
  if (!is_running && entry.status.state != StartupState::Done) return;
  const bool tells = isReported(StepState::DryPellets, settings_);
  const bool is_hot = !tells || checkDryer(reports_, settings_).verdict == Verdict::Met;
  const double told_s = !tells ? now_s : reports_.dryer() ? reports_.dryer()->time_s : dryer_looked_at_s_;
  if (is_hot && was_dryer_hot_ && is_running) dried_s_ += told_s - dryer_looked_at_s_;
  if (is_hot && (tells || is_running)) last_dry_s_ = told_s;
  was_dryer_hot_ = is_hot;
  dryer_looked_at_s_ = told_s;
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
  const Entry* const drying = find(StepState::DryPellets);
  if (drying != nullptr && drying->status.state == StartupState::Done &&
      hoursPast(last_dry_s_) > settings_.dry_valid_h)
    lose(StepState::DryPellets, "the pellets were dry " + shortNumber(hoursPast(last_dry_s_)) +
                                    " h ago; expected at most " + shortNumber(settings_.dry_valid_h) + " h");
  const Entry* const map = find(StepState::MapHeights);
  if (map != nullptr && map->status.state == StartupState::Done &&
      hoursPast(map->since_s) > settings_.map_valid_h)
    lose(StepState::MapHeights, "the height map is " + shortNumber(hoursPast(map->since_s)) +
                                    " h old; expected at most " + shortNumber(settings_.map_valid_h) + " h");
}

}  // namespace lamina
