// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/layer_chain.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "planning/opened_cycle.hpp"
#include "planning/travel.hpp"

namespace lamina {
namespace {

/// Of a cycle, in pitches, left out at its end: its two round ends leave corners open, and come so much
/// nearer to each other.
constexpr double kLeftOut = 0.9;

bool isCycle(const Path& path, double pitch) {
  return path.is_closed && path.role == PathRole::Infill && path.deposit == Deposit::Bead &&
         length(path) > 2.0 * pitch;
}

class LayerChain {
 public:
  LayerChain(std::vector<ToolpathLayer>& layers, const PlanSettings& settings, const Point2& anchor)
      : layers_(layers), settings_(settings), nozzle_(anchor) {}

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
      const Point2 above = places_[i + 1] ? *places_[i + 1] : Point2(path.firstPoint().head<2>());
      places_[i] = path.is_closed ? nearestPlace(path, above).point : Point2(path.firstPoint().head<2>());
    }
  }

  void joinLayer(std::size_t index) {
    ToolpathLayer& layer = layers_[index];
    const double pitch = pitchOf(layer);
    std::vector<Path> paths;
    for (std::size_t i = 0; i < layer.paths.size(); ++i) {
      Path& path = layer.paths[i];
      const bool is_last = i + 1 == layer.paths.size();
      const bool is_cycle = isCycle(path, pitch);
      if (is_cycle) {
        if (!last_ && places_[index]) nozzle_ = *places_[index];
        path = openedTowards(path, pitch, is_last ? places_[index + 1] : std::nullopt);
      }
      if (!paths.empty()) {
        std::optional<Path> travel = makeTravel(*last_, path.firstPoint(), settings_.travel);
        if (travel) paths.push_back(std::move(*travel));
      } else if (is_cycle && last_ && (last_->head<2>() - path.firstPoint().head<2>()).norm() <= pitch) {
        path = risingFrom(*last_, path);
      }
      last_ = path.lastPoint();
      nozzle_ = last_->head<2>();
      paths.push_back(std::move(path));
    }
    layer.paths = std::move(paths);
  }

  Path openedTowards(const Path& cycle, double pitch, const std::optional<Point2>& next) const {
    const CycleOpening as_given = {nearestPlace(cycle, nozzle_), CycleSense::AsGiven, kLeftOut * pitch};
    if (!next) return opened(cycle, as_given);
    CycleOpening reversed = as_given;
    reversed.sense = CycleSense::Reversed;
    const auto distance = [&](const CycleOpening& opening) {
      return (endOfOpened(cycle, opening).head<2>() - *next).norm();
    };
    return opened(cycle, distance(reversed) < distance(as_given) ? reversed : as_given);
  }

  /// The path with a bead from that point to its start put first.
  static Path risingFrom(const Point3& point, Path path) {
    path.points.insert(path.points.begin(), point);
    const auto prolong = [&](auto& quantity) {
      if (quantity.isCommon()) return;
      auto values = quantity.values();
      values.front() = values[1];
      values.insert(values.begin(), values.front());
      quantity = std::decay_t<decltype(quantity)>(std::move(values));
    };
    prolong(path.bead);
    prolong(path.feed_mm_s);
    prolong(path.orientation);
    return path;
  }

  std::vector<ToolpathLayer>& layers_;
  const PlanSettings& settings_;
  Point2 nozzle_;
  std::optional<Point3> last_;
  std::vector<std::optional<Point2>> places_;  ///< of each layer, to keep near to
};

}  // namespace

void chainLayers(std::vector<ToolpathLayer>& layers, const PlanSettings& settings, const Point2& anchor) {
  LayerChain(layers, settings, anchor).join();
}

}  // namespace lamina
