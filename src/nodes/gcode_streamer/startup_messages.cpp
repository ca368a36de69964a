// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "startup_messages.hpp"

#include <limits>

namespace lamina {

std::vector<lamina_msgs::StartupStep> toMessages(const std::vector<StartupStatus>& steps) {
  std::vector<lamina_msgs::StartupStep> messages;
  for (const StartupStatus& status : steps) {
    lamina_msgs::StartupStep message;
    message.name = toString(status.step);
    message.state = static_cast<std::uint8_t>(status.state);
    message.state_name = toString(status.state);
    message.reason = status.reason;
    message.value = status.value.value_or(std::numeric_limits<double>::quiet_NaN());
    message.unit = status.unit;
    message.expected = status.expected;
    messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace lamina
