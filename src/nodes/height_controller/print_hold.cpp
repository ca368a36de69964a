// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_hold.hpp"

#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <cstdint>

#include "messages.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

constexpr std::uint8_t kNotInThisState = 2;

PrintHold::Answer holdUnit() {
  lamina_msgs::PackmlCommand hold;
  hold.request.command = lamina_msgs::PackmlCommand::Request::HOLD;
  hold.request.source = "height_controller";
  hold.request.expected_sequence = -1;
  if (!callService(names::kPackmlCommand, hold)) return {false, "the unit did not answer to Hold"};
  if (hold.response.message.empty()) return {true, "the unit holds the print"};
  // Mostly since it holds already, by the alarm that was reported to it.
  if (hold.response.result == kNotInThisState)
    return {true, "the unit takes no Hold: " + hold.response.message};
  return {false, "the print is not held: " + hold.response.message};
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
  asked_ = std::async(std::launch::async, ask_);
  if (!isReady(asked_, kPatience)) return "the print has not answered to pause within 1 s";
  return asked_.get().text;
}

std::optional<std::string> PrintHold::takeLate() {
  if (!asked_.valid() || !isReady(asked_, 0.0)) return std::nullopt;
  const Answer answer = asked_.get();
  if (answer.is_held || !is_wanted_again_) return answer.text;
  return answer.text + "; asked again: " + hold();
}

}  // namespace lamina
