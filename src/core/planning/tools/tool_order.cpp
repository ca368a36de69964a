// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_order.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "planning/tools/infill_purge.hpp"
#include "planning/tools/prime_tower.hpp"

namespace lamina {
namespace {

constexpr double kNoGap = 1e-6;      // mm
constexpr double kLeastPurge = 0.1;  // mm³, that is worth a place in the tower
constexpr double kLift = 0.2;        // mm
constexpr double kLiftFeed = 20.0;   // mm/s

/// That lays the first path of all; 0 without any.
std::uint32_t firstTool(const std::vector<ToolpathLayer>& layers) {
  for (const ToolpathLayer& layer : layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) return path.tool;
  return 0;
}

/// The tools of a layer: the one at work first.
std::vector<std::uint32_t> orderedTools(const ToolpathLayer& layer, std::uint32_t at_work) {
  std::set<std::uint32_t> used;
  for (const Path& path : layer.paths)
    if (path.role != PathRole::Travel) used.insert(path.tool);
  std::vector<std::uint32_t> tools;
  if (used.erase(at_work) > 0) tools.push_back(at_work);
  tools.insert(tools.end(), used.begin(), used.end());
  return tools;
}

/// The paths of a layer by tools. A travel stays where it leads from one path of a tool to its next.
ToolRuns runsOf(std::vector<Path> paths, const std::vector<std::uint32_t>& tools) {
  ToolRuns runs;
  for (const std::uint32_t tool : tools) runs.push_back({tool, {}, {}});
  ToolRun* before = nullptr;
  std::vector<Path> travels;  // with the wipes of plates
  for (Path& path : paths) {
    if (path.role == PathRole::Travel) {
      travels.push_back(std::move(path));
      continue;
    }
    const auto run = std::find_if(runs.begin(), runs.end(),
                                  [&path](const ToolRun& each) { return each.tool == path.tool; });
    if (&*run == before) std::move(travels.begin(), travels.end(), std::back_inserter(run->paths));
    travels.clear();
    run->paths.push_back(std::move(path));
    before = &*run;
  }
  return runs;
}

double purgeVolume(std::uint32_t from, std::uint32_t to, const ToolSettings& settings) {
  const std::vector<double>& volumes = settings.purge_mm3;
  if (volumes.empty()) return 0.0;
  if (volumes.size() == 1) return volumes.front();
  std::size_t count = 1;
  while (count * count < volumes.size()) ++count;
  return volumes[from * count + to];
}

bool purges(const ToolSettings& settings) {
  return std::any_of(settings.purge_mm3.begin(), settings.purge_mm3.end(),
                     [](double volume_mm3) { return volume_mm3 > 0.0; });
}

Box2 boxOf(const std::vector<ToolpathLayer>& layers) {
  Box2 box;
  for (const ToolpathLayer& layer : layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) box.include(point.head<2>());
  return box;
}

/// Adds paths one by one, each led to by a travel if it does not begin where the one before ended.
class LayerBuilder {
 public:
  LayerBuilder(std::size_t layer, const TravelMaker& travel, std::vector<Path>& paths)
      : layer_(layer), travel_(travel), paths_(paths) {}

  void add(Path path) {
    if (!paths_.empty() && path.role != PathRole::Travel && paths_.back().role != PathRole::Travel) {
      const bool changes = paths_.back().tool != path.tool;
      std::optional<Path> way = travel_(paths_.back(), path, layer_);
      if (!way && changes) way = upAndDown(path.firstPoint());
      if (way) {
        way->process.is_retracted |= changes;
        paths_.push_back(std::move(*way));
      }
    }
    paths_.push_back(std::move(path));
  }

 private:
  /// Where a tool goes on from where the one before ended.
  static Path upAndDown(const Point3& at) {
    Path way;
    way.role = PathRole::Travel;
    way.feed_mm_s = kLiftFeed;
    way.points = {at, at + kLift * Point3::UnitZ(), at};
    return way;
  }

