// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "orientation/travel_turn.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/orientation/no_spin.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kSameAxis = 1e-12;
constexpr double kKnownAxis = 1e-6;

/// Travels between two runs.
struct Transfer {
  std::vector<Path*> travels;
  double length_mm = 0.0;
};

void negate(Path& run) {
  std::vector<Eigen::Quaterniond> values = run.orientation.values();
  for (Eigen::Quaterniond& value : values) value.coeffs() = -value.coeffs();
  run.orientation = AlongPath<Eigen::Quaterniond>(std::move(values));
}

bool isSameAxis(const Point3& a, const Point3& b) { return (a - b).norm() <= kKnownAxis; }

/// Whether the travels lead the tool axis from one run to the other by themselves.
bool leadsToolAxis(const Transfer& transfer, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  if (transfer.travels.empty() || transfer.travels.front()->orientation.isCommon()) return false;
  const auto& first = transfer.travels.front()->orientation;
  const auto& last = transfer.travels.back()->orientation;
  return isSameAxis(toolAxisOf(first.values().front()), toolAxisOf(from)) &&
         isSameAxis(toolAxisOf(last.values().back()), toolAxisOf(to));
}

/// Their tool axes stay; about these the nozzle turns as little as can be, and evenly to that of the next
/// run.
/// @return the orientation at their end: that of the next run but for its sign
Eigen::Quaterniond keepToolAxes(const Transfer& transfer, const Eigen::Quaterniond& from,
                                const Eigen::Quaterniond& to) {
  std::vector<std::vector<Eigen::Quaterniond>> held;
  std::vector<double> at_mm;
  Eigen::Quaterniond last = from;
  double run_mm = 0.0;
  for (const Path* travel : transfer.travels) {
    held.emplace_back();
    for (std::size_t i = 0; i < travel->points.size(); ++i) {
      if (i > 0) run_mm += (travel->points[i] - travel->points[i - 1]).norm();
      at_mm.push_back(run_mm);
      last = (shortestRotation(toolAxisOf(last), toolAxisOf(travel->orientation.at(i))) * last).normalized();
      held.back().push_back(last);
    }
  }
  const Eigen::Quaterniond missing = last.conjugate() * to;
  const double turn = std::remainder(2.0 * std::atan2(missing.z(), missing.w()), 2.0 * M_PI);
  std::size_t station = 0;
  for (std::size_t t = 0; t < held.size(); ++t) {
    for (Eigen::Quaterniond& each : held[t]) {
      const double part = run_mm > 0.0 ? at_mm[station] / run_mm : 1.0;
      ++station;
      each = each * Eigen::AngleAxisd(part * turn, Point3::UnitZ());
    }
    last = held[t].back();
    transfer.travels[t]->orientation = AlongPath<Eigen::Quaterniond>(std::move(held[t]));
  }
  return last;
}

void turnEvenly(const Transfer& transfer, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const bool is_common = (from.coeffs() - to.coeffs()).cwiseAbs().maxCoeff() <= kSameAxis;
  double run_mm = 0.0;
  for (Path* travel : transfer.travels) {
    if (is_common) {
      travel->orientation = from;
      continue;
    }
    std::vector<Eigen::Quaterniond> values;
    values.reserve(travel->points.size());
    for (std::size_t i = 0; i < travel->points.size(); ++i) {
      if (i > 0) run_mm += (travel->points[i] - travel->points[i - 1]).norm();
      const bool is_end = travel == transfer.travels.back() && i + 1 == travel->points.size();
      const double part = is_end ? 1.0 : transfer.length_mm > 0.0 ? run_mm / transfer.length_mm : 0.0;
      values.push_back(is_end ? to : from.slerp(part, to));
    }
    travel->orientation = AlongPath<Eigen::Quaterniond>(std::move(values));
  }
}

void setEnd(Path& travel, const Eigen::Quaterniond& orientation) {
  std::vector<Eigen::Quaterniond> values = travel.orientation.values();
  values.back() = orientation;
  travel.orientation = AlongPath<Eigen::Quaterniond>(std::move(values));
}

/// The next run takes the sign that the travels come with.
void turnTo(Path& next, const Transfer& transfer, const Eigen::Quaterniond& from) {
  const bool is_led = leadsToolAxis(transfer, from, startOrientation(next));
  const Eigen::Quaterniond end = is_led ? keepToolAxes(transfer, from, startOrientation(next)) : from;
  if (end.dot(startOrientation(next)) < 0.0) negate(next);
  if (is_led)
    setEnd(*transfer.travels.back(), startOrientation(next));
  else
    turnEvenly(transfer, from, startOrientation(next));
}

}  // namespace

Toolpath withTravelsOriented(Toolpath toolpath) {
  Transfer transfer;
  Path* last_run = nullptr;
  for (ToolpathLayer& layer : toolpath.layers) {
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) {
        transfer.travels.push_back(&path);
        transfer.length_mm += length(path);
        continue;
      }
      if (last_run != nullptr)
        turnTo(path, transfer, endOrientation(*last_run));
      else
        turnEvenly(transfer, startOrientation(path), startOrientation(path));
      transfer = {};
      last_run = &path;
    }
  }
  if (last_run != nullptr) turnEvenly(transfer, endOrientation(*last_run), endOrientation(*last_run));
  return toolpath;
}

}  // namespace lamina
