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

/// A layer divided by tools, in the order of deposition.
using ToolRuns = std::vector<ToolRun>;

/// Makes a tool deposit infill first: infill hides the remains of other material in the nozzle. Its run
/// begins with its own infill, then with paths of infill taken over from earlier runs, one by one, until the
/// volume is reached. Runs that consist of infill alone keep their paths, and every run keeps the paths that
/// purge its tool.
/// @param purged  index of the tool's run
ToolRuns withInfillFirst(ToolRuns runs, std::size_t purged, double volume_mm3);

/// Volume of the infill at the start of a run [mm³].
double leadingInfill(const ToolRun& run);

}  // namespace lamina
