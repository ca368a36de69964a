// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_order.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "planning/tools/prime_tower.hpp"

namespace lamina {
namespace {

/// Paths of one tool, with the travels that led to them.
struct ToolRun {
  std::uint32_t tool = 0;
  std::vector<Path> paths;
};

/// A layer by tools, in the order in which they come.
using ToolRuns = std::vector<ToolRun>;

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
  for (const std::uint32_t tool : tools) runs.push_back({tool, {}});
  ToolRun* before = nullptr;
  std::optional<Path> travel;
  for (Path& path : paths) {
    if (path.role == PathRole::Travel) {
      travel = std::move(path);
      continue;
    }
    const auto run = std::find_if(runs.begin(), runs.end(),
                                  [&path](const ToolRun& each) { return each.tool == path.tool; });
    if (travel && &*run == before) run->paths.push_back(std::move(*travel));
    travel.reset();
    run->paths.push_back(std::move(path));
    before = &*run;
  }
  return runs;
}

/// Supports that `supports.*` gave a tool keep it, unless `tool.*` names another.
std::uint32_t toolOf(const Path& path, const ToolSettings& settings) {
  const bool is_support = path.role == PathRole::Support && settings.support < 0;
  const bool is_interface =
      path.role == PathRole::SupportInterface && settings.interface < 0 && settings.support < 0;
  if (path.tool > 0 && (is_support || is_interface)) return path.tool;
  return static_cast<std::uint32_t>(toolFor(path.role, settings));
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
      std::optional<Path> way = travel_(paths_.back(), path, layer_);
      if (way) {
        way->process.is_retracted |= paths_.back().tool != path.tool;
        paths_.push_back(std::move(*way));
      }
    }
    paths_.push_back(std::move(path));
  }

 private:
  std::size_t layer_;
  const TravelMaker& travel_;
  std::vector<Path>& paths_;
};

/// What each layer asks of the tower.
std::vector<TowerLayer> towerLayers(const std::vector<ToolpathLayer>& layers,
                                    const std::vector<ToolRuns>& runs, const ToolSettings& settings) {
  std::vector<TowerLayer> tower(layers.size());
  for (std::size_t l = 0; l < layers.size(); ++l) {
    tower[l].height_mm = layers[l].height_mm;
    for (std::size_t r = 1; r < runs[l].size(); ++r)
      tower[l].purges.push_back(
          {runs[l][r].tool, purgeVolume(runs[l][r - 1].tool, runs[l][r].tool, settings)});
  }
  return tower;
}

void build(ToolpathLayer& layer, std::size_t index, ToolRuns runs, const std::optional<PrimeTower>& tower,
           const TravelMaker& travel) {
  layer.paths.clear();
  LayerBuilder builder(index, travel, layer.paths);
  const bool has_tower = tower && index < tower->height() && !runs.empty();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (has_tower && r > 0)
      for (Path& path : tower->purge(index, r - 1, layer.z_mm)) builder.add(std::move(path));
    for (Path& path : runs[r].paths) builder.add(std::move(path));
  }
  if (has_tower && runs.size() == 1)
    for (Path& path : tower->keep(index, runs[0].tool, layer.z_mm)) builder.add(std::move(path));
}

}  // namespace

void arrangeTools(std::vector<ToolpathLayer>& layers, const PlanSettings& settings,
                  const TravelMaker& travel) {
  const Box2 part = boxOf(layers);
  std::vector<ToolRuns> runs(layers.size());
  std::optional<std::uint32_t> at_work;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    std::vector<Path>& paths = layers[l].paths;
    for (Path& path : paths) {
      if (path.role == PathRole::Travel) continue;
      path.tool = toolOf(path, settings.tools);
      if (!at_work) at_work = path.tool;
    }
    const std::vector<std::uint32_t> tools = orderedTools(layers[l], at_work.value_or(0));
    runs[l] = runsOf(std::move(paths), tools);
    if (!tools.empty()) at_work = tools.back();
  }
  std::optional<PrimeTower> tower;
  if (purges(settings.tools) && !part.isEmpty())
    tower.emplace(towerLayers(layers, runs, settings.tools), settings, part);
  for (std::size_t l = 0; l < layers.size(); ++l) build(layers[l], l, std::move(runs[l]), tower, travel);
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
