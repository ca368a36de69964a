// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/plate_tower.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lamina/base/error.hpp"
#include "planning/tools/prime_tower.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {
namespace {

bool hasSeveralTools(const Toolpath& plate) {
  std::optional<std::uint32_t> first;
  for (const ToolpathLayer& layer : plate.layers)
    for (const Path& path : layer.paths) {
      if (first.value_or(path.tool) != path.tool) return true;
      first = path.tool;
    }
  return false;
}

/// That lay any of the parts, as far as settings state: regions may have others.
std::set<std::size_t> toolsOfParts(const std::vector<TowerNeighbour>& parts) {
  std::set<std::size_t> tools;
  for (const TowerNeighbour& part : parts) {
    const PlanSettings& settings = part.settings->planning;
    std::vector<PathRole> roles = {PathRole::OuterWall};
    if (isFilled(settings.infill)) roles.push_back(PathRole::Infill);
    if (hasSkins(settings.skins)) roles.push_back(PathRole::Skin);
    for (const PathRole role : roles) tools.insert(toolFor(role, settings.tools));
  }
  return tools;
}

PathEvent markOf(std::size_t motion, const std::string& part) {
  PathEvent event;
  event.motion = motion;
  event.event.emplace<PartMark>(PartMark{part});
  return event;
}

/// Takes the marks of a path away.
/// @return the last one
std::optional<std::string> takenMark(Path& path) {
  std::optional<std::string> name;
  const auto takes = [&name](const PathEvent& placed) {
    const auto* const mark = std::get_if<PartMark>(&placed.event);
    if (mark != nullptr) name = mark->name;
    return mark != nullptr;
  };
  path.events.erase(std::remove_if(path.events.begin(), path.events.end(), takes), path.events.end());
  return name;
}

/// Marks each path that lays something with its part, in place of where parts begin.
void markEach(Toolpath& plate) {
  std::string part;
  for (ToolpathLayer& layer : plate.layers)
    for (Path& path : layer.paths) {
      const bool is_at_start = !path.events.empty() && path.events.front().motion == 0;
      const std::optional<std::string> next = takenMark(path);
      if (next && is_at_start) part = *next;
      if (path.role != PathRole::Travel) path.events.insert(path.events.begin(), markOf(0, part));
      if (next) part = *next;
    }
}

/// Marks where parts begin, at the end of the path that comes before the way there.
void markChanges(Toolpath& plate) {
  std::string part;
  Path* last = nullptr;    // path of all
  Path* before = nullptr;  // the one before that
  for (ToolpathLayer& layer : plate.layers)
    for (Path& path : layer.paths) {
      if (path.role != PathRole::Travel) {
        const std::string own = takenMark(path).value_or("");
        if (std::exchange(part, own) != own) {
          Path* const left = last != nullptr && last->role == PathRole::Travel ? before : last;
          if (left != nullptr)
            left->events.push_back(markOf(left->motionCount(), own));
          else
            path.events.insert(path.events.begin(), markOf(0, own));
        }
      }
      before = std::exchange(last, &path);
    }
}

void join(Toolpath& plate, const TravelSettings& settings) {
  const Path* previous = nullptr;
  for (ToolpathLayer& layer : plate.layers) {
    std::vector<Path>& paths = layer.paths;
    if (paths.empty()) continue;
    if (previous != nullptr)
      if (auto travel = makeTravel(previous->lastPoint(), paths.front().firstPoint(), settings)) {
        travel->process.is_retracted |= previous->tool != paths.front().tool;
        paths.insert(paths.begin(), std::move(*travel));
      }
    previous = &paths.back();
  }
}

}  // namespace

double roomForTower(const JobSettings& plate, const std::vector<TowerNeighbour>& parts) {
  const ToolSettings& tools = plate.planning.tools;
  const std::size_t count = toolsOfParts(parts).size();
  if (tools.purge_mm3.empty() || !tools.tower_at_mm.empty() || count < 2) return 0.0;
  std::set<std::pair<double, double>> stacks;  // layer and first layer
  double lowest_mm = plate.slicing.layer_height_mm;
  for (const TowerNeighbour& part : parts) {
    const SlicingSettings& slicing = part.settings->slicing;
    stacks.emplace(slicing.layer_height_mm, slicing.first_layer_height_mm);
    lowest_mm = std::min({lowest_mm, slicing.layer_height_mm, slicing.first_layer_height_mm});
  }
  // Levels between layers of unequal heights are lower, and take the purges of several of them.
  TowerLayer layer{stacks.size() > 1 ? 0.5 * lowest_mm : lowest_mm, {}};
  const double greatest_mm3 = *std::max_element(tools.purge_mm3.begin(), tools.purge_mm3.end());
  layer.purges.push_back({0, static_cast<double>((count - 1) * stacks.size()) * greatest_mm3});
  PlanSettings alone = plate.planning;
  alone.tools.tower_mm = 0.0;
  const double side_mm = PrimeTower({layer}, alone, Box2{Point2(0.0, 0.0), Point2(0.0, 0.0)}).side();
  return kTowerBesidePart + std::max(side_mm, tools.tower_mm);
}

Toolpath withTower(Toolpath plate, const PlanSettings& settings) {
  if (!hasSeveralTools(plate)) return plate;
  markEach(plate);
  arrangeTools(plate.layers, settings, levelTravels(settings.travel));
  join(plate, settings.travel);
  giveTravelsTools(plate.layers);
  markChanges(plate);
  return plate;
}

}  // namespace lamina
