// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/adhesion/prime_line.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

std::string millimetres(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g mm", value);
  return digits;
}

Polygon rectangleRound(const Point2& from, const Point2& to, double reach_mm) {
  const Point2 low = from - Point2::Constant(reach_mm);
  const Point2 high = to + Point2::Constant(reach_mm);
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

}  // namespace

AidRuns makePrimeLine(const PrimeSettings& settings, const LayerBounds& layer, const Box2& bed,
                      const Regions& occupied) {
  AidRuns line;
  line.bead = beadOfArea(settings.section_mm2, layer.height());
  line.top_mm = layer.top_mm;
  line.order = RunOrder::AsGiven;
  const double margin = line.bead.width_mm;
  const bool is_front = settings.line == PrimeLine::Front;
  const double room = (is_front ? bed.size().x() : bed.size().y()) - 2.0 * margin;
  if (settings.length_mm > room)
    throw InvalidConfig("prime.length_mm is " + millimetres(settings.length_mm) + "; the " +
                        (is_front ? "front" : "left") + " edge of the bed has room for " + millimetres(room));
  const Point2 from = bed.low + Point2::Constant(margin);
  const Point2 to = from + settings.length_mm * (is_front ? Point2::UnitX() : Point2::UnitY());
  const Regions taken = {{rectangleRound(from, to, 0.5 * line.bead.width_mm), {}}};
  if (!intersection(taken, occupied).empty())
    throw InvalidConfig(
        std::string("prime.line is '") + (is_front ? "front" : "left") +
        "', where it would cross the part or what is deposited round it; expected a part farther "
        "from that edge of the bed, or 'none'");
  line.runs = std::make_shared<const std::vector<FillPath>>(
      std::vector<FillPath>{{{from, to}, false, PathRole::Prime, Deposit::Bead, {}}});
  return line;
}

}  // namespace lamina
