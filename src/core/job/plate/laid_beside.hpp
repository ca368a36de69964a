// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// How far a raft, or a brim round the outside, extends beyond the outlines of a part's first layer [mm].
double reachBeside(const JobSettings& settings);

/// What a raft or a brim covers of the bed beside a part, as far as the first layer shows it: without what
/// lies round supports. Beds do not end it.
/// @param mesh  standing, as it is deposited
Regions laidBeside(const Mesh& mesh, const JobSettings& settings, Progress& progress);

}  // namespace lamina
