// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_guard.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::string inSeconds(double duration_s) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", duration_s);
  return text.data();
}

std::string nameOf(int process, const MachinePulse& pulse) {
  return "process " + std::to_string(process) + " at " + pulse.port.name;
}

}  // namespace

void MachineGuard::hear(const MachinePulse& pulse, int process, double now_s) {
  if (streamer_ && streamer_->process != process) end(streamer_->process, now_s);
  streamer_ = Streamer{pulse, process, now_s};
  if (!left_ || is_stopping_) return;
  if (pulse.is_at_work) {
    if (!left_->is_watched_again) news_.push_back({GuardNewsKind::Back, nameOf(process, pulse)});
    left_.reset();
  } else if (!std::exchange(left_->is_watched_again, true)) {
    left_->hung_process = 0;
    left_->due_s = settings_.unattended_s > 0.0 ? now_s + settings_.unattended_s : kNever;
    news_.push_back({GuardNewsKind::Back, nameOf(process, pulse) + ", which leaves the machine as it is"});
  }
}

void MachineGuard::end(int process, double now_s) {
  if (!streamer_ || streamer_->process != process) return;
  lose(*std::exchange(streamer_, std::nullopt), 0, "has ended while it was at work", now_s);
}

void MachineGuard::lose(const Streamer& streamer, int hung_process, const std::string& how, double now_s) {
  const double due_s = now_s + settings_.grace_s;
  if (streamer.pulse.is_at_work) {
    if (!is_stopping_) left_ = Left{streamer.pulse, hung_process, due_s, false, false};
  } else if (left_ && std::exchange(left_->is_watched_again, false)) {
    left_->hung_process = hung_process;
    left_->due_s = std::min(left_->due_s, due_s);
  } else {
    return;
  }
  news_.push_back({GuardNewsKind::Lost, nameOf(streamer.process, streamer.pulse) + ' ' + how});
}

std::optional<GuardOrder> MachineGuard::due(double now_s) {
  if (streamer_ && now_s >= streamer_->heard_s + settings_.silence_s) {
    const Streamer silent = *std::exchange(streamer_, std::nullopt);
    lose(silent, silent.process, "has said nothing for more than " + inSeconds(settings_.silence_s), now_s);
  }
  if (!left_ || is_stopping_ || now_s < left_->due_s) return std::nullopt;
  is_stopping_ = true;
  return GuardOrder{left_->machine, left_->hung_process};
}

void MachineGuard::onStop(bool is_confirmed, const std::string& message, double now_s) {
  is_stopping_ = false;
  if (!left_) return;
  left_->hung_process = 0;
  if (is_confirmed) {
    left_.reset();
    news_.push_back({GuardNewsKind::Stopped, message});
    return;
  }
  left_->due_s = now_s + settings_.retry_s;
  if (!std::exchange(left_->is_failure_told, true)) news_.push_back({GuardNewsKind::NotStopped, message});
}

double MachineGuard::nextDeadline() const {
  const double silent_s = streamer_ ? streamer_->heard_s + settings_.silence_s : kNever;
  return left_ && !is_stopping_ ? std::min(silent_s, left_->due_s) : silent_s;
}

std::vector<GuardNews> MachineGuard::takeNews() { return std::exchange(news_, {}); }

}  // namespace lamina
