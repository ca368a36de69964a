// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/place_interval.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/timing.hpp"
#include "planning/cooling/parking.hpp"
#include "planning/cooling/place_order.hpp"
#include "planning/travel/wipes.hpp"

namespace lamina {
namespace {

constexpr double kJoined = 1e-6;  // mm

/// A visit and how long it takes, without the way there [s].
struct TimedVisit {
  std::vector<Path> way;
  std::vector<Path> paths;
  double duration_s = 0.0;
};

/// A layer in pieces that can be put in another order.
struct LayerPieces {
  std::vector<DepositedPlace> places;
  std::vector<TimedVisit> visits;
  std::vector<std::size_t> place_of;  ///< of visits; the number of places for those at none
  std::vector<Path> rest;             ///< travels behind the last visit
  double travel_feed_mm_s = 0.0;
  bool is_free = false;  ///< its paths may come in another order
};

/// @param paths  stay as they are
double durationOf(std::vector<Path>& paths, const MotionLimits& limits) {
  Toolpath alone;
  alone.layers.resize(1);
  alone.layers.front().paths.swap(paths);
  const double duration_s = estimateTime(alone, limits).total_s;
  alone.layers.front().paths.swap(paths);
  return duration_s;
}

/// The number of places for those at none.
std::vector<std::size_t> placesOfVisits(const PlacedLayer& placed) {
  std::vector<std::size_t> place_of(placed.visits.size(), placed.places.size());
  for (std::size_t p = 0; p < placed.places.size(); ++p)
    for (const std::size_t visit : placed.places[p].visits) place_of[visit] = p;
  return place_of;
}

/// Whether the paths of a layer may come in another order.
bool isFree(const ToolpathLayer& layer) {
  const auto hinders = [&layer](const Path& path) {
    return !path.events.empty() || path.tool != layer.paths.front().tool;
  };
  return std::none_of(layer.paths.begin(), layer.paths.end(), hinders);
}

class PlaceCooler {
 public:
  PlaceCooler(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits)
      : toolpath_(toolpath),
        settings_(settings),
        limits_(limits),
        grounds_(parkingGrounds(toolpath)),
        may_reorder_(hasPlaneLayers(toolpath)) {}

  CoolingSummary run(Progress& progress) {
    std::vector<LayerPieces> layers(toolpath_.layers.size());
    parallelFor(
        layers.size(),
        [&](std::size_t l) {
          if (!toolpath_.layers[l].paths.empty()) layers[l] = takenApart(l);
        },
        progress, "cool");
    for (std::size_t l = 0; l < layers.size(); ++l)
      if (!layers[l].visits.empty() || !layers[l].rest.empty()) layLayer(l, layers[l]);
    return summary_;
  }

 private:
  /// Takes the paths of a layer.
  LayerPieces takenApart(std::size_t index) const {
    ToolpathLayer& layer = toolpath_.layers[index];
    LayerPieces pieces;
    pieces.travel_feed_mm_s = grounds_[index].travel_mm_s;
    pieces.is_free = may_reorder_ && isFree(layer);
    PlacedLayer placed = placesOf(layer, toolpath_.part_from_layers.conjugate());
    pieces.place_of = placesOfVisits(placed);
    pieces.places = std::move(placed.places);
    const auto taken = [&layer](std::size_t begin, std::size_t end) {
      const auto first = std::make_move_iterator(layer.paths.begin());
      return std::vector<Path>(first + static_cast<std::ptrdiff_t>(begin),
                               first + static_cast<std::ptrdiff_t>(end));
    };
    std::size_t end = 0;
    for (const PlaceVisit& visit : placed.visits) {
      pieces.visits.push_back({taken(visit.begin, visit.first), taken(visit.first, visit.end), 0.0});
      pieces.visits.back().duration_s = durationOf(pieces.visits.back().paths, limits_);
      end = visit.end;
    }
    pieces.rest = taken(end, layer.paths.size());
    layer.paths.clear();
    return pieces;
  }

  void layLayer(std::size_t index, LayerPieces& pieces) {
    std::vector<double> ready_s;
    ready_s.reserve(pieces.places.size());
    for (const DepositedPlace& place : pieces.places)
      ready_s.push_back(leftBelow(place.box, left_) + settings_.least_layer_time_s);
    const std::vector<std::size_t> order = visitOrder(pieces, ready_s);
    if (!std::is_sorted(order.begin(), order.end())) {
      ++summary_.reordered_layers;
      if (order.back() + 1 != pieces.visits.size()) pieces.rest.clear();
    }
    forgetCooled();
    const std::size_t first = left_.boxes.size();
    for (const DepositedPlace& place : pieces.places) left_.boxes.push_back(place.box);
    left_.left_s.resize(left_.boxes.size(), 0.0);
    std::vector<bool> is_begun(pieces.places.size() + 1, false);
    is_begun.back() = true;  // what is at no place waits for none
    for (const std::size_t v : order) {
      const std::size_t place = pieces.place_of[v];
      goTo(pieces.visits[v], index, pieces.travel_feed_mm_s);
      if (!is_begun[place]) waitUntil(ready_s[place], index, pieces.travel_feed_mm_s, pieces.visits[v]);
      is_begun[place] = true;
      lay(pieces.visits[v], toolpath_.layers[index]);
      if (place < pieces.places.size()) left_.left_s[first + place] = now_s_;
    }
    layRest(pieces, index);
  }

  /// What is cool by now, which nothing waits for.
  void forgetCooled() {
    PlaceTimes kept;
    for (std::size_t i = 0; i < left_.boxes.size(); ++i) {
      if (left_.left_s[i] + settings_.least_layer_time_s <= now_s_) continue;
      kept.boxes.push_back(left_.boxes[i]);
      kept.left_s.push_back(left_.left_s[i]);
    }
    left_ = std::move(kept);
  }

