// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_language.hpp"

#include "lamina/base/text_search.hpp"
#include "names.hpp"

namespace lamina {
namespace {

int alarmOfDevice(const std::string& message) {
  if (contains(message, names::kTipOff)) return 4101;
  return contains(message, names::kGoalEnded) ? 4103 : 4106;
}

/// The alarm that a drive's end raises.
int alarmOfDrive(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  if (const auto alarm = alarmOfAnyNode(status)) return *alarm;
  switch (status.code) {
    case Status::DEVICE_ERROR:
      return alarmOfDevice(status.message);
    case Status::INVALID_INPUT:
    case Status::INVALID_PROGRAM:
    case Status::FILE_ERROR:
    case Status::UNREACHABLE:
      return 4105;
    default:
      return 4106;
  }
}

}  // namespace

ExecutorLanguage driverLanguage() {
  // A robot that is told to stop brakes along its path, and stands where it stopped.
  return {"trajectory_driver", alarmOfDrive, [](const lamina_msgs::Status&) { return false; },
          StateMatch::SameJob};
}

}  // namespace lamina
