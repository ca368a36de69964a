// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The safe stop, and what is left where it is not heard.
#include <algorithm>

#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

namespace lamina {
namespace {

constexpr const char* kStandstill = "M400";
constexpr const char* kTargets = "M105";

std::string wholeSecondsOf(double value) { return std::to_string(static_cast<int>(value)) + " s"; }

std::string offerOf(const std::string& emergency) {
  return "; an emergency stop, by which it loses its position, is heard at once: " + emergency +
         " at the port, or stream.emergency_stop unconfirmed";
}

}  // namespace

void OkPacedJob::abort(const Failure& why, double now) {
  if (isStopping() || isFinal(record_.status.state)) return;
  record_.status.failure = why;
  record_.enter(PackmlState::Aborting);
  if (!has_begun_) return finishAborted("");
  prepareStop(now);
  beginPhase(Phase::Stopping, now);
  sendStop(now);
}

void OkPacedJob::prepareStop(double now) {
  stop_began_ = now;
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  safe_stop_latest_ = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
  stage_ = settings_.keep_heaters_on ? StopStage::Rest : StopStage::SwitchOff;
  stops_sent_ = 0;
  under_way_.clear();
}

/// The firmware has no command that ends motions without losing the position: it runs what it has taken.
void OkPacedJob::sendStop(double now) {
  ++stops_sent_;
  timer_.asked(now);
  are_heaters_off_.reset();
  for (const std::string& command : outputs_.beamOff()) send(command, {});
  for (const std::string& command : outputs_.airOff()) send(command, {});
  if (stage_ == StopStage::SwitchOff) {
    for (const std::string& command : firmware_->switchOff(temperatures_)) send(command, {});
    send(kTargets, {});
  } else {
    send(kStandstill, {});
  }
  ask();
}

/// Klipper that waits for heat keeps what it is sent, and with twenty commands it reads no more: then it
/// would not hear an emergency stop either.
void OkPacedJob::repeatStop(double now) {
  constexpr int kMostStops = 4;
  if (stage_ == StopStage::Reason) return;
  if (firmware_->emergencyStop().empty() || stops_sent_ < kMostStops) sendStop(now);
}

/// A machine that reports while it waits for heat hears the stop once the heat is there.
void OkPacedJob::prolongStop(double now) {
  const std::string emergency = firmware_->emergencyStop();
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed && !emergency.empty()) return;
  const double by = std::min(now + settings_.safe_stop_timeout_s, safe_stop_latest_);
  const bool is_late = now >= stop_began_ + settings_.safe_stop_timeout_s;
  if (is_late && !emergency.empty() && stage_ == StopStage::SwitchOff)
    record_.status.message = "the machine has not heard the stop for " +
                             wholeSecondsOf(settings_.safe_stop_timeout_s) + ", and reports that it lives" +
                             offerOf(emergency);
  safe_stop_by_ = std::max(safe_stop_by_, by);
}

void OkPacedJob::onStopTimeout(double now) {
  if (phase_ == Phase::Offline)
    return finishAborted(
        "; the link did not come back, so that the machine was not told to stop: look after it");
  if (stage_ == StopStage::Reason)
    return finishAborted("; " + firmware_->afterHalt() +
                         (is_emergency_ ? "; an emergency stop was sent" : ""));
  const std::string emergency = firmware_->emergencyStop();
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed && !emergency.empty() && !is_emergency_) {
    is_emergency_ = true;
    safe_stop_by_ = now + settings_.safe_stop_timeout_s;
    record_.status.failure.message += "; the safe stop was not confirmed within " +
                                      wholeSecondsOf(settings_.safe_stop_timeout_s) +
                                      ", so that an emergency stop was sent";
    output_ += emergency + "\n";
    return;
  }
  const std::string offer = emergency.empty() || is_emergency_ ? "" : offerOf(emergency);
  if (stage_ == StopStage::SwitchOff) {
    finishAborted("; the machine did not confirm the safe stop" + offer);
  } else {
    finishAborted("; its heaters are off, but it did not confirm that its motions have ended");
  }
}

void OkPacedJob::onStopAnswer(double now) {
  if (stage_ == StopStage::Rest) return finishAborted("");
  if (are_heaters_off_ != true) return;
  stage_ = StopStage::Rest;
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  timer_.restart(now);
  sendStop(now);
}

/// A machine whose link is lost goes on heating: it is asked to stop as soon as it can be reached again.
void OkPacedJob::disconnect(const std::string& why, double now) {
  if (isFinal(record_.status.state) || phase_ == Phase::Offline) return;
  if (!isStopping()) {
    record_.status.failure = {ErrorCode::Disconnected, why + record_.whereItStands()};
    record_.enter(PackmlState::Aborting);
    if (!has_begun_) return finishAborted("");
    prepareStop(now);
  }
  replies_.clear();
  output_.clear();
  phase_ = Phase::Offline;
}

void OkPacedJob::reconnect(double now) {
  if (phase_ != Phase::Offline) return;
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  beginPhase(Phase::Stopping, now);
  sendStop(now);
}

void OkPacedJob::finishAborted(const std::string& remark) {
  record_.status.failure.message += remark;
  phase_ = Phase::Idle;
  under_way_.clear();
  record_.enter(PackmlState::Aborted);
}

}  // namespace lamina
