// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "orientation/travel_turn.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace lamina {
namespace {

constexpr double kSameAxis = 1e-12;

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

void turnAlong(const Transfer& transfer, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
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

}  // namespace

const Eigen::Quaterniond& startOrientation(const Path& path) { return path.orientation.at(0); }

const Eigen::Quaterniond& endOrientation(const Path& path) {
  return path.orientation.at(path.is_closed ? 0 : path.points.size() - 1);
}

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
      if (last_run != nullptr && endOrientation(*last_run).dot(startOrientation(path)) < 0.0) negate(path);
      const Eigen::Quaterniond& to = startOrientation(path);
      turnAlong(transfer, last_run != nullptr ? endOrientation(*last_run) : to, to);
      transfer = {};
      last_run = &path;
    }
  }
  if (last_run != nullptr) turnAlong(transfer, endOrientation(*last_run), endOrientation(*last_run));
  return toolpath;
}

}  // namespace lamina
