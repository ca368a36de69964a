// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/lift/chart_lift.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/parameterization/chart_lookup.hpp"
#include "planning/lift/bead_bounds.hpp"
#include "planning/lift/held_along.hpp"
#include "planning/nozzle_frame.hpp"
#include "planning/runs/cut_beads.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {
namespace {

/// A straight line of the plan as it lies on a layer.
struct LiftedLine {
  std::vector<SurfacePoint> points;  ///< the ends, and where it crosses sides of triangles
  std::vector<double> plan_mm;       ///< length in the plan up to each point
  std::vector<double> area_ratio;    ///< in space over in the plan, from each point to the next
};

/// More parts of a triangle than this do not follow a height that runs out to nothing any better.
constexpr int kMostParts = 100;

int partsFor(double from_mm, double to_mm, double tolerance) {
  const double change = std::abs(to_mm - from_mm);
  const double allowed = tolerance * std::min(from_mm, to_mm);
  if (change > kMostParts * allowed) return kMostParts;
  return change > allowed ? static_cast<int>(std::ceil(change / allowed)) : 1;
}

class Thinning {
 public:
  Thinning(const LiftedLine& line, const LiftSettings& settings)
      : line_(line),
        settings_(settings),
        chord_(2.0 * std::sin(toRadians(0.5 * settings.normal_tolerance_deg))) {}

  std::vector<std::size_t> needed() const {
    std::vector<std::size_t> kept = {0};
    std::vector<std::size_t> ends = {line_.points.size() - 1};  // still to reach, the nearest last
    while (!ends.empty()) {
      const std::size_t middle = split(kept.back(), ends.back());
      if (middle != kept.back()) {
        ends.push_back(middle);
        continue;
      }
      kept.push_back(ends.back());
      ends.pop_back();
    }
    return kept;
  }

 private:
  /// The point between two at which their straight connection is farthest from what is allowed; the first
  /// of the two if it is allowed.
  std::size_t split(std::size_t first, std::size_t last) const {
    std::size_t worst = first;
    double greatest = 1.0;
    double low = line_.points[last].height_mm;
    double high = low;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double excess = excessOf(i, first, last);
      if (excess > greatest) {
        greatest = excess;
        worst = i;
      }
      low = std::min(low, line_.points[i].height_mm);
      high = std::max(high, line_.points[i].height_mm);
    }
    low = std::min(low, line_.points[first].height_mm);
    high = std::max(high, line_.points[first].height_mm);
    const bool varies = high - low > settings_.height_tolerance * 0.5 * (high + low) * (1.0 + 1e-9);
    return worst == first && varies ? (first + last) / 2 : worst;
  }

  /// Deviation of a point in tolerances.
  double excessOf(std::size_t i, std::size_t first, std::size_t last) const {
    const SurfacePoint& a = line_.points[first];
    const SurfacePoint& b = line_.points[last];
    const SurfacePoint& point = line_.points[i];
    const Point3 along = b.tip - a.tip;
    const double squared = along.squaredNorm();
    const double part = squared > 0.0 ? std::clamp((point.tip - a.tip).dot(along) / squared, 0.0, 1.0) : 0.0;
    const double distance = (a.tip + part * along - point.tip).norm() / settings_.position_tolerance_mm;
    if (settings_.tool_axis == ToolAxis::Down) return distance;
    const Point3 normal = (a.normal + part * (b.normal - a.normal)).normalized();
    return std::max(distance, (normal - point.normal).norm() / chord_);
  }

  const LiftedLine& line_;
  const LiftSettings& settings_;
  double chord_;
};

/// An end of a line that a stretch of it leads to, which may be drawn to a corner from farther out.
SurfacePoint endOn(const ChartLookup& charts, const ChartStretch& stretch, const Point2& end) {
  const std::optional<ChartPlace> place = charts.find(end);
  return charts.lifted(place ? *place : charts.within(stretch.in, end));
}

