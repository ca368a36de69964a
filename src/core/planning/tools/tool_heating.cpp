// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/tools/tool_heating.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "lamina/toolpath/timing.hpp"
#include "planning/cooling/parking.hpp"

namespace lamina {
namespace {

/// Paths that one tool runs, one after the other.
struct ToolUse {
  std::uint32_t tool = 0;
  std::size_t begin = 0;  ///< in the list of all paths
  std::size_t end = 0;    ///< one past the last
};

/// A path, its layer, and when it begins.
struct StartedPath {
  Path* path = nullptr;
  std::size_t layer = 0;
  double start_s = 0.0;
};

std::vector<StartedPath> startedPaths(Toolpath& toolpath, const MotionLimits& limits) {
  const PathTimes times = estimatePathTimes(toolpath, limits);
  std::vector<StartedPath> started;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      started.push_back({&toolpath.layers[l].paths[p], l, times.start_s[l][p]});
  return started;
}

std::vector<ToolUse> usesOf(const std::vector<StartedPath>& paths) {
  std::vector<ToolUse> uses;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (uses.empty() || uses.back().tool != paths[i].path->tool) uses.push_back({paths[i].path->tool, i, i});
    uses.back().end = i + 1;
  }
  return uses;
}

class ToolHeating {
 public:
  ToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, const ToolHeatingSite& site)
      : tools_(tools),
        site_(site),
        grounds_(parkingGrounds(toolpath)),
        paths_(startedPaths(toolpath, site.limits)) {}

  void add() const {
    const std::vector<ToolUse> uses = usesOf(paths_);
    if (!uses.empty() && !isHeatedAtStart(uses.front().tool)) heat(uses.front().tool, 0, 0);
    for (std::size_t u = 1; u < uses.size(); ++u) {
      const ToolUse& use = uses[u];
      if (!isHeated(use.tool)) continue;
      const auto former = std::find_if(uses.rend() - static_cast<std::ptrdiff_t>(u), uses.rend(),
                                       [&use](const ToolUse& each) { return each.tool == use.tool; });
      if (former == uses.rend()) {
        heat(use.tool, 0, use.begin);
      } else if (tools_[use.tool].standby_c > 0.0) {
        reheat(use, former->end);
      }
    }
    std::map<std::uint32_t, std::size_t> last_end;
    for (const ToolUse& use : uses) last_end[use.tool] = use.end;
    for (const auto& [tool, end] : last_end)
      if (end < paths_.size() && isHeated(tool) && tools_[tool].standby_c > 0.0)
        put(end, "M104", tool, tools_[tool].standby_c);
  }

 private:
  /// The program's start heats tool 0 to the temperature of the program.
  bool isHeatedAtStart(std::uint32_t tool) const {
    if (tool >= tools_.size() || temperature(tool) == 0.0) return true;
    return tool == 0 && temperature(tool) == site_.nozzle_temperature_c;
  }
  bool isHeated(std::uint32_t tool) const {
    return tool < tools_.size() && temperature(tool) > 0.0 &&
           (tools_[tool].temperature_c > 0.0 || tools_[tool].standby_c > 0.0);
  }
  double temperature(std::uint32_t tool) const {
    return tools_[tool].temperature_c > 0.0 ? tools_[tool].temperature_c : site_.nozzle_temperature_c;
  }

  /// Stands by from the path at which it was left, if there is time to heat it again.
  void reheat(const ToolUse& use, std::size_t left) const {
    if (paths_[use.begin].start_s - paths_[left].start_s <= tools_[use.tool].heat_s) return;
    put(left, "M104", use.tool, tools_[use.tool].standby_c);
    heat(use.tool, left, use.begin);
  }

  void heat(std::uint32_t tool, std::size_t from, std::size_t taken) const {
    const double latest_s = paths_[taken].start_s - tools_[tool].heat_s;
    std::size_t at = taken;
    while (at > from && paths_[at].start_s > latest_s) --at;
    if (at < taken) put(at, "M104", tool, temperature(tool));
    put(taken, "M109", tool, temperature(tool), waitingMotion(taken));
  }

  /// On the prime tower where the nozzle goes there, otherwise at the parking place, to which the travel is
  /// led: before it the nozzle stands on the part.
  std::size_t waitingMotion(std::size_t taken) const {
    Path& first = *paths_[taken].path;
    if (taken == 0 || first.role != PathRole::Travel || taken + 1 >= paths_.size()) return 0;
    const Path& next = *paths_[taken + 1].path;
    if (next.role == PathRole::Prime) return first.motionCount();
    if (next.role == PathRole::Travel || !first.orientation.isCommon()) return 0;
    return leadOverPark(first, next, grounds_[paths_[taken].layer]);
  }

  /// @return the motion of the travel that begins at the parking place
  std::size_t leadOverPark(Path& travel, const Path& next, const ParkingGround& ground) const {
    Path wait = parkedWait(travel, 0, travel.feed_mm_s.at(travel.points.size() - 1), ground, site_.parking);
    const std::size_t parked = wait.events.front().motion;
    std::vector<Path> way = {travel};
    way.front().events.clear();
    leadOn(wait, way, next, ground, site_.limits);
    for (const Path& rest : way)
      wait.points.insert(wait.points.end(), rest.points.begin() + 1, rest.points.end());
    travel.points = std::move(wait.points);
    travel.process.is_retracted = true;
    travel.feed_mm_s = wait.feed_mm_s;
    travel.bead = Bead{};
    for (PathEvent& placed : travel.events)
      if (placed.motion > 0) placed.motion = travel.motionCount();
    return parked;
  }

  void put(std::size_t path, const char* command, std::uint32_t tool, double temperature_c,
           std::size_t motion = 0) const {
    char text[64];
    std::snprintf(text, sizeof text, "%s T%u S%g\n", command, static_cast<unsigned>(tool), temperature_c);
    std::vector<PathEvent>& events = paths_[path].path->events;
    const auto behind = std::find_if(events.begin(), events.end(),
                                     [motion](const PathEvent& placed) { return placed.motion > motion; });
    PathEvent event;
    event.motion = motion;
    event.event.emplace<MachineCode>(MachineCode{text, false});
    events.insert(behind, std::move(event));
  }

  const std::vector<Tool>& tools_;
  const ToolHeatingSite& site_;
  std::vector<ParkingGround> grounds_;  ///< by layer
  std::vector<StartedPath> paths_;
};

}  // namespace

void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, const ToolHeatingSite& site) {
  const bool is_heated = std::any_of(tools.begin(), tools.end(), [](const Tool& tool) {
    return tool.temperature_c > 0.0 || tool.standby_c > 0.0;
  });
  if (is_heated) ToolHeating(toolpath, tools, site).add();
}

}  // namespace lamina
