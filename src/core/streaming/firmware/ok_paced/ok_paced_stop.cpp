// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/ok_paced_stop.hpp"

#include <algorithm>
#include <utility>

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr const char* kStandstill = "M400";
constexpr const char* kTargets = "M105";

std::string offerOf(const std::string& emergency) {
  return "; an emergency stop, by which it loses its position, is heard at once: " + emergency +
         " at the port, or stream.emergency_stop unconfirmed";
}

}  // namespace

OkPacedStop::OkPacedStop(const StreamSettings& settings, std::shared_ptr<const OkPacedFirmware> firmware)
    : settings_(settings), firmware_(std::move(firmware)) {}

void OkPacedStop::begin(double now) {
  stage_ = settings_.keep_heaters_on ? Stage::Rest : Stage::SwitchOff;
  is_emergency_ = false;
  are_heaters_off_.reset();
  beginAgain(now);
  latest_s_ = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
}

void OkPacedStop::beginAgain(double now) {
  began_s_ = now;
  give_up_s_ = now + settings_.safe_stop_timeout_s;
}

bool OkPacedStop::awaitRest(double now) {
  if (are_heaters_off_ != true) return false;
  stage_ = Stage::Rest;
  give_up_s_ = now + settings_.safe_stop_timeout_s;
  return true;
}

std::vector<std::string> OkPacedStop::commands(const UsedOutputs& outputs) const {
  std::vector<std::string> commands = outputs.beamOff();
  const auto add = [&commands](const std::vector<std::string>& more) {
    commands.insert(commands.end(), more.begin(), more.end());
  };
  add(outputs.airOff());
  if (stage_ == Stage::SwitchOff) add(firmware_->switchOff(temperatures_));
  commands.emplace_back(stage_ == Stage::SwitchOff ? kTargets : kStandstill);
  return commands;
}

void OkPacedStop::hear(const PacedReply& reply) {
  if (!reply.are_heaters_off) return;
  are_heaters_off_ = reply.are_heaters_off;
  temperatures_ = reply.reply.text;
}

std::string OkPacedStop::emergencyStop() const {
  return stage_ == Stage::SwitchOff ? firmware_->emergencyStop() : "";
}

std::string OkPacedStop::prolong(double now) {
  const std::string emergency = emergencyStop();
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed && !emergency.empty()) return {};
  give_up_s_ = std::max(give_up_s_, std::min(now + settings_.safe_stop_timeout_s, latest_s_));
  const bool is_late = now >= began_s_ + settings_.safe_stop_timeout_s;
  if (!is_late || emergency.empty()) return {};
  return "the machine has not heard the stop for " + wholeSeconds(settings_.safe_stop_timeout_s) +
         ", and reports that it lives" + offerOf(emergency);
}

std::string OkPacedStop::takeEmergencyStop(double now) {
  const bool is_wanted = settings_.emergency_stop == EmergencyStop::Unconfirmed && !is_emergency_;
  std::string emergency = is_wanted ? emergencyStop() : "";
  if (emergency.empty()) return {};
  is_emergency_ = true;
  give_up_s_ = now + settings_.safe_stop_timeout_s;
  return emergency;
}

std::string OkPacedStop::remark() const {
  if (stage_ == Stage::Reason) return "; " + firmware_->afterHalt();
  if (stage_ == Stage::Rest)
    return settings_.keep_heaters_on
               ? "; the machine did not confirm that its motions have ended"
               : "; its heaters are off, but it did not confirm that its motions have ended";
  const std::string emergency = is_emergency_ ? "" : emergencyStop();
  return "; the machine did not confirm the safe stop" + (emergency.empty() ? "" : offerOf(emergency));
}

}  // namespace lamina
