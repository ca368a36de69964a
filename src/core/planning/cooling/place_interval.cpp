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
  PlacedLayer placed;
  std::vector<TimedVisit> visits;
  std::vector<Path> rest;  ///< travels behind the last visit
};

double durationOf(std::vector<Path> paths, const MotionLimits& limits) {
  Toolpath alone;
  alone.layers = {{0.0, 0.0, std::move(paths)}};
  return estimateTime(alone, limits).total_s;
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
        ground_{depositionBox(toolpath), layerNormal(toolpath)},
        heights_(heightsUpTo(toolpath, ground_.up)),
        may_reorder_(hasPlaneLayers(toolpath)) {}

  CoolingSummary run(Progress& progress) {
    std::vector<LayerPieces> layers(toolpath_.layers.size());
    parallelFor(
        layers.size(), [&](std::size_t l) { layers[l] = piecesOf(toolpath_.layers[l]); }, progress, "cool");
    for (std::size_t l = 0; l < layers.size(); ++l)
      if (!toolpath_.layers[l].paths.empty()) layLayer(l, layers[l]);
    return summary_;
  }

 private:
  LayerPieces piecesOf(const ToolpathLayer& layer) const {
    LayerPieces pieces;
    pieces.placed = placesOf(layer, toolpath_.part_from_layers.conjugate());
    const auto at = [&layer](std::size_t i) { return layer.paths.begin() + static_cast<std::ptrdiff_t>(i); };
    std::size_t end = 0;
    for (const PlaceVisit& visit : pieces.placed.visits) {
      TimedVisit timed{{at(visit.begin), at(visit.first)}, {at(visit.first), at(visit.end)}, 0.0};
      timed.duration_s = durationOf(timed.paths, limits_);
      pieces.visits.push_back(std::move(timed));
      end = visit.end;
    }
    pieces.rest.assign(at(end), layer.paths.end());
    return pieces;
  }

  void layLayer(std::size_t index, LayerPieces& pieces) {
    ToolpathLayer& layer = toolpath_.layers[index];
    const double feed_mm_s = travelFeed(layer);
    const std::vector<LaidPlace>& places = pieces.placed.places;
    std::vector<double> ready_s;
    ready_s.reserve(places.size());
    for (const LaidPlace& place : places)
      ready_s.push_back(leftBeneath(place.box, below_) + settings_.least_layer_time_s);
    const std::vector<std::size_t> order = visitOrder(pieces, ready_s, may_reorder_ && isFree(layer));
    const bool is_as_planned = std::is_sorted(order.begin(), order.end());
    if (!is_as_planned) ++summary_.reordered_layers;
    below_ = {};
    below_.boxes.reserve(places.size());
    for (const LaidPlace& place : places) below_.boxes.push_back(place.box);
    below_.left_s.assign(places.size(), 0.0);
    const std::vector<std::size_t> place_of = placeOfVisits(pieces);
    layer.paths.clear();
    for (const std::size_t v : order) {
      TimedVisit& visit = pieces.visits[v];
      if (!beginsHere(visit.way.empty() ? visit.paths : visit.way))
        visit.way = wayTo(visit.paths.front(), index, feed_mm_s);
      now_s_ += durationOf(visit.way, limits_);
      const std::size_t place = place_of[v];
      const bool is_begin = place < places.size() && v == places[place].visits.front();
      if (is_begin) waitUntil(ready_s[place], index, feed_mm_s);
      add(layer.paths, visit.way);
      add(layer.paths, visit.paths);
      now_s_ += visit.duration_s;
      if (place < places.size()) below_.left_s[place] = now_s_;
      last_ = &layer;
    }
    if (!pieces.rest.empty() && !beginsHere(pieces.rest)) {
      std::vector<Path> way = wayTo(pieces.rest.front(), index, feed_mm_s);
      add(layer.paths, way);
    }
    now_s_ += durationOf(pieces.rest, limits_);
    add(layer.paths, pieces.rest);
    last_ = &layer;
  }

  /// Places whose ground was left first come first; visits of a place keep together then.
  static std::vector<std::size_t> visitOrder(const LayerPieces& pieces, const std::vector<double>& ready_s,
                                             bool may_reorder) {
    std::vector<std::size_t> as_planned(pieces.visits.size());
    std::iota(as_planned.begin(), as_planned.end(), std::size_t{0});
    const bool is_sorted = std::is_sorted(ready_s.begin(), ready_s.end());
    if (!may_reorder || is_sorted || !pieces.rest.empty()) return as_planned;
    const std::vector<std::size_t> place_of = placeOfVisits(pieces);
    std::vector<std::size_t> rank(ready_s.size() + 1);
    std::vector<std::size_t> sorted(ready_s.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&ready_s](std::size_t a, std::size_t b) { return ready_s[a] < ready_s[b]; });
    // Build aids, which are at no place, come first.
    for (std::size_t r = 0; r < sorted.size(); ++r) rank[sorted[r]] = r + 1;
    rank.back() = 0;
    std::stable_sort(as_planned.begin(), as_planned.end(),
                     [&](std::size_t a, std::size_t b) { return rank[place_of[a]] < rank[place_of[b]]; });
    return as_planned;
  }

  /// The number of places for those at none.
  static std::vector<std::size_t> placeOfVisits(const LayerPieces& pieces) {
    std::vector<std::size_t> place_of(pieces.visits.size(), pieces.placed.places.size());
    for (std::size_t p = 0; p < pieces.placed.places.size(); ++p)
      for (const std::size_t visit : pieces.placed.places[p].visits) place_of[visit] = p;
    return place_of;
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
    const double level_mm = std::max(from.dot(ground_.up), to.dot(ground_.up));
    const double top_mm = std::max(level_mm, heights_[index]) + settings_.lift_mm;
    Path way;
    way.role = PathRole::Travel;
    way.process.is_retracted = true;
    way.tool = next.tool;
    way.orientation = next.orientation.at(0);
    way.feed_mm_s = feed_mm_s;
    for (const Point3& point : {from, Point3(from + (top_mm - from.dot(ground_.up)) * ground_.up),
                                Point3(to + (top_mm - to.dot(ground_.up)) * ground_.up), to})
      if (way.points.empty() || way.points.back() != point) way.points.push_back(point);
    return {std::move(way)};
  }

  /// At the end of what was laid before; the ways there and back count.
  void waitUntil(double ready_s, std::size_t index, double feed_mm_s) {
    const double lacking_s = ready_s - now_s_;
    if (last_ == nullptr || !(lacking_s > 0.0)) return;
    const Path& at = last_->paths.back();
    ParkingGround ground = ground_;
    ground.highest_mm = heights_[index];
    Path wait = parkedWait(at, at.is_closed ? 0 : at.points.size() - 1, feed_mm_s, ground, settings_);
    const double dwell_s = std::max(0.0, lacking_s - durationOf({wait}, limits_));
    std::get<Dwell>(wait.events.front().event).duration_s = dwell_s;
    now_s_ += durationOf({wait}, limits_);
    last_->paths.push_back(std::move(wait));
    ++summary_.dwells;
    summary_.dwell_s += dwell_s;
  }

  static void add(std::vector<Path>& all, std::vector<Path>& more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }

  Toolpath& toolpath_;
  const CoolingSettings& settings_;
  MotionLimits limits_;
  ParkingGround ground_;
  std::vector<double> heights_;  ///< of what is deposited up to and with each layer
  bool may_reorder_;
  CoolingSummary summary_;
  PlaceTimes below_;               ///< of the last layer that deposits
  ToolpathLayer* last_ = nullptr;  ///< whose last path the nozzle stands at the end of
  double now_s_ = 0.0;
};

}  // namespace

CoolingSummary leavePlacesAlone(Toolpath& toolpath, const CoolingSettings& settings,
                                const MotionLimits& limits, Progress& progress) {
  return PlaceCooler(toolpath, settings, limits).run(progress);
}

}  // namespace lamina
