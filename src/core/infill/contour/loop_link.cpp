// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_link.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Length of a gap, in distances between the loops. Runs turn round where they are cut, and leave their
/// corners open; a little less than a whole distance makes up for that.
constexpr double kGap = 0.9;

/// Where links from both ends of a gap land.
struct Landings {
  LoopPlace start;
  LoopPlace end;
};

std::optional<Landings> landings(const Loop& onto, const Point2& start, const Point2& end, ContourLink kind,
                                 double distance) {
  const LoopPlace middle = onto.nearest(0.5 * (start + end));
  if (middle.distance_mm > 3.0 * distance) return std::nullopt;
  const LoopStretch near_by{middle.position_mm, 3.0 * distance};
  if (kind == ContourLink::Tangential)
    return Landings{onto.nearest(start, near_by), onto.nearest(end, near_by)};
  const Point2 chord = (end - start).normalized();
  Point2 across = leftOf(chord);
  if (across.dot(onto.pointAt(middle.position_mm) - start) < 0.0) across = -across;
  const std::optional<LoopPlace> from_start = onto.hit(start, across, near_by);
  const std::optional<LoopPlace> from_end = onto.hit(end, across, near_by);
  if (!from_start || !from_end) return std::nullopt;
  return Landings{*from_start, *from_end};
}

/// The shorter way round between two positions.
LoopGap gapBetween(const LoopGraph& net, std::size_t loop, double a, double b) {
  const Loop& line = net.loops()[loop];
  const double forward = line.wrapped(b - a);
  if (2.0 * forward <= line.length()) return {loop, line.wrapped(a), line.wrapped(a) + forward};
  return {loop, line.wrapped(b), line.wrapped(b) + line.length() - forward};
}

bool isStraight(const Loop& loop, const LoopGap& gap, double straightness) {
  return (loop.pointAt(gap.to_mm) - loop.pointAt(gap.from_mm)).norm() >= straightness * gap.length();
}

}  // namespace

std::optional<LoopLink> linkAt(const LoopGraph& net, const LinkTrial& trial, ContourLink kind,
                               const LinkLimits& limits) {
  const Loop& loop = net.loops()[trial.loop];
  const Loop& onto = net.loops()[trial.onto];
  const double distance = trial.distance_mm;
  const double from = loop.wrapped(trial.position_mm);
  LoopLink link;
  link.a = {trial.loop, from, from + std::min(kGap * distance, 0.4 * loop.length())};
  if (!net.isFree(link.a, limits.margin * distance) || !isStraight(loop, link.a, limits.straightness))
    return std::nullopt;
  const Point2 start = loop.pointAt(link.a.from_mm);
  const Point2 end = loop.pointAt(link.a.to_mm);
  const std::optional<Landings> landed = landings(onto, start, end, kind, distance);
  if (!landed || std::max(landed->start.distance_mm, landed->end.distance_mm) > limits.longest * distance)
    return std::nullopt;
  link.b = gapBetween(net, trial.onto, landed->start.position_mm, landed->end.position_mm);
  const double length = link.b.length() / link.a.length();
  if (length < limits.least_gap || length > limits.greatest_gap) return std::nullopt;
  if (!net.isFree(link.b, limits.margin * distance) || !isStraight(onto, link.b, limits.straightness))
    return std::nullopt;
  const Point2 start_on = onto.pointAt(landed->start.position_mm);
  const Point2 end_on = onto.pointAt(landed->end.position_mm);
  if (areCrossing(start, start_on, end, end_on)) return std::nullopt;
  for (const Loop* crossed : {&loop, &onto})
    if (crossed->isCrossedBy(start, start_on) || crossed->isCrossedBy(end, end_on)) return std::nullopt;
  const bool is_alike = std::abs(link.b.from_mm - onto.wrapped(landed->start.position_mm)) < 1e-9;
  link.ends = is_alike ? LinkEnds::Alike : LinkEnds::Opposite;
  return link;
}

}  // namespace lamina