/// The line on the charts; in triangles where the height varies by more than the tolerance it has further
/// points. Nothing if it leaves its chart.
std::optional<LiftedLine> liftedLine(const ChartLookup& charts, const Point2& from, const Point2& to,
                                     double height_tolerance) {
  const std::optional<std::vector<ChartStretch>> stretches = charts.stretches(from, to);
  if (!stretches) return std::nullopt;
  const double length = (to - from).norm();
  LiftedLine line;
  line.points.push_back(endOn(charts, stretches->front(), from));
  line.plan_mm.push_back(0.0);
  for (const ChartStretch& stretch : *stretches) {
    const bool is_last = &stretch == &stretches->back();
    const auto placeAt = [&](double t) { return charts.within(stretch.in, from + t * (to - from)); };
    const SurfacePoint end = is_last ? endOn(charts, stretch, to) : charts.lifted(placeAt(stretch.to));
    const int parts = partsFor(line.points.back().height_mm, end.height_mm, height_tolerance);
    for (int k = 1; k <= parts; ++k) {
      const double t = stretch.from + (stretch.to - stretch.from) * k / parts;
      line.points.push_back(k == parts ? end : charts.lifted(placeAt(t)));
      line.plan_mm.push_back(t * length);
      line.area_ratio.push_back(charts.areaRatio(stretch.in));
    }
  }
  return line;
}

/// Indices of the points without which the line would leave the tolerances; the ends are among them.
std::vector<std::size_t> neededPoints(const LiftedLine& line, const LiftSettings& settings) {
  return Thinning(line, settings).needed();
}

/// A run on its layer, if there is room for it.
struct LiftedRun {
  std::optional<Path> path;
  double left_out_mm3 = 0.0;
  bool leaves_charts = false;  ///< nothing else is known then
};

/// Waypoints nearer to each other than this are one [mm].
constexpr double kShortest = 1e-9;
/// What rounding leaves of equal quantities.
constexpr double kRounding = 1e-9;

/// What lies on the layer between two waypoints.
struct Deposited {
  double mm3 = 0.0;
  double plan_mm = 0.0;
  double height_mm2 = 0.0;  ///< height times length in the plan

  /// Of the layer, in the mean.
  double height() const { return plan_mm > 0.0 ? height_mm2 / plan_mm : 0.0; }

  void add(const Deposited& more) {
    mm3 += more.mm3;
    plan_mm += more.plan_mm;
    height_mm2 += more.height_mm2;
  }
};

class RunLifter {
 public:
  RunLifter(const ChartLookup& charts, const Path& planned, const LiftSettings& settings)
      : charts_(charts), planned_(planned), settings_(settings) {}

  LiftedRun lift() && {
    const Point2 start = planned_.points.front().head<2>();
    const auto first = charts_.stretches(start, planned_.points[planned_.motionEnd(0)].head<2>());
    if (!first) return {std::nullopt, 0.0, true};
    waypoint(endOn(charts_, first->front(), start), 0, {});
    for (std::size_t m = 0; m < planned_.motionCount(); ++m)
      if (!addMotion(m)) return {std::nullopt, 0.0, true};
    deposited_.back().add(carried_);
    if (planned_.is_closed) close();
    if (points_.size() < 2) return leftOut();
    const std::vector<MotionLoad> loads = loadsOfMotions();
    double length = 0.0;
    for (const MotionLoad& load : loads) length += load.length_mm;
    LoadLimits limits;
    limits.fullest = settings_.widest_bead;
    limits.is_closed = planned_.is_closed;
    for (const Bead& bead : planned_.bead.values())
      limits.reach_mm = std::max(limits.reach_mm, bead.width_mm);
    BoundedLoads bounded = boundLoads(loads, limits);
    if (bounded.left_out_mm3 > 0.0 && length < limits.reach_mm) return leftOut();
    for (std::size_t m = 0; m < loads.size(); ++m) deposited_[endOf(m)].mm3 = bounded.mm3[m];
    return {path(), bounded.left_out_mm3};
  }

 private:
  /// Whether it stays on the charts.
  bool addMotion(std::size_t m) {
    const std::size_t end = planned_.motionEnd(m);
    const Point2 from = planned_.points[m].head<2>();
    const Point2 to = planned_.points[end].head<2>();
    const std::optional<LiftedLine> line = liftedLine(charts_, from, to, settings_.height_tolerance);
    if (!line) return false;
    const double width = planWidth(planned_.bead.at(end));
    const std::vector<std::size_t> needed = neededPoints(*line, settings_);
    for (std::size_t k = 1; k < needed.size(); ++k)
      waypoint(line->points[needed[k]], end, depositedBetween(*line, needed[k - 1], needed[k], width));
    return true;
  }

