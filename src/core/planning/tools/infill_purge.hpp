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
  /// Index of the purge before it in its layer, if there is one.
  std::optional<std::size_t> purge = std::nullopt;
  std::size_t purging = 0;  ///< number of its first paths that purge the tool and so must stay in this run
};

/// A layer divided by tools, in the order of laying.
using ToolRuns = std::vector<ToolRun>;

/// Makes a tool deposit infill first, which hides the remains of other material from its nozzle. It deposits
/// its own infill, and then that of earlier runs, whose paths it takes over one by one until they hold the
/// given volume. Runs that consist of infill alone keep theirs, and every run keeps the paths that purge it.
/// @param purged  index of the tool's run
ToolRuns withInfillFirst(ToolRuns runs, std::size_t purged, double volume_mm3);

/// Volume of the infill at the start of a run [mm³].
double leadingInfill(const ToolRun& run);

}  // namespace lamina
