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

/// The alarm that a drive's end raises. Nobody has given up a job whose node was ended.
int alarmOfDrive(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  switch (status.code) {
    case Status::OK:
      return 0;
    case Status::CANCELLED:
      return contains(status.message, names::kNodeEnded) ? 2202 : 0;
    case Status::DISCONNECTED:
      return 3101;
    case Status::TIMED_OUT:
      return 3105;
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
  // Whatever was lost, the job is not resumed (`traits`).
  return {"trajectory_driver", alarmOfDrive, [](const lamina_msgs::Status&) { return false; },
          StateMatch::SameJob};
}

}  // namespace lamina
