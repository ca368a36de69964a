// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/layer_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planning/nozzle_frame.hpp"
#include "planning/travel/space_travel.hpp"
#include "planning/walls/opened_loop.hpp"

namespace lamina {
namespace {

/// Of a joined loop, in pitches, left out at its end: its two round ends leave corners open, and come so much
/// nearer to each other.
constexpr double kLeftOut = 0.9;

/// Of its width, how far a rising bead may stick out of the section: as much as outlines of one upright wall
/// differ from layer to layer, each simplified by itself.
constexpr double kMostOutside = 0.05;

double squaredDistance(const Point2& point, const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const double squared = along.squaredNorm();
  const double part = squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (from + part * along - point).squaredNorm();
}

/// Whether a bead that begins at a place lies in the section with all its width.
bool hasRoomFor(const Section& section, const Point2& place, double width_mm) {
  if (!contains(section.contours, place)) return false;
  const double needed = (0.5 - kMostOutside) * width_mm;
  for (const Polygon& contour : section.contours)
    for (std::size_t i = 0; i < contour.size(); ++i)
      if (squaredDistance(place, contour[i], contour[(i + 1) % contour.size()]) < needed * needed)
        return false;
  return true;
}

/// Of each motion that comes that near to a point: where it does so, first, in the middle and last.
std::vector<JoinedLoopPlace> placesAround(const Path& joined_loop, const Point3& point, double reach_mm) {
  std::vector<JoinedLoopPlace> places;
  places.reserve(joined_loop.motionCount());
  for (std::size_t motion = 0; motion < joined_loop.motionCount(); ++motion) {
    const Point3& from = joined_loop.points[motion];
    const Point3 along = joined_loop.points[joined_loop.motionEnd(motion)] - from;
    const double squared = along.squaredNorm();
    if (squared <= 0.0) continue;
    const double middle = (point - from).dot(along) / squared;
    const double room = reach_mm * reach_mm - (from + middle * along - point).squaredNorm();
    if (room <= 0.0) continue;
    const double half = std::sqrt(room / squared);
    const double first = std::max(middle - half, 0.0);
    const double last = std::min(middle + half, 1.0);
    if (first > last) continue;
    for (const double part : {first, 0.5 * (first + last), last})
      places.push_back({motion, part, from + part * along});
  }
  return places;
}

bool isJoinedLoop(const Path& path, double pitch) {
  return path.is_closed && path.role == PathRole::Infill && path.deposit == Deposit::Bead &&
         length(path) > 2.0 * pitch;
}

class LayerChain {
 public:
  LayerChain(std::vector<ToolpathLayer>& layers, const std::vector<Layer>& sections,
             const PlanSettings& settings, const Point3& anchor, const TravelMaker& travel)
      : layers_(layers),
        sections_(sections),
        settings_(settings),
        travel_(travel),
        nozzle_{anchor, nozzleDown()} {}

  void join() {
    for (ToolpathLayer& layer : layers_) dropTravels(layer);
    lookAhead();
    for (std::size_t i = 0; i < layers_.size(); ++i) joinLayer(i);
  }

 private:
  static void dropTravels(ToolpathLayer& layer) {
    layer.paths.erase(std::remove_if(layer.paths.begin(), layer.paths.end(),
                                     [](const Path& path) { return path.role == PathRole::Travel; }),
                      layer.paths.end());
  }

  double pitchOf(const ToolpathLayer& layer) const {
    const BeadSettings& bead = settings_.bead;
    return bead.pitch_mm > 0.0 ? bead.pitch_mm : planWidth({bead.width_mm, layer.height_mm});
  }

  /// From the top down: the place of each layer that is nearest to that of the layer above. A chain that
  /// keeps near these places does not end over a hole that begins higher up.
  void lookAhead() {
    places_.resize(layers_.size() + 1);
    for (std::size_t i = layers_.size(); i-- > 0;) {
      const ToolpathLayer& layer = layers_[i];
      if (layer.paths.empty()) continue;
      const Path& path = layer.paths.back();
      const Point3 above = places_[i + 1] ? *places_[i + 1] : path.firstPoint();
      places_[i] = path.is_closed ? nearestPlace(path, above).point : path.firstPoint();
    }
  }

  void joinLayer(std::size_t index) {
    ToolpathLayer& layer = layers_[index];
    const double pitch = pitchOf(layer);
    std::vector<Path> paths;
    for (std::size_t i = 0; i < layer.paths.size(); ++i) {
      Path& path = layer.paths[i];
      const bool is_last = i + 1 == layer.paths.size();
      const bool is_joined_loop = isJoinedLoop(path, pitch);
      if (is_joined_loop) {
        if (!has_begun_ && places_[index]) nozzle_.point = *places_[index];
        path = is_last ? openedBelow(index + 1, path, pitch) : openedFromNozzle(path, pitch);
      }
      if (!paths.empty()) {
        std::optional<Path> travel = travel_(paths.back(), path, index);
        if (travel) paths.push_back(std::move(*travel));
      } else if (is_joined_loop && has_begun_ && isWithinReach(path, pitch, layer.height_mm) &&
                 canRiseFrom(nozzle_.point, index, path.bead.at(0).width_mm)) {
        path = risingFrom(nozzle_, path);
      }
      has_begun_ = true;
      nozzle_ = endPose(path);
      paths.push_back(std::move(path));
    }
    layer.paths = std::move(paths);
  }