  std::size_t layer_;
  const TravelMaker& travel_;
  std::vector<Path>& paths_;
};

/// What a layer lays into the tower.
struct TowerPlace {
  std::size_t level = 0;  ///< of the tower
  double z_mm = 0.0;      ///< where the nozzle is
  bool begins = true;     ///< no layer before it is of this level
};

/// The tower of layers: it stands on the bed and has no gaps, as a part has over a raft.
struct TowerLevels {
  std::vector<TowerPlace> of_layer;
  std::vector<double> heights_mm;
};

/// Parts of a plate may have layers that end within each other's, by their tops. Each ends a level of the
/// tower, as high as there is room above the one before; where that is less than half the lower of both
/// layers it lays into the one before, from its own top, so that the nozzle stays above all deposits.
TowerLevels towerLevels(const std::vector<ToolpathLayer>& layers) {
  constexpr double kLeastRise = 0.5;
  TowerLevels levels;
  double gaps_mm = 0.0;
  double top_mm = 0.0;  // of the last level
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const ToolpathLayer& layer = layers[l];
    const double gap_mm = l > 0 ? layer.z_mm - layer.height_mm - layers[l - 1].z_mm : 0.0;
    if (gap_mm > kNoGap) gaps_mm += gap_mm;
    const double z_mm = layer.z_mm - gaps_mm;
    const bool is_stacked = l == 0 || (gap_mm > -kNoGap && levels.of_layer.back().begins);
    const double rise_mm = is_stacked ? layer.height_mm : z_mm - top_mm;
    const double lower_mm = l > 0 ? std::min(layer.height_mm, layers[l - 1].height_mm) : layer.height_mm;
    const bool begins = is_stacked || rise_mm > kLeastRise * lower_mm - kNoGap;
    if (begins) {
      levels.heights_mm.push_back(rise_mm);
      top_mm = z_mm;
    }
    levels.of_layer.push_back({levels.heights_mm.size() - 1, z_mm, begins});
  }
  return levels;
}

/// Runs of layers that know their purges, and what each level asks of the tower.
struct PurgedRuns {
  std::vector<ToolRuns> runs;
  std::vector<TowerLayer> tower;
};

/// Plans the purges of one layer after the other.
class PurgePlanner {
 public:
  PurgePlanner(const ToolSettings& settings, const TowerLevels& levels) : settings_(settings) {
    for (const double height_mm : levels.heights_mm) planned_.tower.push_back({height_mm, {}});
  }

  void add(ToolRuns runs, std::size_t level) {
    std::vector<Purge>& purges = planned_.tower[level].purges;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::uint32_t tool = runs[r].tool;
      const std::uint32_t before = std::exchange(at_work_, tool).value_or(tool);
      if (before == tool) continue;
      double volume_mm3 = purgeVolume(before, tool, settings_);
      if (settings_.purge_into_infill) {
        runs = withInfillFirst(std::move(runs), r, volume_mm3);
        volume_mm3 -= leadingInfill(runs[r]);
        if (volume_mm3 <= kLeastPurge) continue;
      }
      runs[r].purge = purges.size();
      purges.push_back({tool, volume_mm3});
    }
    planned_.runs.push_back(std::move(runs));
  }

  PurgedRuns finish() && { return std::move(planned_); }

 private:
  const ToolSettings& settings_;
  std::optional<std::uint32_t> at_work_;
  PurgedRuns planned_;
};

/// Lays runs and tower of one layer after the other.
class LayerArrangement {
 public:
  LayerArrangement(const std::optional<PrimeTower>& tower, const TowerLevels& levels, std::uint32_t at_work,
                   const TravelMaker& travel)
      : tower_(tower), levels_(levels), at_work_(at_work), travel_(travel) {}

