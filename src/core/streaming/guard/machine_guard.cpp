// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_guard.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::string nameOf(int process, const MachinePulse& pulse) {
  return "process " + std::to_string(process) + " at " + pulse.port.name;
}

}  // namespace

void MachineGuard::hear(const MachinePulse& pulse, int process, double now_s) {
  streamers_[process] = Streamer{pulse, process, now_s};
  if (!left_ || is_stopping_) return;
  if (process == left_->process || (pulse.is_at_work && pulse.has_job))
    takeUp(pulse, process);
  else
    watchAgain(pulse, process, now_s);
}

void MachineGuard::takeUp(const MachinePulse& pulse, int process) {
  const bool is_touched = left_->is_touched;
  const bool is_told = left_->is_watched_again;
  left_.reset();
  const std::string name = nameOf(process, pulse);
  if (is_touched && pulse.is_at_work)
    news_.push_back({GuardNewsKind::Stopped, "the stop had begun when " + name + " came back"});
  else if (!is_told)
    news_.push_back({GuardNewsKind::Back, name});
}

void MachineGuard::watchAgain(const MachinePulse& pulse, int process, double now_s) {
  const bool is_news = !std::exchange(left_->is_watched_again, true);
  if (!is_news && !pulse.is_at_work) return;
  left_->hung_process = 0;
  left_->due_s = settings_.unattended_s > 0.0 ? now_s + settings_.unattended_s : kNever;
  if (!is_news) return;
  left_->is_failure_told = false;
  news_.push_back({GuardNewsKind::Back, nameOf(process, pulse) + ", which leaves the machine as it is"});
}

void MachineGuard::end(int process, double now_s) {
  if (left_ && left_->process == process) left_->process = 0;
  // The system may give its number to another.
  if (left_ && left_->hung_process == process) left_->hung_process = 0;
  const auto ended = streamers_.extract(process);
  if (!ended.empty()) lose(ended.mapped(), 0, "has ended while it was at work", now_s);
}

void MachineGuard::lose(const Streamer& streamer, int hung_process, const std::string& how, double now_s) {
  const double due_s = streamer.pulse.firmware == kFollowsTrajectories ? now_s : now_s + settings_.grace_s;
  const bool is_at_work = streamer.pulse.is_at_work;
  if (is_at_work && !left_) {
    left_ = Left{streamer.pulse, hung_process, hung_process, due_s, false, false, false};
  } else if (is_at_work && !is_stopping_) {
    left_->process = left_->hung_process = hung_process;
    left_->due_s = due_s;
    left_->is_watched_again = false;
  } else if (left_ && std::exchange(left_->is_watched_again, false)) {
    left_->hung_process = hung_process;
    left_->due_s = std::min(left_->due_s, due_s);
  } else if (!is_at_work) {
    return;
  }
  news_.push_back({GuardNewsKind::Lost, nameOf(streamer.process, streamer.pulse) + ' ' + how});
}

std::optional<GuardOrder> MachineGuard::due(double now_s) {
  for (auto each = streamers_.begin(); each != streamers_.end();) {
    if (now_s < each->second.heard_s + settings_.silence_s) {
      ++each;
      continue;
    }
    lose(each->second, each->first, "has said nothing for more than " + nearestTenths(settings_.silence_s),
         now_s);
    each = streamers_.erase(each);
  }
  if (!left_ || is_stopping_ || now_s < left_->due_s) return std::nullopt;
  return order();
}

std::optional<GuardOrder> MachineGuard::dueAtEnd() {
  if (!left_ || is_stopping_) return std::nullopt;
  return order();
}

std::optional<GuardOrder> MachineGuard::order() {
  is_stopping_ = true;
  return GuardOrder{left_->machine, left_->hung_process};
}

void MachineGuard::onStop(const MachineStopReport& report, double now_s) {
  is_stopping_ = false;
  if (!left_) return;
  left_->hung_process = 0;
  if (report.is_confirmed) {
    left_.reset();
    news_.push_back({GuardNewsKind::Stopped, report.message});
    return;
  }
  left_->is_touched = left_->is_touched || report.has_begun;
  left_->due_s = now_s + settings_.retry_s;
  if (!std::exchange(left_->is_failure_told, true))
    news_.push_back({GuardNewsKind::NotStopped, report.message});
}

double MachineGuard::nextDeadline() const {
  double next_s = left_ && !is_stopping_ ? left_->due_s : kNever;
  for (const auto& [process, streamer] : streamers_)
    next_s = std::min(next_s, streamer.heard_s + settings_.silence_s);
  return next_s;
}

std::vector<GuardNews> MachineGuard::takeNews() { return std::exchange(news_, {}); }

}  // namespace lamina