  /// Whether the path starts where a bead from the nozzle can rise to.
  bool isWithinReach(const Path& path, double pitch, double height) const {
    const Point3 way = path.firstPoint() - nozzle_.point;
    const Point3 up = againstToolAxis(path.orientation.at(0));
    const double rise = up.dot(way);
    return (way - rise * up).norm() <= pitch && std::abs(rise) <= 2.0 * height;
  }

  /// Whether a bead from there stays within that layer. Sections of lifted layers are not where these lie.
  bool canRiseFrom(const Point3& point, std::size_t layer, double width_mm) const {
    return layer >= sections_.size() || hasRoomFor(sections_[layer].section, point.head<2>(), width_mm);
  }

  Path openedFromNozzle(const Path& joined_loop, double pitch) const {
    return opened(joined_loop,
                  {nearestPlace(joined_loop, nozzle_.point), LoopSense::AsGiven, kLeftOut * pitch});
  }

  /// The last loop below that layer, begun near the nozzle so that a bead can rise into that layer from its
  /// end if there is such a place within reach, and in the direction that ends nearer to the layer's place.
  Path openedBelow(std::size_t above, const Path& joined_loop, double pitch) const {
    if (!places_[above]) return openedFromNozzle(joined_loop, pitch);
    const JoinedLoopPlace nearest = nearestPlace(joined_loop, nozzle_.point);
    const RatedOpening best = bestOf(above, joined_loop, {nearest}, pitch);
    if (best.can_rise) return opened(joined_loop, best.opening);
    const RatedOpening other =
        bestOf(above, joined_loop, placesAround(joined_loop, nozzle_.point, pitch), pitch);
    return opened(joined_loop, other.can_rise ? other.opening : best.opening);
  }

  struct RatedOpening {
    LoopOpening opening;
    bool can_rise = false;
    double distance_mm = std::numeric_limits<double>::infinity();  ///< of its end from the next place
  };

  RatedOpening bestOf(std::size_t above, const Path& joined_loop, const std::vector<JoinedLoopPlace>& starts,
                      double pitch) const {
    const double width_mm = joined_loop.bead.at(0).width_mm;
    RatedOpening best;
    for (const JoinedLoopPlace& start : starts)
      for (const LoopSense sense : {LoopSense::AsGiven, LoopSense::Reversed}) {
        RatedOpening rated = {{start, sense, kLeftOut * pitch}, false, 0.0};
        const Point3 end = endOfOpened(joined_loop, rated.opening);
        rated.distance_mm = (end - *places_[above]).norm();
        if (best.can_rise && rated.distance_mm >= best.distance_mm) continue;
        rated.can_rise = canRiseFrom(end, above, width_mm);
        if ((rated.can_rise && !best.can_rise) ||
            (rated.can_rise == best.can_rise && rated.distance_mm < best.distance_mm))
          best = rated;
      }
    return best;
  }

  /// The path with a bead from that point to its start put first.
  static Path risingFrom(const NozzlePose& from, Path path) {
    path.points.insert(path.points.begin(), from.point);
    const std::size_t count = path.points.size();
    const auto prolong = [&](auto& quantity) {
      if (quantity.isCommon()) return;
      auto values = quantity.values();
      values.front() = values[1];
      values.insert(values.begin(), values.front());
      quantity = std::decay_t<decltype(quantity)>(std::move(values));
    };
    prolong(path.bead);
    prolong(path.feed_mm_s);
    if (path.orientation.isCommon() && path.orientation.at(0).coeffs() == from.orientation.coeffs())
      return path;
    std::vector<Eigen::Quaterniond> orientations = {from.orientation};
    for (std::size_t i = 0; i + 1 < count; ++i) orientations.push_back(path.orientation.at(i));
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(orientations));
    return path;
  }

  std::vector<ToolpathLayer>& layers_;
  const std::vector<Layer>& sections_;
  const PlanSettings& settings_;
  const TravelMaker& travel_;
  NozzlePose nozzle_;  ///< where the last path ended, or the anchor
  bool has_begun_ = false;
  std::vector<std::optional<Point3>> places_;  ///< of each layer, to keep near to
};

}  // namespace

void chainLayers(std::vector<ToolpathLayer>& layers, const std::vector<Layer>& sections,
                 const PlanSettings& settings, const Point3& anchor, const TravelMaker& travel) {
  LayerChain(layers, sections, settings, anchor, travel).join();
}

}  // namespace lamina
