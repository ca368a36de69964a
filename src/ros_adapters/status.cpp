// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "status.hpp"

namespace lamina {

lamina_msgs::Status toMessage(const Failure& failure) {
  lamina_msgs::Status status;
  status.code = static_cast<std::uint8_t>(failure.code);
  status.message = failure.message;
  return status;
}

Failure fromMessage(const lamina_msgs::Status& status) {
  const auto code = static_cast<ErrorCode>(status.code);
  if (std::string(toString(code)) == "Unknown")
    throw InvalidInput("status code is " + std::to_string(status.code) + "; must be one of lamina/Status");
  return {code, status.message};
}

void throwIfFailed(const lamina_msgs::Status& status) {
  if (status.code == lamina_msgs::Status::OK) return;
  const Failure failure = fromMessage(status);
  throw Error(failure.code, failure.message);
}

}  // namespace lamina
