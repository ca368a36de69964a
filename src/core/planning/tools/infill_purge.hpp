// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Paths of one tool in a layer, with the travels that lead to them.
struct ToolRun {
  std::uint32_t tool = 0;
  std::vector<Path> paths;
  std::optional<std::size_t> purge = std::nullopt;  ///< number of the purge before it in its layer, if any
  std::size_t purging = 0;  ///< number of its first paths that purge it, which no later run may take
};

/// A layer divided by tools, in the order of laying.
using ToolRuns = std::vector<ToolRun>;

/// Lets a tool lay infill first, which hides the remains of other material in its nozzle. It lays its own
/// infill, then that of runs before it, of which it takes over whole paths until they hold that volume. Runs
/// of infill alone keep theirs, and any run keeps the paths that purge it.
/// @param purged  number of the tool's run
ToolRuns withInfillFirst(ToolRuns runs, std::size_t purged, double volume_mm3);

/// Volume of the infill at the start of a run [mm³].
double leadingInfill(const ToolRun& run);

}  // namespace lamina
