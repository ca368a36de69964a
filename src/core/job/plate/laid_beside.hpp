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
/// lies round supports.
/// @param mesh  standing, as it is deposited
/// @param bed   where the nozzle may be, in the mesh's frame: brims end there, and rafts do not
Regions laidBeside(const Mesh& mesh, const JobSettings& settings, const Box2& bed, Progress& progress);

/// How much of `reachBeside` may lie beyond the bed's edge [mm]: all of it for a brim, which is cut off
/// there; 0 for a raft. A skirt goes round the whole reach.
double cutAtEdge(const JobSettings& settings);

}  // namespace lamina
