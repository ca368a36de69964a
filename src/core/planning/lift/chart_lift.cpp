// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/lift/chart_lift.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/parameterization/chart_lookup.hpp"
#include "planning/lift/held_along.hpp"
#include "planning/lift/lifted_line.hpp"
#include "planning/lift/path_lift.hpp"
#include "planning/nozzle_frame.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {
namespace {

/// By which travels that follow a layer are raised, in tolerances: nowhere lower than a convex layer, which
/// their ends leave in a parabola.
constexpr double kRaise = 4.0;

class LayerLifter {
 public:
  LayerLifter(const ChartLookup& charts, const LiftSettings& settings, const TravelSettings& travel,
              double highest_mm)
      : charts_(charts), settings_(settings), travel_(travel), highest_mm_(highest_mm) {}

  LiftedLayer lift(const ToolpathLayer& planned) && {
    const Path* travel = nullptr;
    for (const Path& path : planned.paths) {
      if (path.role == PathRole::Travel)
        travel = &path;
      else
        addRun(path, std::exchange(travel, nullptr));
    }
    return {{planned.z_mm, planned.height_mm, std::move(lifted_)}, left_out_mm3_};
  }

 private:
  void addRun(const Path& planned, const Path* travel) {
    LiftedRun run = liftedRun(charts_, planned, settings_);
    left_out_mm3_ += run.left_out_mm3;
    if (!run.path) {
      is_beside_ = true;
      return;
    }
    if ((travel != nullptr || is_beside_) && !lifted_.empty()) addTravelTo(startPose(*run.path), travel);
    is_beside_ = false;
    lifted_.push_back(std::move(*run.path));
  }

  void addTravelTo(const NozzlePose& to, const Path* planned) {
    const NozzlePose from = endPose(lifted_.back());
    std::optional<Path> there;
    if (planned != nullptr && !is_beside_) there = followed(*planned, from, to);
    if (!there) there = makeSpaceTravel(from, to, travel_, highest_mm_);
    if (there) lifted_.push_back(std::move(*there));
  }

  /// The travel along the layer, if it may and can follow it.
  std::optional<Path> followed(const Path& planned, const NozzlePose& from, const NozzlePose& to) const {
    if (planned.process.is_retracted || (to.point - from.point).norm() < 1e-6) return std::nullopt;
    const std::optional<LiftedLine> line =
        liftedLine(charts_, planned.firstPoint().head<2>(), planned.lastPoint().head<2>(), 1.0);
    if (!line) return std::nullopt;
    Path path = planned;
    const std::vector<std::size_t> needed = neededPoints(*line, travelSettings());
    std::vector<Eigen::Quaterniond> orientations;
    path.points.clear();
    for (const std::size_t i : needed) {
      const SurfacePoint& point = line->points[i];
      path.points.emplace_back(point.tip + kRaise * settings_.position_tolerance_mm * point.normal);
      orientations.push_back(settings_.tool_axis == ToolAxis::Down ? nozzleDown()
                                                                   : nozzleAgainst(point.normal));
    }
    path.points.front() = from.point;
    path.points.back() = to.point;
    orientations.front() = from.orientation;
    orientations.back() = to.orientation;
    path.orientation = heldAlong(std::move(orientations));
    return path;
  }

  /// Travels have no height.
  LiftSettings travelSettings() const {
    LiftSettings settings = settings_;
    settings.height_tolerance = std::numeric_limits<double>::infinity();
    return settings;
  }

  const ChartLookup& charts_;
  const LiftSettings& settings_;
  const TravelSettings& travel_;
  double highest_mm_;
  std::vector<Path> lifted_;
  double left_out_mm3_ = 0.0;
  bool is_beside_ = false;  // the nozzle is not where the plan has it: a run was left out
};

}  // namespace

void describe(SettingsSchema& schema, LiftSettings& settings) {
  schema.number("lifting.position_tolerance_mm", settings.position_tolerance_mm, {1e-5, 1.0, false},
                "How far paths may leave a curved layer between their waypoints.");
  schema.number("lifting.normal_tolerance_deg", settings.normal_tolerance_deg, {1e-3, 30.0, false},
                "How far the nozzle may leave the normal of a curved layer between waypoints.");
  schema.number("lifting.height_tolerance", settings.height_tolerance, {1e-3, 1.0, false},
                "Part by which the height of a curved layer may vary along one motion.");
  schema.number("lifting.widest_bead", settings.widest_bead, {1.0, 10.0, false},
                "Widest bead on a curved layer, in planned widths; what would need a wider one is left out.");
}

LiftedLayer liftOnto(const std::vector<LayerChart>& charts, ToolpathLayer planned,
                     const LiftSettings& settings, const TravelSettings& travel, double highest_mm) {
  if (planned.paths.empty()) return {std::move(planned), 0.0};
  const ChartLookup lookup(charts);
  return LayerLifter(lookup, settings, travel, highest_mm).lift(planned);
}

LayerLift chartLift(const std::vector<std::vector<LayerChart>>& layers, std::vector<double> highest_mm,
                    const LiftSettings& settings, const TravelSettings& travel) {
  if (highest_mm.size() != layers.size())
    throw InvalidInput("the highest tips are given of " + std::to_string(highest_mm.size()) +
                       " layers; expected " + std::to_string(layers.size()));
  return [&layers, settings, travel, highest = std::move(highest_mm)](std::size_t layer,
                                                                      ToolpathLayer planned) -> LiftedLayer {
    if (layer >= layers.size())
      throw InvalidInput("layer " + std::to_string(layer) + " has no charts; there are those of " +
                         std::to_string(layers.size()) + " layers");
    if (layers[layer].empty()) return {std::move(planned), 0.0};
    try {
      return liftOnto(layers[layer], std::move(planned), settings, travel, highest[layer]);
    } catch (const InvalidInput& error) {
      throw InvalidInput("layer " + std::to_string(layer) + ": " + error.what());
    }
  };
}

}  // namespace lamina
