// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/tools/tool_heating.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

/// Paths that one tool runs, one after the other.
struct ToolUse {
  std::uint32_t tool = 0;
  std::size_t begin = 0;  ///< in the list of all paths
  std::size_t end = 0;    ///< one past the last
};

/// A path and when it begins.
struct StartedPath {
  Path* path = nullptr;
  double start_s = 0.0;
};

std::vector<StartedPath> startedPaths(Toolpath& toolpath, const MotionLimits& limits) {
  const PathTimes times = estimatePathTimes(toolpath, limits);
  std::vector<StartedPath> started;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      started.push_back({&toolpath.layers[l].paths[p], times.start_s[l][p]});
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
  ToolHeating(const std::vector<Tool>& tools, double nozzle_temperature_c, std::vector<StartedPath> paths)
      : tools_(tools), nozzle_temperature_c_(nozzle_temperature_c), paths_(std::move(paths)) {}

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
    return tool == 0 && temperature(tool) == nozzle_temperature_c_;
  }
  bool isHeated(std::uint32_t tool) const {
    return tool < tools_.size() && temperature(tool) > 0.0 &&
           (tools_[tool].temperature_c > 0.0 || tools_[tool].standby_c > 0.0);
  }
  double temperature(std::uint32_t tool) const {
    return tools_[tool].temperature_c > 0.0 ? tools_[tool].temperature_c : nozzle_temperature_c_;
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

  /// On the prime tower where the nozzle goes there: before it leaves it stands on the part.
  std::size_t waitingMotion(std::size_t taken) const {
    const Path& first = *paths_[taken].path;
    const bool is_way_to_tower = first.role == PathRole::Travel && taken + 1 < paths_.size() &&
                                 paths_[taken + 1].path->role == PathRole::Prime;
    return is_way_to_tower ? first.motionCount() : 0;
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
  double nozzle_temperature_c_;
  std::vector<StartedPath> paths_;
};

}  // namespace

void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, double nozzle_temperature_c,
                    const MotionLimits& limits) {
  const bool is_heated = std::any_of(tools.begin(), tools.end(), [](const Tool& tool) {
    return tool.temperature_c > 0.0 || tool.standby_c > 0.0;
  });
  if (is_heated) ToolHeating(tools, nozzle_temperature_c, startedPaths(toolpath, limits)).add();
}

}  // namespace lamina
