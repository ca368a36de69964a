// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/aids_apart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "geometry/spatial/edge_grid.hpp"
#include "lamina/base/error.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Beads that lap over by less lie side by side [mm].
constexpr double kSideBySide = 0.01;
/// Of layers that touch, heights differ by rounding [mm].
constexpr double kSameLevel = 1e-6;

enum class Laid { All, Aids };

/// A bead as it lies on the plate.
struct LaidBead {
  PathRole role = PathRole::Support;
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  double half_width_mm = 0.0;
  double low_z = 0.0;
  double high_z = 0.0;

  Box3 box() const {
    const Point2 low = from.cwiseMin(to).array() - half_width_mm;
    const Point2 high = from.cwiseMax(to).array() + half_width_mm;
    return {{low.x(), low.y(), low_z}, {high.x(), high.y(), high_z}};
  }
};

bool lapOver(const Box3& a, const Box3& b) {
  return !a.isEmpty() && !b.isEmpty() && (a.low.array() < b.high.array() - kSameLevel).all() &&
         (b.low.array() < a.high.array() - kSameLevel).all();
}

double pointToLine(const Point2& point, const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - from - t * along).norm();
}

bool linesCross(const LaidBead& a, const LaidBead& b) {
  const auto side = [](const LaidBead& bead, const Point2& point) {
    const Point2 along = bead.to - bead.from;
    const Point2 off = point - bead.from;
    return along.x() * off.y() - along.y() * off.x();
  };
  return side(a, b.from) * side(a, b.to) < 0.0 && side(b, a.from) * side(b, a.to) < 0.0;
}

bool beadsMeet(const LaidBead& a, const LaidBead& b) {
  if (!lapOver(a.box(), b.box())) return false;
  if (linesCross(a, b)) return true;
  const double apart = std::min({pointToLine(a.from, b.from, b.to), pointToLine(a.to, b.from, b.to),
                                 pointToLine(b.from, a.from, a.to), pointToLine(b.to, a.from, a.to)});
  return apart < a.half_width_mm + b.half_width_mm - kSideBySide;
}

/// Calls `visit(bead)` for what a layer of a part lays.
template <class Visit>
void forEachLaid(const ToolpathLayer& layer, const Point3& at, Laid which, const Visit& visit) {
  for (const Path& path : layer.paths) {
    if (!laysBeads(path) || (which == Laid::Aids && isPartOfPart(path))) continue;
    forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
      if (segment.isEmpty()) return;
      const double top = at.z() + std::max(segment.start.z(), segment.end.z());
      visit(LaidBead{path.role, (segment.start + at).head<2>(), (segment.end + at).head<2>(),
                     0.5 * planWidth(segment.bead), top - segment.bead.height_mm, top});
    });
  }
}

/// Box of what each layer of a part lays, and of all.
struct LaidBoxes {
  std::vector<Box3> layers;
  Box3 whole;
};

LaidBoxes boxesOf(const PlateToolpath& part, Laid which) {
  LaidBoxes boxes;
  boxes.layers.resize(part.toolpath->layers.size());
  for (std::size_t i = 0; i < boxes.layers.size(); ++i) {
    Box3& box = boxes.layers[i];
    forEachLaid(part.toolpath->layers[i], part.at, which, [&box](const LaidBead& bead) {
      const Box3 of_bead = bead.box();
      box.include(of_bead.low);
      box.include(of_bead.high);
    });
    if (box.isEmpty()) continue;
    boxes.whole.include(box.low);
    boxes.whole.include(box.high);
  }
  return boxes;
}

std::vector<LaidBead> beadsWithin(const Box3& box, const ToolpathLayer& layer, const Point3& at, Laid which) {
  std::vector<LaidBead> beads;
  forEachLaid(layer, at, which, [&](const LaidBead& bead) {
    if (lapOver(bead.box(), box)) beads.push_back(bead);
  });
  return beads;
}

void requireBeadsApart(const PlateToolpath& owner, const std::vector<LaidBead>& aids,
                       const PlateToolpath& other, const std::vector<LaidBead>& laid) {
  std::vector<std::pair<Point2, Point2>> lines;
  lines.reserve(laid.size());
  double widest = 0.0;
  for (const LaidBead& bead : laid) {
    lines.emplace_back(bead.from, bead.to);
    widest = std::max(widest, bead.half_width_mm);
  }
  const EdgeGrid grid(lines);
  for (const LaidBead& aid : aids) {
    const Box3 box = aid.box();
    const Point2 reach = Point2::Constant(widest);
    grid.forEdgesNear({box.low.head<2>() - reach, box.high.head<2>() + reach}, [&](std::size_t i) {
      if (!beadsMeet(aid, laid[i])) return;
      const Point2 place = 0.5 * (aid.from + aid.to);
      char text[256];
      std::snprintf(text, sizeof text,
                    "' at z %.4g mm, about (%.2f, %.2f) mm of the bed; expected parts that are farther apart "
                    "(at_mm, plate.spacing_mm)",
                    aid.high_z, place.x(), place.y());
      throw InvalidInput("parts '" + owner.name + "' and '" + other.name +
                         "' overlap: " + toString(aid.role) + " of '" + owner.name + "' meets " +
                         toString(laid[i].role) + " of '" + other.name + text);
    });
  }
}

}  // namespace

void requireAidsApart(const std::vector<PlateToolpath>& parts) {
  std::vector<LaidBoxes> aids;
  std::vector<LaidBoxes> all;
  aids.reserve(parts.size());
  all.reserve(parts.size());
  for (const PlateToolpath& part : parts) aids.push_back(boxesOf(part, Laid::Aids));
  const auto hasNone = [](const LaidBoxes& boxes) { return boxes.whole.isEmpty(); };
  if (std::all_of(aids.begin(), aids.end(), hasNone)) return;
  for (const PlateToolpath& part : parts) all.push_back(boxesOf(part, Laid::All));
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (!lapOver(aids[a].whole, all[b].whole)) return;
    for (std::size_t i = 0; i < aids[a].layers.size(); ++i) {
      const Box3& of_a = aids[a].layers[i];
      for (std::size_t k = 0; k < all[b].layers.size(); ++k) {
        const Box3& of_b = all[b].layers[k];
        if (!lapOver(of_a, of_b)) continue;
        const std::vector<LaidBead> held =
            beadsWithin(of_b, parts[a].toolpath->layers[i], parts[a].at, Laid::Aids);
        const std::vector<LaidBead> laid =
            beadsWithin(of_a, parts[b].toolpath->layers[k], parts[b].at, Laid::All);
        requireBeadsApart(parts[a], held, parts[b], laid);
      }
    }
  };
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = 0; b < parts.size(); ++b)
      if (a != b) compare(a, b);
}

}  // namespace lamina
