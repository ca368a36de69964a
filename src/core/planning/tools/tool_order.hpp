// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Whether any path, supports included, has another tool than the first.
bool usesTools(const PlanSettings& settings);

/// The tool of a path. A support keeps the tool of `supports.*`, unless `tool.*` names another.
std::uint32_t toolOf(const Path& path, const ToolSettings& settings);

/// The tool of all paths of a role.
std::uint32_t toolOf(PathRole role, const PlanSettings& settings);

/// The tools, by `toolOf`, of walls, infill, skins and, if used, brims, rafts and supports, in this order and
/// without duplicates.
std::vector<std::uint32_t> toolsAtWork(const PlanSettings& settings);

/// Orders each layer by tools: first the tool that ended the layer before, then the others by number, each
/// with its paths in the planned order. Travels are made anew where the order changes, and are retracted if
/// they lead to another tool. With `tools.purge_mm3` a tool that is changed to first deposits that volume
/// into a prime tower. With `tools.purge_into_infill` the tool first deposits infill that earlier tools leave
/// to it; only the rest of the volume goes into the tower. The tower has no gaps, neither over a raft nor in
/// layers without other paths. Layers of several parts may lie side by side, as on a plate. Then a layer of
/// the tower ends at the top of each, or, if a top is less than half a layer above the one below, takes the
/// purges of both. Layers are not joined yet.
/// @throws InvalidConfig if the tower is too small for its purges, or stands on the part
void arrangeTools(std::vector<ToolpathLayer>& layers, const PlanSettings& settings,
                  const TravelMaker& travel);

/// Gives travels the tool of the path to which they lead.
void giveTravelsTools(std::vector<ToolpathLayer>& layers);

}  // namespace lamina
