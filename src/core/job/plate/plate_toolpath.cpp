// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/plate_toolpath.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/adhesion/prime_line.hpp"
#include "planning/run_path.hpp"
#include "planning/skirt.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {
namespace {

constexpr double kSameLayer = 1e-6;  // mm
constexpr double kBelowAll = -std::numeric_limits<double>::infinity();

/// A layer of one of the parts, or those of its paths that one tool runs.
struct LayerOfPart {
  std::size_t part = 0;
  const ToolpathLayer* layer = nullptr;
  double z_mm = 0.0;      ///< on the plate
  std::size_t begin = 0;  ///< of the paths
  std::size_t end = 0;    ///< one past the last
};

LayerOfPart wholeLayer(std::size_t part, const ToolpathLayer& layer, double z_mm) {
  return {part, &layer, z_mm, 0, layer.paths.size()};
}

/// The same tool by tool, in their order.
std::vector<LayerOfPart> byTools(const LayerOfPart& whole) {
  std::vector<LayerOfPart> runs;
  const std::vector<Path>& paths = whole.layer->paths;
  for (std::size_t p = whole.begin; p < whole.end; ++p) {
    if (runs.empty() || paths[p].tool != paths[p - 1].tool) {
      runs.push_back(whole);
      runs.back().begin = p;
    }
    runs.back().end = p + 1;
  }
  return runs;
}

/// Its paths, without the travel that led to them.
std::vector<Path> pathsOn(const LayerOfPart& of_part, const Point3& at) {
  const auto first = of_part.layer->paths.begin();
  auto begin = first + static_cast<std::ptrdiff_t>(of_part.begin);
  const auto end = first + static_cast<std::ptrdiff_t>(of_part.end);
  if (begin != end && begin->role == PathRole::Travel) ++begin;
  std::vector<Path> paths(begin, end);
  for (Path& path : paths)
    for (Point3& point : path.points) point += at;
  return paths;
}

/// Of the tool that goes on there, retracted if that is another one.
Path withTool(Path travel, const Path& from, const Path& to) {
  travel.tool = to.tool;
  travel.process.is_retracted |= from.tool != to.tool;
  return travel;
}

std::optional<Path> travelWithTool(const Path& from, const Path& to, const TravelSettings& settings) {
  std::optional<Path> travel = makeTravel(from.lastPoint(), to.firstPoint(), settings);
  if (travel) travel = withTool(std::move(*travel), from, to);
  return travel;
}

/// Puts layers of parts behind each other.
class PlateBuilder {
 public:
  PlateBuilder(const std::vector<PlateToolpath>& parts, const TravelSettings& travel)
      : parts_(parts), travel_(travel) {}

  void beginLayer(const LayerOfPart& like) {
    plate_.layers.emplace_back();
    plate_.layers.back().z_mm = like.z_mm;
    plate_.layers.back().height_mm = like.layer->height_mm;
  }

  void add(const LayerOfPart& added) {
    std::vector<Path> paths = pathsOn(added, parts_[added.part].at);
    if (paths.empty()) return;
    // Within its own box a part goes on below finished ones: the head is clear of them there.
    const double clear_mm = part_ == added.part ? kBelowAll : highest_mm_;
    mark(added.part, paths.front());
    std::vector<Path>& here = plate_.layers.back().paths;
    if (last_) {
      std::optional<Path> travel = travelTo(paths.front().firstPoint(), clear_mm);
      if (travel) here.push_back(withTool(std::move(*travel), last(), paths.front()));
    }
    std::move(paths.begin(), paths.end(), std::back_inserter(here));
    last_ = {plate_.layers.size() - 1, here.size() - 1};
    highest_mm_ = std::max(highest_mm_, added.z_mm);
  }

  /// Several layers of one height, tool by tool: the one at work first.
  void addByTools(const std::vector<LayerOfPart>& layers) {
    std::map<std::uint32_t, std::vector<LayerOfPart>> by_tool;
    for (const LayerOfPart& layer : layers)
      for (const LayerOfPart& run : byTools(layer)) by_tool[run.layer->paths[run.begin].tool].push_back(run);
    if (const auto at_work = last_ ? by_tool.find(last().tool) : by_tool.end(); at_work != by_tool.end())
      addNearest(std::exchange(at_work->second, {}));
    for (auto& [tool, runs] : by_tool) addNearest(std::move(runs));
  }

