// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/runs/bead_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where the tool comes to a place from: along z, or along the tool axis.
Point3 entryPoint(const Point3& place, const Eigen::Quaterniond& nozzle, const EntrySettings& settings);

/// The straight way between a place and its entry.
Path entryTravel(const Point3& from, const Point3& to, const Eigen::Quaterniond& nozzle, double feed_mm_s);

/// The travel ends at an entry: the waypoint before that may be there already.
void endAtEntry(Path& travel, const Point3& entry);
/// The same of its start.
void startAtEntry(Path& travel, const Point3& entry);

}  // namespace lamina