  void goTo(TimedVisit& visit, std::size_t index, double feed_mm_s) {
    if (!beginsHere(visit.way.empty() ? visit.paths : visit.way))
      visit.way = wayTo(visit.paths.front(), index, feed_mm_s);
    now_s_ += durationOf(visit.way, limits_);
  }

  void lay(TimedVisit& visit, ToolpathLayer& layer) {
    add(layer.paths, visit.way);
    add(layer.paths, visit.paths);
    now_s_ += visit.duration_s;
    last_ = &layer;
  }

  void layRest(LayerPieces& pieces, std::size_t index) {
    ToolpathLayer& layer = toolpath_.layers[index];
    if (pieces.rest.empty()) return;
    if (!beginsHere(pieces.rest)) {
      std::vector<Path> way = wayTo(pieces.rest.front(), index, pieces.travel_feed_mm_s);
      add(layer.paths, way);
    }
    now_s_ += durationOf(pieces.rest, limits_);
    add(layer.paths, pieces.rest);
    last_ = &layer;
  }

  /// Places whose ground was left first come first; visits of a place keep together then.
  static std::vector<std::size_t> visitOrder(const LayerPieces& pieces, const std::vector<double>& ready_s) {
    std::vector<std::size_t> as_planned(pieces.visits.size());
    std::iota(as_planned.begin(), as_planned.end(), std::size_t{0});
    const bool is_sorted = std::is_sorted(ready_s.begin(), ready_s.end());
    if (!pieces.is_free || is_sorted || hasMoreThanWipe(pieces)) return as_planned;
    std::vector<std::size_t> rank(ready_s.size() + 1);
    std::vector<std::size_t> sorted(ready_s.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&ready_s](std::size_t a, std::size_t b) { return ready_s[a] < ready_s[b]; });
    // Build aids, which are at no place, come first.
    for (std::size_t r = 0; r < sorted.size(); ++r) rank[sorted[r]] = r + 1;
    rank.back() = 0;
    std::stable_sort(as_planned.begin(), as_planned.end(), [&](std::size_t a, std::size_t b) {
      return rank[pieces.place_of[a]] < rank[pieces.place_of[b]];
    });
    return as_planned;
  }

  /// Whether more than a wipe follows the last visit.
  static bool hasMoreThanWipe(const LayerPieces& pieces) {
    if (pieces.rest.empty()) return false;
    const bool wipes = pieces.rest.size() == 1 && !pieces.visits.empty() &&
                       isWipeAlong(pieces.visits.back().paths.back(), pieces.rest.front());
    return !wipes;
  }

  /// Not so where the order of what came before has changed.
  bool beginsHere(const std::vector<Path>& paths) const {
    return last_ == nullptr ||
           (paths.front().firstPoint() - last_->paths.back().lastPoint()).norm() < kJoined;
  }

  /// Retracted, lifted as for waiting.
  std::vector<Path> wayTo(const Path& next, std::size_t index, double feed_mm_s) const {
    const Path& at = last_->paths.back();
    const Point3 from = at.lastPoint();
    const Point3 to = next.firstPoint();
    if (from == to) return {};
    const Point3& up = grounds_[index].up;
    const double top_mm =
        std::max({from.dot(up), to.dot(up), grounds_[index].highest_mm}) + settings_.lift_mm;
    Path way;
    way.role = PathRole::Travel;
    way.process.is_retracted = true;
    way.tool = next.tool;
    way.orientation = next.orientation.at(0);
    way.feed_mm_s = feed_mm_s;
    for (const Point3& point :
         {from, Point3(from + (top_mm - from.dot(up)) * up), Point3(to + (top_mm - to.dot(up)) * up), to})
      if (way.points.empty() || way.points.back() != point) way.points.push_back(point);
    return {std::move(way)};
  }

  /// At the end of what was deposited before; the ways there and on count.
  void waitUntil(double ready_s, std::size_t index, double feed_mm_s, TimedVisit& visit) {
    const double lacking_s = ready_s - now_s_;
    if (last_ == nullptr || !(lacking_s > 0.0)) return;
    const Path& at = last_->paths.back();
    std::vector<Path> waits = {
        parkedWait(at, at.is_closed ? 0 : at.points.size() - 1, feed_mm_s, grounds_[index], settings_)};
    const double ways_s = durationOf(waits, limits_);
    std::get<Dwell>(waits.front().events.front().event).duration_s = std::max(0.0, lacking_s - ways_s);
    now_s_ += durationOf(waits, limits_);
    leadOn(waits.front(), visit.way, visit.paths.front(), grounds_[index], limits_);
    const double dwell_s = std::get<Dwell>(waits.front().events.front().event).duration_s;
    add(last_->paths, waits);
    summary_.dwells += dwell_s > 0.0 ? 1 : 0;
    summary_.dwell_s += dwell_s;
  }

  static void add(std::vector<Path>& all, std::vector<Path>& more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }

  Toolpath& toolpath_;
  const CoolingSettings& settings_;
  MotionLimits limits_;
  std::vector<ParkingGround> grounds_;  ///< by layer
  bool may_reorder_;
  CoolingSummary summary_;
  PlaceTimes left_;                ///< of what may still be deposited over
  ToolpathLayer* last_ = nullptr;  ///< whose last path the nozzle stands at the end of
  double now_s_ = 0.0;
};

}  // namespace

CoolingSummary leavePlacesAlone(Toolpath& toolpath, const CoolingSettings& settings,
                                const MotionLimits& limits, Progress& progress) {
  return PlaceCooler(toolpath, settings, limits).run(progress);
}

}  // namespace lamina