  Toolpath finish() && { return std::move(plate_); }

 private:
  Path& last() { return plate_.layers[last_->first].paths[last_->second]; }

  /// The nearest next.
  void addNearest(std::vector<LayerOfPart> layers) {
    while (!layers.empty()) {
      const auto next = std::min_element(
          layers.begin(), layers.end(),
          [this](const LayerOfPart& a, const LayerOfPart& b) { return wayTo(a) < wayTo(b); });
      const LayerOfPart added = *next;
      layers.erase(next);
      add(added);
    }
  }

  /// From where the nozzle is; none at the start, so that the first part given comes first.
  double wayTo(const LayerOfPart& next) {
    if (!last_) return 0.0;
    for (std::size_t p = next.begin; p < next.end; ++p)
      if (const Path& path = next.layer->paths[p]; path.role != PathRole::Travel)
        return (path.firstPoint() + parts_[next.part].at - last().lastPoint()).head<2>().norm();
    return 0.0;
  }

  void mark(std::size_t part, Path& first) {
    if (part_ == part) return;
    part_ = part;
    Path& before = last_ ? last() : first;
    PathEvent event;
    event.motion = last_ ? before.motionCount() : 0;
    event.event.emplace<PartMark>(PartMark{parts_[part].name});
    before.events.insert(last_ ? before.events.end() : before.events.begin(), std::move(event));
  }

  /// Not below that height, unless it ends there.
  std::optional<Path> travelTo(const Point3& to, double clear_mm) {
    const Point3 from = last().lastPoint();
    // Down again means over parts that are finished.
    if (to.z() >= clear_mm - kSameLayer) return makeTravel(from, to, travel_);
    const auto above = [clear_mm](const Point3& point) { return Point3(point.x(), point.y(), clear_mm); };
    std::optional<Path> travel = makeTravel(above(from), above(to), travel_);
    if (!travel) return makeTravel(from, to, travel_);
    travel->points.insert(travel->points.begin(), from);
    travel->points.push_back(to);
    travel->points.erase(std::unique(travel->points.begin(), travel->points.end()), travel->points.end());
    return travel;
  }

  const std::vector<PlateToolpath>& parts_;
  const TravelSettings& travel_;
  Toolpath plate_;
  std::optional<std::pair<std::size_t, std::size_t>> last_;  ///< layer and path
  std::optional<std::size_t> part_;
  double highest_mm_ = kBelowAll;  ///< inclined layers may lie below the origin of their frame
};

bool isBelow(const LayerOfPart& a, const LayerOfPart& b) {
  if (std::abs(a.z_mm - b.z_mm) > kSameLayer) return a.z_mm < b.z_mm;
  if (std::abs(a.layer->height_mm - b.layer->height_mm) > kSameLayer)
    return a.layer->height_mm < b.layer->height_mm;
  return a.part < b.part;
}

bool isSameLayer(const LayerOfPart& a, const LayerOfPart& b) {
  return std::abs(a.z_mm - b.z_mm) <= kSameLayer &&
         std::abs(a.layer->height_mm - b.layer->height_mm) <= kSameLayer;
}

/// Around the beads of the first layer in which each part has any.
Regions firstLayerHull(const std::vector<PlateToolpath>& parts) {
  std::vector<Point2> points;
  double width_mm = 0.0;
  for (const PlateToolpath& part : parts) {
    const auto& layers = part.toolpath->layers;
    const auto first =
        std::find_if(layers.begin(), layers.end(), [](const auto& l) { return !l.paths.empty(); });
    if (first == layers.end()) continue;
    for (const Path& path : first->paths) {
      if (path.role == PathRole::Travel) continue;
      width_mm = std::max(width_mm, path.bead.at(0).width_mm);
      for (const Point3& point : path.points) points.emplace_back((point + part.at).head<2>());
    }
  }
  const Polygon hull = convexHull(std::move(points));
  return hull.empty() ? Regions{} : offset({Region{hull, {}}}, 0.5 * width_mm);
}

/// Paths before the first layer of a plate, one after the other.
class PathsBefore {
 public:
  PathsBefore(const ToolpathLayer& layer, const PlanSettings& settings)
      : layer_(layer), settings_(settings) {}

