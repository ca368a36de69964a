// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/gcode_rewrite/rewrite_report.hpp"
#include "messages.hpp"

namespace lamina {

/// Wall time is left to the caller.
lamina_msgs::InclineSummary toMessage(const RewriteReport& report);

}  // namespace lamina
