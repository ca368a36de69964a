// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_hold.hpp"

#include <std_srvs/Trigger.h>

#include <chrono>

#include "messages.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

std::string holdUnit() {
  lamina_msgs::PackmlCommand hold;
  hold.request.command = lamina_msgs::PackmlCommand::Request::HOLD;
  hold.request.source = "height_controller";
  hold.request.expected_sequence = -1;
  if (!callService(names::kPackmlCommand, hold)) return "the unit did not answer to Hold";
  if (hold.response.message.empty()) return "the unit holds the print";
  return "the print is not held: " + hold.response.message;
}

}  // namespace

std::string PrintHold::hold() {
  using namespace std::chrono_literals;
  if (asked_.valid() && asked_.wait_for(0s) != std::future_status::ready)
    return "the print was asked to pause before and has not answered";
  asked_ = std::async(std::launch::async, [] {
    // Where the print has a unit, that one alone orders its executor about.
    if (ros::service::exists(names::kPackmlCommand, false)) return holdUnit();
    std_srvs::Trigger pause;
    if (!ros::service::exists(names::kPause, false)) return std::string("nobody offers to pause the print");
    if (!callService(names::kPause, pause)) return std::string("the print did not answer to pause");
    return pause.response.success ? std::string("the print is held")
                                  : "the print is not held: " + pause.response.message;
  });
  if (asked_.wait_for(std::chrono::duration<double>(kPatience)) != std::future_status::ready)
    return "the print has not answered to pause within 1 s";
  return asked_.get();
}

}  // namespace lamina
