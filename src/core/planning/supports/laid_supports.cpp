// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/laid_supports.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/polygon/inside.hpp"
#include "planning/deposited_runs.hpp"
#include "planning/order/ordering.hpp"
#include "planning/role_feed.hpp"
#include "planning/run_path.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/travel.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kSameTop = 1e-9;  // mm

/// Groups of a layer whose runs may lie in any order.
using SupportBatch = std::vector<const AidRuns*>;

std::vector<SupportBatch> batchesOf(const LayerAids& aids) {
  std::vector<SupportBatch> batches;
  for (const AidRuns& group : aids) {
    if (!isSupport(group)) continue;
    const bool goes_on = !batches.empty() && batches.back().front()->tool == group.tool &&
                         std::abs(batches.back().front()->top_mm - group.top_mm) < kSameTop;
    if (!goes_on) batches.emplace_back();
    batches.back().push_back(&group);
  }
  return batches;
}

/// The loop from the corner by which the way from one place to another is shortest.
Polyline begunBetween(Polyline loop, const Point2& from, const std::optional<Point2>& to) {
  const auto way = [&](const Point2& corner) {
    return (corner - from).norm() + (to ? (*to - corner).norm() : 0.0);
  };
  const auto nearest = std::min_element(loop.begin(), loop.end(),
                                        [&](const Point2& a, const Point2& b) { return way(a) < way(b); });
  std::rotate(loop.begin(), nearest, loop.end());
  return loop;
}

/// Lays the supports of one layer.
class SupportLayer {
 public:
  SupportLayer(const SupportLaying& laying, std::size_t index, std::vector<Path>& paths)
      : laying_(laying),
        settings_(index == 0 ? laying.on_bed : laying.settings),
        index_(index),
        paths_(paths) {}

  /// @param from  where the nozzle is
  /// @param to    where it goes on after the last batch
  void add(const SupportBatch& batch, const Point2& from, const std::optional<Point2>& to) {
    std::vector<FillPath> runs;
    std::vector<const AidRuns*> groups;
    for (const AidRuns* group : batch) {
      runs.insert(runs.end(), group->runs->begin(), group->runs->end());
      groups.resize(runs.size(), group);
    }
    const std::vector<OrderedRun> order = orderRuns(endsOf(runs), from, to);
    Point2 nozzle = from;
    for (std::size_t i = 0; i < order.size(); ++i) {
      FillPath run = std::move(runs[order[i].run]);
      if (order[i].is_reversed) run = reversed(std::move(run));
      const std::optional<Point2> next =
          i + 1 < order.size() ? std::optional(startOf(runs[order[i + 1].run], order[i + 1])) : to;
      if (run.is_closed) run.points = begunBetween(std::move(run.points), nozzle, next);
      add(run, *groups[order[i].run], nozzle);
      nozzle = paths_.back().lastPoint().head<2>();
    }
  }

 private:
  static const Point2& startOf(const FillPath& run, const OrderedRun& ordered) {
    return ordered.is_reversed ? lastPoint(run) : run.points.front();
  }

  void add(const FillPath& run, const AidRuns& group, const Point2& nozzle) {
    Path path = pathAlong(run, group.bead, group.top_mm, feedIn(settings_.feed, run.role, index_));
    if (index_ == 0) path = withFlow(std::move(path), settings_.first_layer.flow);
    path.tool = group.tool;
    path.tool = toolOf(path, settings_.tools);
    if (!paths_.empty()) {
      const bool is_inside = group.area && staysInside(*group.area, nozzle, run.points.front());
      std::optional<Path> travel = makeTravel(paths_.back().lastPoint(), path.firstPoint(), laying_.travel,
                                              is_inside ? TravelOver::Infill : TravelOver::Anything);
      if (travel) paths_.push_back(std::move(*travel));
    }
    paths_.push_back(std::move(path));
  }

  const SupportLaying& laying_;
  const PlanSettings& settings_;
  std::size_t index_;
  std::vector<Path>& paths_;
};

/// @param nozzle  where it is before the layer
std::vector<Path> withSupports(std::vector<Path> paths, const std::vector<SupportBatch>& batches,
                               const SupportLaying& laying, std::size_t index, const Point2& nozzle) {
  const auto islands = std::find_if(paths.begin(), paths.end(), isPartOfPart);
  std::vector<Path> laid(std::make_move_iterator(paths.begin()), std::make_move_iterator(islands));
  if (!laid.empty() && laid.back().role == PathRole::Travel) laid.pop_back();
  std::optional<Point2> goal;
  if (islands != paths.end()) goal = islands->firstPoint().head<2>();
  SupportLayer layer(laying, index, laid);
  for (const SupportBatch& batch : batches) {
    const Point2 from = laid.empty() ? nozzle : Point2(laid.back().lastPoint().head<2>());
    layer.add(batch, from, &batch == &batches.back() ? goal : std::nullopt);
  }
  if (islands == paths.end()) return laid;
  std::optional<Path> travel =
      makeTravel(laid.back().lastPoint(), islands->firstPoint(), laying.travel, TravelOver::Anything);
  if (travel) laid.push_back(std::move(*travel));
  laid.insert(laid.end(), std::make_move_iterator(islands), std::make_move_iterator(paths.end()));
  return laid;
}

}  // namespace

bool isSupport(const AidRuns& aids) {
  if (aids.runs->empty()) return false;
  const PathRole role = aids.runs->front().role;
  return role == PathRole::Support || role == PathRole::SupportInterface;
}

void laySupports(std::vector<ToolpathLayer>& layers, const std::vector<LayerAids>& aids,
                 const SupportLaying& laying) {
  Point2 nozzle = laying.from;
  for (std::size_t i = 0; i < layers.size() && i < aids.size(); ++i) {
    const std::vector<SupportBatch> batches = batchesOf(aids[i]);
    std::vector<Path>& paths = layers[i].paths;
    if (!batches.empty()) paths = withSupports(std::move(paths), batches, laying, i, nozzle);
    if (!paths.empty()) nozzle = paths.back().lastPoint().head<2>();
  }
}

}  // namespace lamina
