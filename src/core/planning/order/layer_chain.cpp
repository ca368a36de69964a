// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/layer_chain.hpp"

#include <algorithm>
#include <cmath>
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

bool isJoinedLoop(const Path& path, double pitch) {
  return path.is_closed && path.role == PathRole::Infill && path.deposit == Deposit::Bead &&
         length(path) > 2.0 * pitch;
}

class LayerChain {
 public:
  LayerChain(std::vector<ToolpathLayer>& layers, const PlanSettings& settings, const Point3& anchor,
             const TravelMaker& travel)
      : layers_(layers), settings_(settings), travel_(travel), nozzle_{anchor, nozzleDown()} {}

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
        path = openedTowards(path, pitch, is_last ? places_[index + 1] : std::nullopt);
      }
      if (!paths.empty()) {
        std::optional<Path> travel = travel_(paths.back(), path, index);
        if (travel) paths.push_back(std::move(*travel));
      } else if (is_joined_loop && has_begun_ && isWithinReach(path, pitch, layer.height_mm)) {
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

  Path openedTowards(const Path& joined_loop, double pitch, const std::optional<Point3>& next) const {
    const LoopOpening as_given = {nearestPlace(joined_loop, nozzle_.point), LoopSense::AsGiven,
                                  kLeftOut * pitch};
    if (!next) return opened(joined_loop, as_given);
    LoopOpening reversed = as_given;
    reversed.sense = LoopSense::Reversed;
    const auto distance = [&](const LoopOpening& opening) {
      return (endOfOpened(joined_loop, opening) - *next).norm();
    };
    return opened(joined_loop, distance(reversed) < distance(as_given) ? reversed : as_given);
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
  const PlanSettings& settings_;
  const TravelMaker& travel_;
  NozzlePose nozzle_;  ///< where the last path ended, or the anchor
  bool has_begun_ = false;
  std::vector<std::optional<Point3>> places_;  ///< of each layer, to keep near to
};

}  // namespace

void chainLayers(std::vector<ToolpathLayer>& layers, const PlanSettings& settings, const Point3& anchor,
                 const TravelMaker& travel) {
  LayerChain(layers, settings, anchor, travel).join();
}

}  // namespace lamina
