// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/process_io/channel_drive.hpp"
#include "lamina/process_io/process_tables.hpp"
#include "lamina/process_io/process_watch.hpp"
#include "messages.hpp"

namespace lamina {

/// What the process does, without stamp: what devices read where they do, else the effects there should be.
/// @param measured  of each input [unit of its quantity]; NaN where it is not read
lamina_msgs::ProcessState effectsMessage(const ProcessTables& tables, const std::vector<ChannelDrive>& drives,
                                         const std::vector<double>& measured);

/// With the time of now.
lamina_msgs::AlarmReport toReport(const ProcessAlarm& alarm);

}  // namespace lamina
