// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Slows down paths whose volume flow exceeds the limit, and notes in the summary what was slowed down. Must
/// precede cooling, which slows layers down further.
void limitFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress);

/// Compensates pressure and lag of the extruder: stops the flow before the ends of runs (coasting), shifts
/// the flow for a lag, or passes the advance on to the firmware, as the settings ask; with notes in the
/// summary. Must follow all changes of feeds. Totals of the summary are computed anew.
void finishFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress);

}  // namespace lamina
