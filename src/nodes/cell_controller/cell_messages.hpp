// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/cell/production_cell.hpp"
#include "messages.hpp"

namespace lamina {

/// The unit, its job and how far that is, without a header.
lamina_msgs::PackmlStatus toMessage(const ProductionCell& cell, const std::vector<UnitMode>& modes,
                                    HoldRule rule, double now_s);

/// Of the lines of its job that were taken, 0 to 1.
double fractionOf(const ExecutorReport& report);

lamina_msgs::CellAlarm toMessage(const ActiveAlarm& alarm);
lamina_msgs::CellJob toMessage(const QueuedJob& job);

}  // namespace lamina
