// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/monitoring/stamped_heights.hpp"
#include "messages.hpp"
#include "profile_intake.hpp"

namespace lamina {

/// Counts of clouds from one time to another; clouds that were waiting at the first time count as received
/// since.
IntakeCounts since(const IntakeCounts& then, const IntakeCounts& now);

/// @param intake  since the toolpath came
/// @param use     of those placed
lamina_msgs::ProfileCounts toMessage(const IntakeCounts& intake, const ProfileUse& use);

/// Number of profiles that arrived, or should have, and are in no map.
std::uint64_t unused(const lamina_msgs::ProfileCounts& counts);

}  // namespace lamina
