// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Paths of one tool, with the travels that led to them.
struct ToolRun {
  std::uint32_t tool = 0;
  std::vector<Path> paths;
  std::optional<std::size_t> purge = std::nullopt;  ///< of its layer, that comes before; none without
  std::size_t purging = 0;  ///< paths from its first one that purge it, which no run behind may take
};

/// A layer by tools, in the order in which they come.
using ToolRuns = std::vector<ToolRun>;

/// Lets a tool that is taken lay infill first, which hides what the tool before left in its nozzle: its own,
/// and then that of the runs before, which it takes over as whole paths until they hold that volume. Runs of
/// nothing but infill keep theirs, and others what purges them.
/// @param purged  number of that tool's run
ToolRuns withInfillFirst(ToolRuns runs, std::size_t purged, double volume_mm3);

/// Volume of the infill that a run begins with [mm³].
double leadingInfill(const ToolRun& run);

}  // namespace lamina