  static Deposited depositedBetween(const LiftedLine& line, std::size_t first, std::size_t last,
                                    double width) {
    Deposited deposited;
    for (std::size_t i = first; i < last; ++i) {
      const double length = line.plan_mm[i + 1] - line.plan_mm[i];
      const double height = 0.5 * (line.points[i].height_mm + line.points[i + 1].height_mm);
      deposited.add({width * length * line.area_ratio[i] * height, length, height * length});
    }
    return deposited;
  }

  void waypoint(const SurfacePoint& point, std::size_t of_plan, Deposited deposited) {
    carried_.add(deposited);
    if (!points_.empty() && (point.tip - points_.back()).norm() < kShortest) return;
    points_.push_back(point.tip);
    orientations_.push_back(settings_.tool_axis == ToolAxis::Down ? nozzleDown()
                                                                  : nozzleAgainst(point.normal));
    of_plan_.push_back(of_plan);
    deposited_.push_back(std::exchange(carried_, {}));
  }

  /// The return to the first waypoint is described by that waypoint.
  void close() {
    if (points_.size() < 2 || (points_.back() - points_.front()).norm() >= kShortest) return;
    deposited_.front() = deposited_.back();
    of_plan_.front() = of_plan_.back();
    points_.pop_back();
    orientations_.pop_back();
    deposited_.pop_back();
    of_plan_.pop_back();
  }

  LiftedRun leftOut() const {
    double sum = 0.0;
    for (const Deposited& deposited : deposited_) sum += deposited.mm3;
    return {std::nullopt, sum};
  }

  /// Waypoint at the end of a motion on the layer.
  std::size_t endOf(std::size_t motion) const { return (motion + 1) % points_.size(); }

  double lengthTo(std::size_t waypoint) const {
    return (points_[waypoint] - points_[waypoint == 0 ? points_.size() - 1 : waypoint - 1]).norm();
  }

  std::vector<MotionLoad> loadsOfMotions() const {
    std::vector<MotionLoad> loads(points_.size() - (planned_.is_closed ? 0 : 1));
    for (std::size_t m = 0; m < loads.size(); ++m) {
      const std::size_t end = endOf(m);
      const double length = lengthTo(end);
      const double width = planWidth(planned_.bead.at(of_plan_[end]));
      loads[m] = {deposited_[end].mm3, width * deposited_[end].height() * length, length};
    }
    return loads;
  }

  Bead beadAt(std::size_t waypoint) const {
    const Deposited& deposited = deposited_[waypoint];
    return beadOfArea(deposited.mm3 / lengthTo(waypoint), deposited.height());
  }

  Path path() {
    std::vector<Bead> beads(points_.size());
    std::vector<double> feeds(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i > 0 || planned_.is_closed) beads[i] = beadAt(i);
      feeds[i] = planned_.feed_mm_s.at(of_plan_[i]);
    }
    if (!planned_.is_closed) beads.front() = beads[1];
    Path path;
    path.role = planned_.role;
    path.is_closed = planned_.is_closed;
    path.process = planned_.process;
    path.points = std::move(points_);
    path.orientation = heldAlong(std::move(orientations_));
    path.bead = alongPath(std::move(beads), [](const Bead& a, const Bead& b) {
      return std::abs(a.width_mm - b.width_mm) + std::abs(a.height_mm - b.height_mm) < kRounding;
    });
    path.feed_mm_s = alongPath(std::move(feeds), [](double a, double b) { return a == b; });
    return path;
  }

  const ChartLookup& charts_;
  const Path& planned_;
  const LiftSettings& settings_;
  std::vector<Point3> points_;
  std::vector<Eigen::Quaterniond> orientations_;
  std::vector<Deposited> deposited_;  // on the way to each waypoint
  std::vector<std::size_t> of_plan_;  // waypoint of the plan that describes this way
  Deposited carried_;                 // where tips coincided, on the way to the next waypoint
};

