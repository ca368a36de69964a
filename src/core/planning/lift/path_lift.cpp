// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lift/path_lift.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "planning/lift/bead_bounds.hpp"
#include "planning/lift/held_along.hpp"
#include "planning/lift/lifted_line.hpp"
#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

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
    waypoint(charts_.lifted(charts_.at(planned_.points.front().head<2>())), 0, {});
    for (std::size_t m = 0; m < planned_.motionCount(); ++m) addMotion(m);
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
  void addMotion(std::size_t m) {
    const std::size_t end = planned_.motionEnd(m);
    const Point2 from = planned_.points[m].head<2>();
    const Point2 to = planned_.points[end].head<2>();
    const std::optional<LiftedLine> line = liftedLine(charts_, from, to, settings_.height_tolerance);
    if (!line)
      throw InvalidInput("a run of the plan from (" + std::to_string(from.x()) + ", " +
                         std::to_string(from.y()) + ") to (" + std::to_string(to.x()) + ", " +
                         std::to_string(to.y()) + ") mm leaves its chart; must stay in one");
    const double width = planWidth(planned_.bead.at(end));
    const std::vector<std::size_t> needed = neededPoints(*line, settings_);
    for (std::size_t k = 1; k < needed.size(); ++k)
      waypoint(line->points[needed[k]], end, depositedBetween(*line, needed[k - 1], needed[k], width));
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

  /// The return to the first waypoint is reported by that one.
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
  std::vector<std::size_t> of_plan_;  // waypoint of the plan that reports of this way
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

}  // namespace

LiftedRun liftedRun(const ChartLookup& charts, const Path& planned, const LiftSettings& settings) {
  if (planned.deposit == Deposit::Drops) return {liftedDrops(charts, planned, settings), 0.0};
  return RunLifter(charts, planned, settings).lift();
}

}  // namespace lamina
