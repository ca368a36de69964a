// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/cell/production_cell.hpp"
#include "lamina/cell/resume_steps.hpp"
#include "messages.hpp"

namespace lamina {

/// The state of the unit, its job and the job's progress, without a header.
lamina_msgs::PackmlStatus toMessage(const ProductionCell& cell, const std::vector<UnitMode>& modes,
                                    HoldRule rule, double now_s);

/// Fraction of the job's lines that were taken, 0 to 1.
double fractionOf(const ExecutorReport& report);

lamina_msgs::CellAlarm toMessage(const ActiveAlarm& alarm);
lamina_msgs::ResumeStep toMessage(const ResumeStep& step);
/// Where a program of lines is gone on with.
std::string lineText(std::uint64_t taken_through);
/// That the machine reported last; empty if it reported none.
std::string temperaturesText(const lamina_msgs::MachineState& machine);
lamina_msgs::CellJob toMessage(const QueuedJob& job);

}  // namespace lamina
