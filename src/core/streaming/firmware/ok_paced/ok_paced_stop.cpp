// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The safe stop, and what is left where it is not heard.
#include <algorithm>

#include "base/duration_text.hpp"
#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

namespace lamina {
namespace {

constexpr const char* kStandstill = "M400";
constexpr const char* kTargets = "M105";

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
  stop_ = {};
  stop_.stage = settings_.keep_heaters_on ? StopStage::Rest : StopStage::SwitchOff;
  stop_.began_s = now;
  stop_.give_up_s = now + settings_.safe_stop_timeout_s;
  stop_.latest_s = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
  under_way_.clear();
}

/// The firmware has no command that ends motions without losing the position: it runs what it has taken.
std::vector<std::string> OkPacedJob::stopCommands() const {
  std::vector<std::string> commands = outputs_.beamOff();
  const auto add = [&commands](const std::vector<std::string>& more) {
    commands.insert(commands.end(), more.begin(), more.end());
  };
  add(outputs_.airOff());
  if (stop_.stage == StopStage::SwitchOff) add(firmware_->switchOff(temperatures_));
  commands.emplace_back(stop_.stage == StopStage::SwitchOff ? kTargets : kStandstill);
  return commands;
}

void OkPacedJob::sendStop(double now) {
  timer_.asked(now);
  stop_.are_heaters_off.reset();
  for (const std::string& command : stopCommands()) send(command, {});
  ask();
}

/// Klipper that waits for heat keeps what it is sent, and with too much of it would not hear an emergency
/// stop either.
void OkPacedJob::repeatStop(double now) {
  if (stop_.stage == StopStage::Reason) return;
  if (hasRoomFor(stopCommands().size() + 1)) sendStop(now);
}

/// A machine that reports while it waits for heat hears the stop once the heat is there.
void OkPacedJob::prolongStop(double now) {
  const std::string emergency = stop_.stage == StopStage::SwitchOff ? firmware_->emergencyStop() : "";
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed && !emergency.empty()) return;
  const double by = std::min(now + settings_.safe_stop_timeout_s, stop_.latest_s);
  const bool is_late = now >= stop_.began_s + settings_.safe_stop_timeout_s;
  if (is_late && !emergency.empty())
    record_.status.message = "the machine has not heard the stop for " +
                             wholeSeconds(settings_.safe_stop_timeout_s) + ", and reports that it lives" +
                             offerOf(emergency);
  stop_.give_up_s = std::max(stop_.give_up_s, by);
}

void OkPacedJob::onStopTimeout(double now) {
  if (phase_ == Phase::Offline)
    return finishAborted(
        "; the link did not come back, so that the machine was not commanded to stop: look after it");
  if (stop_.stage == StopStage::Reason) return finishAborted("; " + firmware_->afterHalt());
  if (stop_.stage == StopStage::Rest)
    return finishAborted(settings_.keep_heaters_on
                             ? "; the machine did not confirm that its motions have ended"
                             : "; its heaters are off, but it did not confirm that its motions have ended");
  const std::string emergency = stop_.is_emergency ? "" : firmware_->emergencyStop();
  if (emergency.empty()) return finishAborted("; the machine did not confirm the safe stop");
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed) return stopAtOnce(emergency, now);
  finishAborted("; the machine did not confirm the safe stop" + offerOf(emergency));
}

void OkPacedJob::stopAtOnce(const std::string& emergency, double now) {
  stop_.is_emergency = true;
  stop_.give_up_s = now + settings_.safe_stop_timeout_s;
  record_.status.failure.message += "; the safe stop was not confirmed within " +
                                    wholeSeconds(settings_.safe_stop_timeout_s) +
                                    ", so that an emergency stop was sent";
  output_ += emergency + "\n";
}

void OkPacedJob::onStopAnswer(double now) {
  if (stop_.stage == StopStage::Rest) return finishAborted("");
  if (stop_.are_heaters_off != true) return;
  stop_.stage = StopStage::Rest;
  stop_.give_up_s = now + settings_.safe_stop_timeout_s;
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
  unanswered_.forget();
  stop_.began_s = now;
  stop_.give_up_s = now + settings_.safe_stop_timeout_s;
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
