// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream_executor.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "lamina/base/text.hpp"
#include "lamina/base/text_search.hpp"
#include "lamina/streaming/job/unstopped_machine.hpp"
#include "names.hpp"

namespace lamina {
namespace {

/// In the words of Marlin, RepRapFirmware and Klipper.
bool isHeaterFault(const std::string& message) {
  constexpr std::array<std::string_view, 8> kSigns = {
      "thermal runaway", "heating failed", "mintemp",          "maxtemp",
      "heater fault",    "not heating",    "adc out of range", "temperature excursion"};
  const std::string small = lowerCase(message);
  return std::any_of(kSigns.begin(), kSigns.end(),
                     [&small](std::string_view sign) { return contains(small, sign); });
}

int alarmOfRejection(const std::string& message) {
  if (isHeaterFault(message)) return 3104;
  return contains(message, "the machine halted: ") || contains(message, "the machine has halted: ") ? 3103
                                                                                                    : 3106;
}

/// The alarm that a job's failure raises.
int alarmOf(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  if (const auto alarm = alarmOfAnyNode(status)) return *alarm;
  switch (status.code) {
    case Status::DEVICE_ERROR:
      return contains(status.message, "was reset") ? 3102 : 3106;
    case Status::REJECTED:
      return alarmOfRejection(status.message);
    default:
      return 3106;
  }
}

/// Whether the job's end has stopped the machine, or told it to stop, after lines of the job: motions that
/// it had accepted are then lost.
bool isStoppedBy(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  if (status.code == Status::CANCELLED || status.code == Status::TIMED_OUT) return true;
  return status.code == Status::DISCONNECTED && !contains(status.message, kLinkNotBack) &&
         !contains(status.message, kMayStillPrint);
}

}  // namespace

StreamExecutor::StreamExecutor(const ros::NodeHandle& node, std::function<void(const ExecutorReport&)> report)
    : ActionExecutor(node, names::kStreamProgram, {"gcode_streamer", alarmOf, isStoppedBy},
                     std::move(report)) {}

lamina_msgs::StreamProgramGoal StreamExecutor::goalOf(const StartOrder& order) const {
  lamina_msgs::StreamProgramGoal goal;
  goal.program = order.program;
  goal.resume = order.start != ExecutionStart::Anew;
  goal.or_begin = order.start == ExecutionStart::ResumeIfBegun;
  goal.execution = order.execution;
  return goal;
}

std::uint64_t StreamExecutor::takenThrough(const lamina_msgs::StreamProgramResult& result) const {
  return result.lines_acknowledged;
}

}  // namespace lamina
