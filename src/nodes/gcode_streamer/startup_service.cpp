// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "startup_service.hpp"

#include <ros/console.h>

#include "lamina/base/error.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "startup_messages.hpp"
#include "status.hpp"

namespace lamina {
namespace {

StartupStep stepByName(const std::string& name) {
  const auto step = startupStepFromText(name);
  if (!step) throw InvalidInput("'" + name + "' is no step; expected one of startup.sequence");
  return *step;
}

}  // namespace

StartupService::StartupService(ros::NodeHandle node, StartupSession& startup)
    : startup_(startup),
      server_(node.advertiseService(names::kRunStartup, &StartupService::onRequest, this)) {}

bool StartupService::onRequest(Request& request, Response& response) {
  try {
    follow(request);
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText(
        {"follow the start-up request for step", request.step.empty() ? "all" : request.step, ""}, failure));
    response.status = toMessage(failure);
  }
  response.steps = toMessages(startup_.steps());
  return true;
}

void StartupService::follow(const Request& request) {
  switch (request.command) {
    case Request::RUN:
      if (request.step.empty()) return startup_.run(std::nullopt);
      return startup_.run(stepByName(request.step));
    case Request::CONFIRM:
      return confirm(request);
    case Request::ABORT:
      return startup_.abort();
    default:
      throw InvalidInput("command is " + std::to_string(request.command) +
                         "; expected RUN, CONFIRM or ABORT");
  }
}

void StartupService::confirm(const Request& request) {
  const StartupStep step = stepByName(request.step);
  if (step != StartupStep::TransferProgram) return startup_.confirm(step);
  const ProgramIdentity program = identityOfFile(request.program);
  requireWhole(program, request.bytes, request.crc32);
  startup_.transferred(program);
}

}  // namespace lamina