Path liftedDrops(const ChartLookup& charts, const Path& planned, const LiftSettings& settings) {
  Path path = planned;
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Bead> drops;
  for (std::size_t i = 0; i < planned.points.size(); ++i) {
    const ChartPlace place = charts.at(planned.points[i].head<2>());
    const SurfacePoint point = charts.lifted(place);
    path.points[i] = point.tip;
    orientations.push_back(settings.tool_axis == ToolAxis::Down ? nozzleDown() : nozzleAgainst(point.normal));
    drops.push_back({planned.bead.at(i).width_mm * std::sqrt(charts.areaRatio(place.in)), point.height_mm});
  }
  path.orientation = heldAlong(std::move(orientations));
  path.bead = AlongPath<Bead>(std::move(drops));
  return path;
}

/// A run that deposits, from the plan onto its layer, as `liftOnto` says.
/// @throws InvalidInput if a drop leaves its chart
LiftedRun liftedRun(const ChartLookup& charts, const Path& planned, const LiftSettings& settings) {
  if (planned.deposit == Deposit::Drops) return {liftedDrops(charts, planned, settings), 0.0};
  return RunLifter(charts, planned, settings).lift();
}

/// What of a run lies beside all charts.
struct OffCharts {
  HinderedWaypoints waypoints;  ///< of the first path of a first layer
  double length_mm = 0.0;
  std::string first;  ///< where it begins, for people
};

OffCharts offCharts(const ChartLookup& charts, const Path& planned) {
  OffCharts off;
  for (std::size_t m = 0; m < planned.motionCount(); ++m) {
    const std::size_t end = planned.motionEnd(m);
    const Point2 from = planned.points[m].head<2>();
    const Point2 to = planned.points[end].head<2>();
    if (charts.stretches(from, to)) continue;
    off.waypoints.off.insert({0, 0, end});
    off.length_mm += (to - from).norm();
    if (off.first.empty())
      off.first = "from (" + numberText(from.x()) + ", " + numberText(from.y()) + ") to (" +
                  numberText(to.x()) + ", " + numberText(to.y()) + ") mm";
  }
  return off;
}

/// Of a run that may lie beside the charts, and is left out, in widths of its bead: planning is out of its
/// depth where more does.
constexpr double kMostOff = 5.0;

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
    if (run.leaves_charts) return addPieces(planned);
    left_out_mm3_ += run.left_out_mm3;
    if (!run.path) {
      is_beside_ = true;
      return;
    }
    if ((travel != nullptr || is_beside_) && !lifted_.empty()) addTravelTo(startPose(*run.path), travel);
    is_beside_ = false;
    lifted_.push_back(std::move(*run.path));
  }

  /// Where charts are cut at folds, a bead that fits between their borders may lie beside them.
  void addPieces(const Path& planned) {
    const OffCharts off = offCharts(charts_, planned);
    const double width_mm = planned.bead.at(planned.points.size() - 1).width_mm;
    if (off.length_mm > kMostOff * width_mm)
      throw InvalidInput("a run in the parameter plane " + off.first + " leaves its chart, over " +
                         numberText(off.length_mm) + " mm in all; must stay in one, but for " +
                         numberText(kMostOff) + " widths of its bead");
    const TravelMaker none = [](const Path&, const Path&, std::size_t) { return std::nullopt; };
    CutBeads cut = cutBeads({"", {{0.0, 0.0, {planned}}}}, off.waypoints, none, 0.0);
    left_out_mm3_ += cut.left_out_mm3;
    for (const Path& piece : cut.toolpath.layers[0].paths) {
      is_beside_ = true;
      addRun(piece, nullptr);
    }
    is_beside_ = true;
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
  schema.number("lifting.position_tolerance_mm", settings.position_tolerance_mm, {1e-5, 1.0},
                "How far paths may leave a curved layer between their waypoints.");
  schema.number("lifting.normal_tolerance_deg", settings.normal_tolerance_deg, {1e-3, 30.0},
                "How far the nozzle may leave the normal of a curved layer between waypoints.");
  schema.number("lifting.height_tolerance", settings.height_tolerance, {1e-3, 1.0},
                "Part by which the height of a curved layer may vary along one motion.");
  schema.number("lifting.widest_bead", settings.widest_bead, {1.0, 10.0},
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
      throw InvalidInput("the layer has no charts; there are those of " + std::to_string(layers.size()) +
                         " layers");
    if (layers[layer].empty()) return {std::move(planned), 0.0};
    return liftOnto(layers[layer], std::move(planned), settings, travel, highest[layer]);
  };
}

}  // namespace lamina
