// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/job_watch.hpp"

#include <algorithm>
#include <cmath>

#include "startup/startup_checks.hpp"
#include "startup/startup_code.hpp"

namespace lamina {
namespace {

constexpr double kSameTarget = 0.6;  // degC: firmware may round
constexpr double kColdFor = 5.0;     // s: one report alone may be noise

bool isSame(double target_c, double other_c) { return std::abs(target_c - other_c) <= kSameTarget; }

}  // namespace

JobWatch::JobWatch(const StartupSettings& settings, WatchedLines lines)
    : settings_(settings),
      reports_(settings),
      vacuum_off_(vacuumOffCommands(settings)),
      is_opaque_(lines == WatchedLines::MayBeReplaced),
      target_c_(settings.bed_target_c) {
  for (const SequencedStep& entry : makeStartupSequence(settings)) {
    if (entry.is_skipped) continue;
    watches_bed_ = watches_bed_ || entry.step == StartupStep::HeatBed;
    if (is_opaque_) continue;
    watches_vacuum_ =
        watches_vacuum_ || (entry.step == StartupStep::DrawVacuum && !settings.vacuum_label.empty());
    const auto axis = homedAxis(entry.step);
    if (axis && axes_.find(*axis) == std::string::npos) axes_ += *axis;
  }
}

void JobWatch::onSent(const std::string& command) {
  const std::string code = codeOf(command);
  if (code == "M140" || code == "M190") {
    const auto target_c = bedTargetIn(command);
    if (target_c) {
      asked_c_.push_back(*target_c);
      // The report of a target may come before the word that its line was sent.
      if (foreign_ && isSame(*target_c, foreign_->target_c)) foreign_.reset();
    }
  } else if (code == "M84" || code == "M18" || code == "M410") {
    release(code == "M410" ? "M410" : command);
  } else if (code == "G28") {
    unhomed_.clear();
    reports_.forgetHomed();
  } else if (code.empty() || std::string("GMTNF").find(code.front()) == std::string::npos ||
             code.find('_') != std::string::npos || code == "M98") {
    is_opaque_ = true;
  }
  if (std::find(vacuum_off_.begin(), vacuum_off_.end(), command) != vacuum_off_.end())
    watches_vacuum_ = false;
}

void JobWatch::release(const std::string& command) {
  for (const char axis : axesOf(command))
    axes_.erase(std::remove(axes_.begin(), axes_.end(), axis), axes_.end());
}

void JobWatch::onReply(const FirmwareReply& reply, double now_s) {
  reports_.read(reply, now_s);
  if (asksForHoming(reply.text)) {
    unhomed_ = reply.text;
    reports_.forgetHomed();  // what was reported before is refuted
  }
  const auto& homed = reports_.homed();
  const bool is_homed = homed && std::all_of(axes_.begin(), axes_.end(), [&](char axis) {
                          return homed->find(axis) != std::string::npos;
                        });
  if (is_homed) unhomed_.clear();
  if (!watches_bed_ || !reply.temperatures || !reply.temperatures->bed_c) return;
  followTarget(*reply.temperatures, now_s);
  followBed(*reply.temperatures->bed_c, now_s);
}

/// Of firmware that reports no target, the one that was sent last counts.
void JobWatch::followTarget(const ReportedTemperatures& temperatures, double now_s) {
  const double reported_c =
      temperatures.bed_target_c.value_or(asked_c_.empty() ? target_c_ : asked_c_.back());
  if (isSame(reported_c, target_c_)) {
    foreign_.reset();
    return;
  }
  const auto asked = std::find_if(asked_c_.begin(), asked_c_.end(),
                                  [&](double target_c) { return isSame(target_c, reported_c); });
  if (asked == asked_c_.end() && !is_opaque_) {
    if (!foreign_ || !isSame(foreign_->target_c, reported_c)) foreign_ = ForeignTarget{reported_c, now_s};
    foreign_->is_believed = now_s - foreign_->since_s >= kColdFor;
    return;
  }
  foreign_.reset();
  if (asked != asked_c_.end()) asked_c_.erase(asked_c_.begin(), asked + 1);
  target_c_ = reported_c;
  target_since_s_ = now_s;
  is_reached_ = false;
}

void JobWatch::followBed(double bed_c, double now_s) {
  bed_c_ = bed_c;
  const double band_c = 2.0 * settings_.bed_tolerance_c;
  is_reached_ = is_reached_ || std::abs(bed_c - target_c_) <= band_c;
  const bool is_below = target_c_ > 0.0 && bed_c < target_c_ - band_c;
  if (!is_below || !is_reached_)
    cold_since_s_.reset();
  else if (!cold_since_s_)
    cold_since_s_ = now_s;
  is_cold_ = cold_since_s_ && now_s - *cold_since_s_ >= kColdFor;
  is_late_ = is_below && !is_reached_ && now_s - target_since_s_ > settings_.bed_timeout_min * 60.0;
}

std::optional<JobLoss> JobWatch::bedLoss() const {
  if (foreign_ && foreign_->is_believed)
    return JobLoss{KeptCondition::Bed,
                   "the bed's target is " + shortNumber(foreign_->target_c) +
                       " degC, which the program has not set; expected " + shortNumber(target_c_) + " degC",
                   bed_c_};
  const std::string found = "the bed is at " + shortNumber(bed_c_) + " degC; expected at least " +
                            shortNumber(target_c_ - 2.0 * settings_.bed_tolerance_c) + " degC";
  if (is_cold_) return JobLoss{KeptCondition::Bed, found, bed_c_};
  if (is_late_)
    return JobLoss{KeptCondition::Bed,
                   found + " within " + shortNumber(settings_.bed_timeout_min) + " min of its target",
                   bed_c_};
  return std::nullopt;
}

std::optional<JobLoss> JobWatch::vacuumLoss() const {
  if (!watches_vacuum_) return std::nullopt;
  const StartupCheck check = checkVacuum(reports_, settings_);
  if (check.verdict != Verdict::NotMet) return std::nullopt;
  return JobLoss{KeptCondition::Vacuum, check.reason, check.value.value_or(0.0)};
}

std::optional<JobLoss> JobWatch::homingLoss() const {
  if (!axes_.empty() && !unhomed_.empty())
    return JobLoss{KeptCondition::Homing,
                   "the machine says \"" + unhomed_ + "\"; expected its axes to be homed", 0.0};
  for (const char axis : axes_) {
    const StartupCheck check = checkHomed(axis, reports_);
    if (check.verdict == Verdict::NotMet) return JobLoss{KeptCondition::Homing, check.reason, 0.0};
  }
  return std::nullopt;
}

std::vector<JobLoss> JobWatch::losses() const {
  std::vector<JobLoss> found;
  for (const auto& loss : {bedLoss(), vacuumLoss(), homingLoss()})
    if (loss) found.push_back(*loss);
  return found;
}

}  // namespace lamina
