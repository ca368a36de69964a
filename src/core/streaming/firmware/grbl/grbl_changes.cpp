// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a person changes while a job runs.
#include <algorithm>

#include "streaming/firmware/grbl/grbl_job.hpp"

namespace lamina {
namespace {

constexpr double kStandsStill = 0.05;  // s, between two reports that were asked for apart

/// Whether a line turns the beam or spindle on at a power of its own (M3), whatever the axes do.
bool isConstantPower(const GrblWords& words) {
  constexpr int kOn = 30;
  return std::any_of(words.begin(), words.end(),
                     [](const GrblWord& word) { return word.letter == 'M' && word.tenfold() == kOn; });
}

}  // namespace

/// Overrides are made of bytes that need no room in the buffer.
std::string GrblJob::change(const LiveChange& change, double now) {
  const bool is_running =
      state() == PackmlState::Execute || state() == PackmlState::Holding || state() == PackmlState::Held;
  if (!is_running || !isRunning()) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  std::string refusal = overrides_.set(change, now);
  if (refusal.empty()) poll(now);
  return refusal;
}

void GrblJob::followOverrides(const GrblReport& report, double now) {
  if (report.overrides) overrides_.hear(*report.overrides, now);
  if (!overrides_.isUnderWay()) return;
  output_ += overrides_.takeBytes();
  const std::string remark = overrides_.giveUp(now);
  if (!remark.empty()) record_.status.message = remark;
}

/// In front of the layer at which a person wants to hold: the lines before it are run to their end first.
bool GrblJob::isHeldBack(const ProgramLine& line, double now) {
  if (!is_at_layer_ && layer_pause_.takeIfDueAt(line.layer)) {
    is_at_layer_ = true;
    idle_at_s_ = -1.0;
    next_poll_s_ = now;
    if (line.layer >= 0) record_.status.message = "holds in front of layer " + std::to_string(line.layer);
  }
  return is_at_layer_;
}

/// The hold comes when the last motion has ended, so that it stands between two layers and a laser in laser
/// mode goes off. One Idle may be from before the last line was read.
void GrblJob::holdAtLayer(const GrblReport& report, double now) {
  const bool is_still =
      is_at_layer_ && state() == PackmlState::Execute && window_.empty() && report.state == GrblState::Idle;
  if (!is_still) return;
  if (idle_at_s_ < 0.0) {
    idle_at_s_ = now;
  } else if (now >= idle_at_s_ + kStandsStill) {
    is_at_layer_ = false;
    pause(now);
  }
}

/// A beam of constant power burns on where the lines stop coming, and nobody is there to turn it off.
void GrblJob::warnOfLaser(const ProgramLine& line) {
  if (!start_.machine().is_laser || !record_.status.warning.empty()) return;
  const auto words = GrblWords::of(line.command);
  if (!words || !isConstantPower(*words)) return;
  record_.status.warning = order_.program.name() + " line " + std::to_string(unchecked_->textLine()) + ": " +
                           order_.program.quotation().of(line.command) +
                           " keeps the laser on while the machine stands still, be it that its lines stop "
                           "coming; with M4 it goes off then";
}

}  // namespace lamina
