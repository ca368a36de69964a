// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Whether any path has another tool than the first, be it a support's own.
bool usesTools(const PlanSettings& settings);

/// Which tool lays a path: supports that `supports.*` gave one keep it, unless `tool.*` names another.
std::uint32_t toolOf(const Path& path, const ToolSettings& settings);

/// The tools that lay walls, infill, skins and, where they are used, supports, as `toolOf` says: each once,
/// in that order.
std::vector<std::uint32_t> toolsAtWork(const PlanSettings& settings);

/// Lays each layer tool by tool: first the one that ended the layer before, then the others by their numbers,
/// each in the order that was planned. Travels between paths that follow each other no longer are made anew;
/// those to another tool are retracted. With `tools.purge_mm3` the tool that is taken first lays that volume
/// into a prime tower, before anything else; with `tools.purge_into_infill` infill first, which tools before
/// it leave to it, and only the rest into the tower. The tower has no gap anywhere, neither over a raft nor
/// in layers in which nothing else is laid. Layers may lie beside others' as on a plate, by their tops: the
/// tower's then end at each top, or, where that is less than half a layer higher, take what is laid there.
/// Layers are not joined yet.
/// @throws InvalidConfig if the tower is too small for its purges, or stands on the part
void arrangeTools(std::vector<ToolpathLayer>& layers, const PlanSettings& settings,
                  const TravelMaker& travel);

/// Gives travels the tool of the path that they lead to.
void giveTravelsTools(std::vector<ToolpathLayer>& layers);

}  // namespace lamina
