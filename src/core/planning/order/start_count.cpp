// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/start_count.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Whether a disc fits, by the area that would be left without: outlines that move inwards by r sweep at most
/// r times their length, and holes a disc of r more each. False proves nothing.
bool isRoomyAtOnce(const Region& region, double radius) {
  double length = perimeter(region.outer);
  for (const Polygon& hole : region.holes) length += perimeter(hole);
  const double discs = static_cast<double>(region.holes.size()) * M_PI * radius * radius;
  return area({region}) > radius * length + discs;
}

double travelOf(const std::vector<RunEnds>& deposited) {
  double sum = 0.0;
  for (std::size_t i = 1; i < deposited.size(); ++i)
    sum += (deposited[i].first - deposited[i - 1].last).norm();
  return sum;
}

}  // namespace

FillStarts& operator+=(FillStarts& sum, const FillStarts& more) {
  sum.runs += more.runs;
  sum.regions += more.regions;
  sum.travel_mm += more.travel_mm;
  sum.best_travel_mm += more.best_travel_mm;
  return sum;
}

std::size_t regionsWithRoom(const Regions& regions, double width_mm) {
  const double radius = 0.5 * width_mm;
  return static_cast<std::size_t>(std::count_if(regions.begin(), regions.end(), [&](const Region& region) {
    return isRoomyAtOnce(region, radius) || !offset({region}, -radius, Join::Round).empty();
  }));
}

FillStarts startsOf(const Regions& area, const std::vector<RunEnds>& deposited, double pitch_mm) {
  FillStarts starts;
  starts.runs = deposited.size();
  starts.regions = regionsWithRoom(area, pitch_mm);
  if (deposited.empty()) return starts;
  starts.travel_mm = travelOf(deposited);
  const Point2& start = deposited.front().first;
  starts.best_travel_mm =
      std::min(starts.travel_mm, travelLength(deposited, orderRuns(deposited, start), start));
  return starts;
}

}  // namespace lamina
