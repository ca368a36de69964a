// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/adhesion/brim.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kSharpCorner = toRadians(100.0);  // within the part
constexpr int kEarSides = 48;

/// Where an edge crosses the borders, as shares of it, with both its ends.
std::vector<double> crossingsOf(const Point2& from, const Point2& to, const std::vector<Polygon>& borders) {
  std::vector<double> shares = {0.0, 1.0};
  const Point2 way = to - from;
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const Point2 edge = border[i] - border[j];
      const double across = way.x() * edge.y() - way.y() * edge.x();
      if (across == 0.0) continue;
      const Point2 apart = border[j] - from;
      const double on_edge = (apart.x() * way.y() - apart.y() * way.x()) / across;
      const double share = (apart.x() * edge.y() - apart.y() * edge.x()) / across;
      if (on_edge >= 0.0 && on_edge <= 1.0 && share > 0.0 && share < 1.0) shares.push_back(share);
    }
  std::sort(shares.begin(), shares.end());
  return shares;
}

Regions earsAt(const Regions& first_layer, double radius_mm) {
  std::vector<Polygon> ears;
  for (const Region& region : first_layer) {
    const Polygon& outline = region.outer;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      const Point2 before = outline[i] - outline[j];
      const Point2 after = outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i];
      const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
      if (M_PI - turn >= kSharpCorner) continue;
      Polygon ear;
      for (int k = 0; k < kEarSides; ++k) {
        const double angle = 2.0 * M_PI * k / kEarSides;
        ear.push_back(outline[i] + radius_mm * Point2(std::cos(angle), std::sin(angle)));
      }
      ears.push_back(std::move(ear));
    }
  }
  return unite(ears);
}

/// Whole outlines without their holes.
Regions filled(const Regions& regions) {
  std::vector<Polygon> outers;
  for (const Region& region : regions) outers.push_back(region.outer);
  return unite(outers);
}

/// Areas that a brim grows away from, one round the part and one within it.
struct BrimBase {
  Regions part;   ///< to be grown
  Regions holes;  ///< to be shrunk
};

Regions nearerThan(const BrimBase& base, double distance_mm) {
  Regions near = base.part.empty() ? Regions{} : difference(offset(base.part, distance_mm), base.part);
  if (base.holes.empty()) return near;
  Regions within = difference(base.holes, offset(base.holes, -distance_mm));
  std::move(within.begin(), within.end(), std::back_inserter(near));
  return near;
}

std::vector<Polygon> loopsAt(const BrimBase& base, double distance_mm) {
  std::vector<Polygon> loops = outlines(offset(base.part, distance_mm));
  std::vector<Polygon> within = outlines(offset(base.holes, -distance_mm));
  std::move(within.begin(), within.end(), std::back_inserter(loops));
  return loops;
}

}  // namespace

std::vector<FillPath> piecesWithin(const Polygon& loop, const Regions& regions, PathRole role) {
  const std::vector<Polygon> borders = outlines(regions);
  std::vector<Polyline> pieces;
  bool is_whole = true;
  bool is_open = false;  // the last piece goes on
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2& from = loop[i];
    const Point2& to = loop[i + 1 < loop.size() ? i + 1 : 0];
    const std::vector<double> shares = crossingsOf(from, to, borders);
    for (std::size_t s = 1; s < shares.size(); ++s) {
      const auto at = [&](double share) -> Point2 { return from + share * (to - from); };
      const bool is_inside = contains(borders, at(0.5 * (shares[s - 1] + shares[s])));
      is_whole = is_whole && is_inside;
      if (is_inside && !is_open) pieces.push_back({at(shares[s - 1])});
      if (is_inside) pieces.back().push_back(at(shares[s]));
      is_open = is_inside;
    }
  }
  if (is_whole) return {{loop, true, role, Deposit::Bead, {}}};
  if (is_open && pieces.size() > 1 && pieces.front().front() == loop.front()) {
    pieces.back().insert(pieces.back().end(), pieces.front().begin() + 1, pieces.front().end());
    pieces.front() = std::move(pieces.back());
    pieces.pop_back();
  }
  std::vector<FillPath> runs;
  runs.reserve(pieces.size());
  for (Polyline& piece : pieces) runs.push_back({std::move(piece), false, role, Deposit::Bead, {}});
  return runs;
}

Brim makeBrim(const Regions& first_layer, const BrimSettings& settings, double pitch_mm,
              const std::optional<Box2>& bed) {
  Brim brim;
  const auto count = static_cast<int>(std::lround(settings.width_mm / pitch_mm));
  if (count == 0 || first_layer.empty()) return brim;
  const Regions whole = filled(first_layer);
  BrimBase base;
  if (settings.where != BrimWhere::Inside) base.part = whole;
  if (settings.where != BrimWhere::Outside) base.holes = difference(whole, first_layer);
  brim.area = nearerThan(base, settings.gap_mm + count * pitch_mm);
  if (settings.gap_mm > 0.0) brim.area = difference(brim.area, nearerThan(base, settings.gap_mm));
  std::optional<Regions> allowed;
  if (settings.ears) allowed = earsAt(first_layer, settings.width_mm);
  if (bed) {
    const Regions on_bed = {
        {{bed->low, {bed->high.x(), bed->low.y()}, bed->high, {bed->low.x(), bed->high.y()}}, {}}};
    allowed = allowed ? intersection(*allowed, on_bed) : on_bed;
  }
  if (allowed) brim.area = intersection(brim.area, *allowed);
  for (int i = count; i-- > 0;)
    for (Polygon& loop : loopsAt(base, settings.gap_mm + (i + 0.5) * pitch_mm)) {
      std::vector<FillPath> runs =
          allowed ? piecesWithin(loop, *allowed, PathRole::Brim)
                  : std::vector<FillPath>{{std::move(loop), true, PathRole::Brim, Deposit::Bead, {}}};
      std::move(runs.begin(), runs.end(), std::back_inserter(brim.runs));
    }
  return brim;
}

}  // namespace lamina
