// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_hold.hpp"

#include <ros/init.h>
#include <ros/service.h>
#include <ros/topic.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <cstdint>
#include <utility>

#include "messages.hpp"
#include "names.hpp"
#include "service_call.hpp"
#include "unit_hold.hpp"

namespace lamina {
namespace {

constexpr int kTries = 25;
constexpr double kBetweenTries = 0.2;    // s
constexpr double kStatusPatience = 1.0;  // s: the unit's status is latched, and repeated twice a second

std::optional<UnitState> stateOfUnit() {
  const auto status = ros::topic::waitForMessage<lamina_msgs::PackmlStatus>(names::kPackmlStatus,
                                                                            ros::Duration(kStatusPatience));
  if (!status) return std::nullopt;
  return static_cast<UnitState>(status->state);
}

PrintHold::Answer askUnit() {
  lamina_msgs::PackmlCommand hold;
  hold.request.command = lamina_msgs::PackmlCommand::Request::HOLD;
  hold.request.source = "height_controller";
  hold.request.expected_sequence = -1;
  if (!callService(names::kPackmlCommand, hold)) return {false, "the unit did not answer to Hold"};
  const auto result = static_cast<CommandResult>(hold.response.result);
  const bool is_refused = result == CommandResult::NotInThisState && !hold.response.message.empty();
  return answerToHold(result, hold.response.message, is_refused ? stateOfUnit() : std::nullopt);
}

/// A unit that is on its way to go on takes a Hold once it has gone on.
PrintHold::Answer holdUnit() {
  PrintHold::Answer answer = askUnit();
  for (int i = 1; i < kTries && answer.is_passing && ros::ok(); ++i) {
    ros::WallDuration(kBetweenTries).sleep();
    answer = askUnit();
  }
  return answer;
}

PrintHold::Answer holdPrint() {
  // Where the print has a unit, that one alone orders its executor about.
  if (ros::service::exists(names::kPackmlCommand, false)) return holdUnit();
  std_srvs::Trigger pause;
  if (!ros::service::exists(names::kPause, false)) return {false, "nobody offers to pause the print"};
  if (!callService(names::kPause, pause)) return {false, "the print did not answer to pause"};
  if (pause.response.success) return {true, "the print is held"};
  return {false, "the print is not held: " + pause.response.message};
}

bool isReady(const std::future<PrintHold::Answer>& asked, double patience_s) {
  return asked.wait_for(std::chrono::duration<double>(patience_s)) == std::future_status::ready;
}

}  // namespace

PrintHold::PrintHold() : PrintHold(holdPrint) {}

std::string PrintHold::hold() {
  if (asked_.valid() && !isReady(asked_, 0.0)) {
    is_wanted_again_ = true;
    return "the print was asked to pause before and has not answered";
  }
  is_wanted_again_ = false;
  is_wanted_ = true;
  waits_for_.clear();
  asked_ = std::async(std::launch::async, ask_);
  if (!isReady(asked_, kPatience)) return "the print has not answered to pause within 1 s";
  return asked_.get().text;
}

void PrintHold::release() { is_wanted_ = is_wanted_again_ = false; }

std::optional<std::string> PrintHold::takeLate() {
  if (!asked_.valid() || !isReady(asked_, 0.0)) return std::nullopt;
  const Answer answer = asked_.get();
  // A unit that is suspended may be so for hours: nothing is laid until it goes on, and then it takes a Hold.
  if (!answer.is_held && answer.is_passing && is_wanted_) {
    asked_ = std::async(std::launch::async, ask_);
    if (std::exchange(waits_for_, answer.text) == answer.text) return std::nullopt;
    return answer.text + "; it is asked until it takes it";
  }
  if (answer.is_held || !is_wanted_again_) return answer.text;
  return answer.text + "; asked again: " + hold();
}

}  // namespace lamina