  std::vector<Path> build(std::size_t index, ToolRuns runs) {
    std::vector<Path> paths;
    LayerBuilder builder(index, travel_, paths);
    const TowerPlace& place = levels_.of_layer[index];
    const bool has_tower = tower_ && place.level < tower_->height();
    for (ToolRun& run : runs) {
      if (has_tower && run.purge)
        for (Path& path : tower_->purge(place.level, *run.purge, place.z_mm)) builder.add(std::move(path));
      for (Path& path : run.paths) builder.add(std::move(path));
      at_work_ = run.tool;
    }
    if (has_tower && place.begins && !tower_->purgesIn(place.level))
      for (Path& path : tower_->keep(place.level, at_work_, place.z_mm)) builder.add(std::move(path));
    return paths;
  }

 private:
  const std::optional<PrimeTower>& tower_;
  const TowerLevels& levels_;
  std::uint32_t at_work_;
  const TravelMaker& travel_;
};

}  // namespace

bool usesTools(const PlanSettings& settings) {
  const SupportSettings& supports = settings.supports;
  return assignsTools(settings.tools) || (supports.use && (supports.tool > 0 || supports.interface_tool > 0));
}

std::uint32_t toolOf(const Path& path, const ToolSettings& settings) {
  const bool is_support = path.role == PathRole::Support && settings.support < 0;
  const bool is_interface =
      path.role == PathRole::SupportInterface && settings.interface < 0 && settings.support < 0;
  if (path.tool > 0 && (is_support || is_interface)) return path.tool;
  return static_cast<std::uint32_t>(toolFor(path.role, settings));
}

std::uint32_t toolOf(PathRole role, const PlanSettings& settings) {
  Path path;
  path.role = role;
  if (role == PathRole::Support) path.tool = static_cast<std::uint32_t>(std::max(0, settings.supports.tool));
  if (role == PathRole::SupportInterface)
    path.tool = static_cast<std::uint32_t>(std::max(0, settings.supports.interface_tool));
  return toolOf(path, settings.tools);
}

std::vector<std::uint32_t> toolsAtWork(const PlanSettings& settings) {
  std::vector<std::uint32_t> tools;
  const auto add = [&](PathRole role) {
    const std::uint32_t tool = toolOf(role, settings);
    if (std::find(tools.begin(), tools.end(), tool) == tools.end()) tools.push_back(tool);
  };
  for (const PathRole role : {PathRole::OuterWall, PathRole::Infill, PathRole::Skin}) add(role);
  if (settings.adhesion.brim.width_mm > 0.0) add(PathRole::Brim);
  if (settings.adhesion.raft.layers > 0) add(PathRole::Raft);
  const SupportSettings& supports = settings.supports;
  if (!supports.use) return tools;
  add(PathRole::Support);
  if (supports.kind == SupportKind::Lattice && supports.interface_layers > 0) add(PathRole::SupportInterface);
  return tools;
}

void arrangeTools(std::vector<ToolpathLayer>& layers, const PlanSettings& settings,
                  const TravelMaker& travel) {
  const Box2 part = boxOf(layers);
  const std::uint32_t first = firstTool(layers);
  std::uint32_t at_work = first;
  const TowerLevels levels = towerLevels(layers);
  PurgePlanner planner(settings.tools, levels);
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const std::vector<std::uint32_t> tools = orderedTools(layers[l], at_work);
    planner.add(runsOf(std::move(layers[l].paths), tools), levels.of_layer[l].level);
    if (!tools.empty()) at_work = tools.back();
  }
  PurgedRuns purged = std::move(planner).finish();
  std::optional<PrimeTower> tower;
  if (purges(settings.tools) && !part.isEmpty()) tower.emplace(std::move(purged.tower), settings, part);
  LayerArrangement arrangement(tower, levels, first, travel);
  for (std::size_t l = 0; l < layers.size(); ++l)
    layers[l].paths = arrangement.build(l, std::move(purged.runs[l]));
}

void giveTravelsTools(std::vector<ToolpathLayer>& layers) {
  std::optional<std::uint32_t> tool;
  for (std::size_t l = layers.size(); l-- > 0;)
    for (std::size_t p = layers[l].paths.size(); p-- > 0;) {
      Path& path = layers[l].paths[p];
      if (path.role != PathRole::Travel) tool = path.tool;
      if (tool) path.tool = *tool;
    }
}

}  // namespace lamina
