// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/slice_client.hpp"

#include <cstdio>

#include "actions/action_run.hpp"
#include "messages.hpp"
#include "request_settings.hpp"

namespace lamina {
namespace {

using lamina_msgs::SliceAction;
using lamina_msgs::SliceGoal;
using lamina_msgs::Status;

constexpr char kNotSliced[] = "cancelled; nothing was written";
constexpr double kCubicCentimetres = 1e6;  // in a cubic metre

SliceGoal goalOf(const SliceRequest& request) {
  SliceGoal goal;
  goal.part = request.part;
  goal.output = request.program;
  for (const auto& [key, text] : request.settings) goal.settings.push_back(settingMessage(key, text));
  return goal;
}

std::string sliceSummaryOf(const lamina_msgs::SliceSummary& summary) {
  char volume[32];
  std::snprintf(volume, sizeof volume, "%.3g cm³", kCubicCentimetres * summary.deposited_volume);
  std::string text = std::to_string(summary.layers) + " layers, " + durationText(summary.estimated_time) +
                     ", " + volume + " of material";
  for (const std::string& repair : summary.repairs) text += "; repaired: " + repair;
  for (const std::string& note : summary.notes) text += "; " + note;
  return text;
}

RunOutcome sliceOutcomeOf(const SliceGoal& goal, const actionlib::SimpleClientGoalState& state,
                          const lamina_msgs::SliceResultConstPtr& result) {
  if (result && result->status.code == Status::OK && state == state.SUCCEEDED)
    return {RunOutcome::End::Done, sliceSummaryOf(result->summary), goal.output};
  return failureOf(state, result, kNotSliced);
}

}  // namespace

class SliceClient::Connection : public ActionRun<SliceAction> {
 public:
  using ActionRun::ActionRun;
};

SliceClient::SliceClient(const std::string& action)
    : connection_(std::make_unique<Connection>(
          action, ActionWords{"roslaunch lamina slicing_service.launch", "slicing",
                              "the program is whole or was not written", "the program may still be written",
                              kNotSliced})) {
  connection_->ended = [this](const RunOutcome& outcome) {
    if (ended) ended(outcome);
  };
  connection_->progressed = [this](const lamina_msgs::SliceFeedbackConstPtr& feedback) {
    if (progressed) progressed(feedback->stage, static_cast<double>(feedback->fraction));
  };
}
SliceClient::~SliceClient() = default;

void SliceClient::run(const SliceRequest& request) {
  if (isRunning()) return;
  const SliceGoal goal = goalOf(request);
  connection_->read = [goal](const auto& state, const auto& result) {
    return sliceOutcomeOf(goal, state, result);
  };
  connection_->run(goal);
}
void SliceClient::cancel() { connection_->cancel(); }
bool SliceClient::isRunning() const { return connection_->isRunning(); }
void SliceClient::poll() { connection_->poll(); }

}  // namespace lamina
