// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
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
/// Why a command has a value that it cannot have; empty if it has none.
std::string faultOf(const lamina_msgs::PackmlCommand::Request& request);
/// What a person has confirmed of a resume, by the command that asks for it.
ResumeConfirmation confirmationOf(const lamina_msgs::PackmlCommand::Request& request);
/// Guards of what a person has to confirm of a resume and has not.
std::vector<UnmetGuard> againstUnconfirmed(const std::vector<ResumeStep>& steps,
                                           const ResumeConfirmation& confirmed);
/// The answer to a command that moves and came too late; nothing if it came in time.
std::optional<CommandAnswer> expiredAnswer(const lamina_msgs::PackmlCommand::Request& request,
                                           UnitCommand command);
/// Where a program of lines is gone on with.
std::string lineText(std::uint64_t taken_through);
/// That the machine reported last; empty if it reported none.
std::string temperaturesText(const lamina_msgs::MachineState& machine);
lamina_msgs::CellJob toMessage(const QueuedJob& job);

}  // namespace lamina
