// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/stream_client.hpp"

#include "actions/action_run.hpp"
#include "messages.hpp"
#include "print/print_form.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using lamina_msgs::StreamProgramAction;
using lamina_msgs::StreamProgramResult;

constexpr char kStopped[] = "stopped; motion ended and the heaters are off";
constexpr std::chrono::seconds kStopPatience{30};  // a machine may have to be waited for

std::string printSummaryOf(const StreamProgramResult& result) {
  std::string text =
      "printed " + std::to_string(result.lines_acknowledged) + " lines in " + durationText(result.duration);
  if (!result.firmware.empty()) text += " on " + result.firmware;
  if (result.commands_not_done > 0)
    text += "; " + std::to_string(result.commands_not_done) +
            " commands were not done, the first: " + result.first_not_done;
  if (result.starvations > 0)
    text += "; the machine stood still " + std::to_string(result.starvations) + " times for want of a line";
  return text;
}

RunOutcome printOutcomeOf(const actionlib::SimpleClientGoalState& state,
                          const lamina_msgs::StreamProgramResultConstPtr& result) {
  if (result && result->status.code == Status::OK && state == state.SUCCEEDED)
    return {RunOutcome::End::Done, printSummaryOf(*result), ""};
  return failureOf(state, result, kStopped);
}

}  // namespace

class StreamClient::Connection : public ActionRun<StreamProgramAction> {
 public:
  using ActionRun::ActionRun;
};

StreamClient::StreamClient(const std::string& action)
    : connection_(std::make_unique<Connection>(
          action,
          ActionWords{"roslaunch lamina gcode_streamer.launch port:=/dev/ttyUSB0", "printing",
                      "look at the machine: it may still move and heat",
                      "look at the machine: it may still move and heat", "stopped before it began"})) {
  connection_->cancel_patience = kStopPatience;
  connection_->read = printOutcomeOf;
  connection_->ended = [this](const RunOutcome& outcome) {
    if (ended) ended(outcome);
  };
  connection_->progressed = [this](const lamina_msgs::StreamProgramFeedbackConstPtr& feedback) {
    if (progressed) progressed({feedback->state, feedback->layer, static_cast<double>(feedback->fraction)});
  };
}
StreamClient::~StreamClient() = default;

void StreamClient::print(const std::string& program) {
  lamina_msgs::StreamProgramGoal goal;
  goal.program = program;
  connection_->run(goal);
}
void StreamClient::stop() { connection_->cancel(); }
bool StreamClient::isRunning() const { return connection_->isRunning(); }
void StreamClient::poll() { connection_->poll(); }

}  // namespace lamina
