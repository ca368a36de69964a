// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/machine_watch.hpp"

#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "messages.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

using lamina_msgs::MachineState;

std::string temperatureText(const char* of, double celsius) {
  if (!std::isfinite(celsius)) return "";
  return std::string(" · ") + of + ' ' + std::to_string(std::lround(celsius)) + " °C";
}

WatchedState reportOf(const MachineState& state) {
  WatchedState report;
  report.is_held = state.state == MachineState::HELD;
  report.is_printing = state.state == MachineState::EXECUTE;
  report.text = state.state_name;
  if (state.lines_total > 0 && (report.is_printing || report.is_held)) {
    if (state.layer >= 0) report.text += " · layer " + std::to_string(state.layer + 1);
    report.text +=
        " · line " + std::to_string(state.lines_acknowledged) + " of " + std::to_string(state.lines_total);
  }
  report.text +=
      temperatureText("nozzle", state.nozzle_temperature) + temperatureText("bed", state.bed_temperature);
  return report;
}

}  // namespace

/// What the calls have come to, until it is polled.
struct MachineWatch::Answers {
  std::mutex mutex;
  std::vector<std::string> refusals;
};

MachineWatch::MachineWatch() : answers_(std::make_shared<Answers>()) {
  node_.setCallbackQueue(&queue_);
  const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> take =
      [this](const lamina_msgs::MachineStateConstPtr& state) {
        if (reported) reported(reportOf(*state));
      };
  subscriber_ = node_.subscribe<MachineState>(names::kMachineState, 1, take);
}

void MachineWatch::hold() { call(names::kPause); }
void MachineWatch::goOn() { call(names::kResume); }

void MachineWatch::call(const std::string& service) {
  const std::string name = node_.resolveName(service);
  std::thread([name, answers = answers_] {
    std_srvs::Trigger trigger;
    std::string refusal;
    if (!ros::service::exists(name, false))
      refusal = "no node offers the service " + name;
    else if (!callService(name, trigger))
      refusal = "the service " + name + " gave no answer";
    else if (!trigger.response.success)
      refusal = trigger.response.message;
    if (refusal.empty()) return;
    const std::lock_guard<std::mutex> lock(answers->mutex);
    answers->refusals.push_back(std::move(refusal));
  }).detach();
}

void MachineWatch::poll() {
  queue_.callAvailable();
  std::vector<std::string> refusals;
  {
    const std::lock_guard<std::mutex> lock(answers_->mutex);
    refusals.swap(answers_->refusals);
  }
  for (const std::string& refusal : refusals)
    if (refused) refused(refusal);
}

}  // namespace lamina
