// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline/incline_client.hpp"

#include <cstdio>

#include "actions/action_run.hpp"
#include "messages.hpp"
#include "request_settings.hpp"

namespace lamina {
namespace {

using lamina_msgs::InclineAction;
using lamina_msgs::InclineGoal;
using lamina_msgs::Status;

constexpr char kNothingWritten[] = "cancelled; nothing was written";

InclineGoal goalOf(const InclineRequest& request) {
  InclineGoal goal;
  goal.program = request.program;
  goal.output = request.output;
  for (const auto& [key, text] : request.settings) goal.settings.push_back(settingMessage(key, text));
  return goal;
}

std::string summaryOf(const lamina_msgs::InclineSummary& summary) {
  std::string text = std::to_string(summary.lines) + " lines, " + std::to_string(summary.layers) + " layers";
  if (!summary.slicer.empty()) text += " of " + summary.slicer;
  char computed[40];
  std::snprintf(computed, sizeof computed, ", computed in %.3f s", summary.wall_time);
  text += computed;
  if (summary.homings_annulled > 0) text += "; home the machine before, the program does not";
  if (summary.stands_on_edge)
    text += "; the part stands on an edge: was the mesh tilted by the opposite angle?";
  return text;
}

RunOutcome outcomeOf(const actionlib::SimpleClientGoalState& state,
                     const lamina_msgs::InclineResultConstPtr& result) {
  if (result && result->status.code == Status::OK && state == state.SUCCEEDED)
    return {RunOutcome::End::Done, summaryOf(result->summary), result->output};
  return failureOf(state, result, kNothingWritten);
}

}  // namespace

class InclineClient::Connection : public ActionRun<InclineAction> {
 public:
  using ActionRun::ActionRun;
};

InclineClient::InclineClient(const std::string& action)
    : connection_(std::make_unique<Connection>(
          action, ActionWords{"roslaunch lamina gcode_incliner.launch", "inclining",
                              "the output is whole or was not written", "the output may still be written",
                              kNothingWritten})) {
  connection_->read = outcomeOf;
  connection_->ended = [this](const RunOutcome& outcome) {
    if (ended) ended(outcome);
  };
  connection_->progressed = [this](const lamina_msgs::InclineFeedbackConstPtr& feedback) {
    if (progressed) progressed(feedback->stage, static_cast<double>(feedback->fraction));
  };
}
InclineClient::~InclineClient() = default;
void InclineClient::run(const InclineRequest& request) { connection_->run(goalOf(request)); }
void InclineClient::cancel() { connection_->cancel(); }
bool InclineClient::isRunning() const { return connection_->isRunning(); }
void InclineClient::poll() { connection_->poll(); }

}  // namespace lamina
