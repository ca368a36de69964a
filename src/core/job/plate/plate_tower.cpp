// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/plate_tower.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lamina/base/error.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {
namespace {

constexpr double kOverlap = 1e-6;  // mm

bool hasSeveralTools(const Toolpath& plate) {
  std::optional<std::uint32_t> first;
  for (const ToolpathLayer& layer : plate.layers)
    for (const Path& path : layer.paths) {
      if (first.value_or(path.tool) != path.tool) return true;
      first = path.tool;
    }
  return false;
}

/// A tower has one layer on the other.
void requireStacked(const Toolpath& plate) {
  for (std::size_t l = 1; l < plate.layers.size(); ++l) {
    const double bottom_mm = plate.layers[l].z_mm - plate.layers[l].height_mm;
    if (bottom_mm > plate.layers[l - 1].z_mm - kOverlap) continue;
    throw InvalidConfig("tools.purge_mm3 is set for a plate on which a layer from " +
                        std::to_string(bottom_mm) + " mm lies beside one up to " +
                        std::to_string(plate.layers[l - 1].z_mm) +
                        " mm; expected none, or parts of the same layer heights: a prime tower has one layer "
                        "on the other");
  }
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

Toolpath withTower(Toolpath plate, const PlanSettings& settings) {
  if (!hasSeveralTools(plate)) return plate;
  requireStacked(plate);
  markEach(plate);
  arrangeTools(plate.layers, settings, levelTravels(settings.travel));
  join(plate, settings.travel);
  giveTravelsTools(plate.layers);
  markChanges(plate);
  return plate;
}

}  // namespace lamina
