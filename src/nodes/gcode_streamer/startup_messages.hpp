// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/startup/startup_step.hpp"
#include "messages.hpp"

namespace lamina {

/// @return one message per step, in order
std::vector<lamina_msgs::StartupStep> toMessages(const std::vector<StartupStatus>& steps);

}  // namespace lamina
