// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Keeps the flow within its limits, with a note of what is slowed down. Before layers are cooled, which
/// slows them further.
void limitFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress);

/// Leaves the ends of runs to the pressure, makes up for a lag, with notes, or gives the firmware its
/// advance. Once feeds are final. Totals of the summary are those of what is left.
void finishFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress);

}  // namespace lamina