  void add(const FillPath& run, const Bead& bead) {
    Path path = pathAlong(run, bead, layer_.z_mm,
                          std::min(settings_.feed.skirt_mm_s, settings_.feed.first_layer_mm_s));
    path.tool = toolOf(path, settings_.tools);
    if (!paths_.empty())
      if (auto travel = travelWithTool(paths_.back(), path, settings_.travel))
        paths_.push_back(std::move(*travel));
    paths_.push_back(std::move(path));
  }

  void layBefore(ToolpathLayer& layer) && {
    if (paths_.empty()) return;
    if (!layer.paths.empty()) {
      Path& first = layer.paths.front();
      // The part, whose mark is the first event, begins with the way to it.
      first.events.front().motion = paths_.back().motionCount();
      paths_.back().events.push_back(std::move(first.events.front()));
      first.events.erase(first.events.begin());
      if (auto travel = travelWithTool(paths_.back(), first, settings_.travel))
        paths_.push_back(std::move(*travel));
    }
    layer.paths.insert(layer.paths.begin(), std::make_move_iterator(paths_.begin()),
                       std::make_move_iterator(paths_.end()));
  }

 private:
  const ToolpathLayer& layer_;
  const PlanSettings& settings_;
  std::vector<Path> paths_;
};

}  // namespace

Toolpath mergedByLayer(const std::vector<PlateToolpath>& parts, const TravelSettings& travel) {
  std::vector<LayerOfPart> layers;
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (const ToolpathLayer& layer : parts[part].toolpath->layers)
      layers.push_back(wholeLayer(part, layer, layer.z_mm + parts[part].at.z()));
  std::stable_sort(layers.begin(), layers.end(), isBelow);
  PlateBuilder builder(parts, travel);
  for (auto begin = layers.begin(); begin != layers.end();) {
    const auto end = std::find_if(begin, layers.end(),
                                  [&](const LayerOfPart& other) { return !isSameLayer(other, *begin); });
    builder.beginLayer(*begin);
    builder.addByTools({begin, end});
    begin = end;
  }
  return std::move(builder).finish();
}

Toolpath partAfterPart(const std::vector<PlateToolpath>& parts, const std::vector<std::size_t>& order,
                       const TravelSettings& travel) {
  PlateBuilder builder(parts, travel);
  for (const std::size_t part : order)
    for (const ToolpathLayer& layer : parts[part].toolpath->layers) {
      const LayerOfPart next = wholeLayer(part, layer, layer.z_mm + parts[part].at.z());
      builder.beginLayer(next);
      builder.add(next);
    }
  return std::move(builder).finish();
}

void addRoundParts(Toolpath& plate, const std::vector<PlateToolpath>& parts, const PlanSettings& settings,
                   const Box2& bed) {
  if (plate.layers.empty()) return;
  ToolpathLayer& layer = plate.layers.front();
  const Regions hull = firstLayerHull(parts);
  const std::vector<Polygon> loops =
      settings.skirt.count > 0 ? makeSkirt(hull, settings) : std::vector<Polygon>();
  PathsBefore before(layer, settings);
  const double width_mm = settings.bead.width_mm;
  if (settings.adhesion.prime.line != PrimeLine::None) {
    const Regions occupied = loops.empty() ? hull : offset({{loops.front(), {}}}, 0.5 * width_mm);
    const AidRuns line =
        makePrimeLine(settings.adhesion.prime, {layer.z_mm - layer.height_mm, layer.z_mm}, bed, occupied);
    for (const FillPath& run : *line.runs) before.add(run, line.bead);
  }
  for (const Polygon& loop : loops)
    before.add({loop, true, PathRole::Skirt, Deposit::Bead, {}}, Bead{width_mm, layer.height_mm});
  std::move(before).layBefore(layer);
}

}  // namespace lamina
