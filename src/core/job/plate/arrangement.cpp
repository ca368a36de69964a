// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/arrangement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

/// Footprints on a bed, packed one after the other (`arranged`).
class Packing {
 public:
  static constexpr int kDirections = 16;
  /// How far a footprint reaches in each of the directions, every 22.5 deg from x [mm].
  using Reach = std::array<double, kDirections>;

  Packing(const Box2& bed, double spacing_mm) : bed_(bed), spacing_mm_(spacing_mm) {}

  void addFixed(const Footprint& footprint, const Point2& at);

  /// Place of the next one, which stands there from then on; none if there is no room.
  std::optional<PlatePlace> placed(const Footprint& footprint);

 private:
  struct Standing {
    Reach reach{};
    Point2 at = Point2::Zero();
  };

  std::optional<Point2> lowestLeft(const Reach& reach) const;
  std::vector<double> levels(const Reach& reach, double low, double high) const;
  std::optional<double> leftmost(const Reach& reach, double y, double low, double high) const;
  Reach keptClear(const Standing& standing, const Reach& reach) const;

  Box2 bed_;
  double spacing_mm_;
  std::vector<Standing> standing_;
};

using Reach = Packing::Reach;

constexpr int kCount = Packing::kDirections;
constexpr int kPerEighth = kCount / 8;
constexpr double kTouching = 1e-9;  // mm

// Quarter turns of the directions, as indices.
constexpr std::size_t kRight = 0;
constexpr std::size_t kUp = kCount / 4;
constexpr std::size_t kLeft = kCount / 2;
constexpr std::size_t kDown = 3 * kCount / 4;

Point2 direction(int index) {
  const double angle = 2.0 * M_PI * index / kCount;
  return {std::cos(angle), std::sin(angle)};
}

/// With brim or raft, which keep to the corners of the part as offsets do.
Polygon covered(const Footprint& footprint) {
  if (footprint.beside_mm == 0.0) return footprint.hull;
  const Regions grown = offset({Region{footprint.hull, {}}}, footprint.beside_mm);
  return grown.empty() ? footprint.hull : grown.front().outer;
}

Reach reachOf(const Polygon& hull) {
  Reach reach;
  for (int k = 0; k < kCount; ++k) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Point2& corner : hull) farthest = std::max(farthest, direction(k).dot(corner));
    reach[static_cast<std::size_t>(k)] = farthest;
  }
  return reach;
}

Reach turned(const Reach& reach, int eighths) {
  Reach result;
  for (int k = 0; k < kCount; ++k)
    result[static_cast<std::size_t>(k)] =
        reach[static_cast<std::size_t>((k + kCount - eighths * kPerEighth) % kCount)];
  return result;
}

/// Of the box, from where the reach is counted.
Point2 middleOf(const Reach& reach) {
  return {0.5 * (reach[kRight] - reach[kLeft]), 0.5 * (reach[kUp] - reach[kDown])};
}

/// The x that lie within all edges at that y, open at both ends; low above high if there are none.
std::pair<double, double> within(const Reach& reach, double y) {
  double low = -std::numeric_limits<double>::infinity();
  double high = -low;
  for (int k = 0; k < kCount; ++k) {
    const Point2 normal = direction(k);
    const double rest = reach[static_cast<std::size_t>(k)] - normal.y() * y;
    if (std::abs(normal.x()) < 1e-12) {
      if (rest <= kTouching) return {1.0, -1.0};
    } else if (normal.x() > 0.0) {
      high = std::min(high, rest / normal.x());
    } else {
      low = std::max(low, rest / normal.x());
    }
  }
  return {low, high};
}

void Packing::addFixed(const Footprint& footprint, const Point2& at) {
  standing_.push_back({reachOf(covered(footprint)), at});
}

/// Where the origin of a footprint must not be, seen from that of one that stands.
Packing::Reach Packing::keptClear(const Standing& standing, const Reach& reach) const {
  Reach sum;
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = standing.reach[k] + reach[(k + kCount / 2) % kCount] + spacing_mm_;
  return sum;
}

/// Heights at which the free places change their kind: corners of what must be kept clear.
std::vector<double> Packing::levels(const Reach& reach, double low, double high) const {
  std::vector<double> found = {low};
  for (const Standing& standing : standing_) {
    const Reach clear = keptClear(standing, reach);
    for (int k = 0; k < kCount; ++k) {
      const auto here = static_cast<std::size_t>(k);
      const Point2 a = direction(k);
      const Point2 b = direction(k + 1);
      const double turn = a.x() * b.y() - a.y() * b.x();
      const double y = standing.at.y() + (a.x() * clear[(here + 1) % kCount] - b.x() * clear[here]) / turn;
      if (y > low && y <= high) found.push_back(y);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<double> Packing::leftmost(const Reach& reach, double y, double low, double high) const {
  std::vector<std::pair<double, double>> taken;
  for (const Standing& standing : standing_) {
    const auto [from, to] = within(keptClear(standing, reach), y - standing.at.y());
    if (from < to) taken.emplace_back(standing.at.x() + from, standing.at.x() + to);
  }
  std::sort(taken.begin(), taken.end());
  double x = low;
  for (const auto& [from, to] : taken)
    if (from < x - kTouching && x < to - kTouching) x = to;
  return x <= high ? std::optional(x) : std::nullopt;
}

std::optional<Point2> Packing::lowestLeft(const Reach& reach) const {
  const Point2 low = bed_.low + Point2(reach[kLeft], reach[kDown]);
  const Point2 high = bed_.high - Point2(reach[kRight], reach[kUp]);
  if (low.x() > high.x() || low.y() > high.y()) return std::nullopt;
  for (const double y : levels(reach, low.y(), high.y()))
    if (const std::optional<double> x = leftmost(reach, y, low.x(), high.x())) return Point2(*x, y);
  return std::nullopt;
}

std::optional<PlatePlace> Packing::placed(const Footprint& footprint) {
  const Reach upright = reachOf(covered(footprint));
  const Reach of_part = reachOf(footprint.hull);
  std::optional<PlatePlace> best;
  Standing standing;
  double least_top = std::numeric_limits<double>::infinity();
  for (int eighths = 0; eighths < 8; ++eighths) {
    const Reach reach = turned(upright, eighths);
    const std::optional<Point2> at = lowestLeft(reach);
    if (!at || at->y() + reach[kUp] >= least_top - kTouching) continue;
    least_top = at->y() + reach[kUp];
    best = PlatePlace{*at + middleOf(turned(of_part, eighths)), eighths};
    standing = {reach, *at};
  }
  if (best) standing_.push_back(standing);
  return best;
}

Box2 boxAt(const Footprint& footprint, const Point2& at) {
  Box2 box = boundingBox({covered(footprint)});
  box.low += at;
  box.high += at;
  return box;
}

bool areApart(const Box2& a, const Box2& b, double by_mm) {
  return (a.low.array() >= b.high.array() + by_mm).any() || (b.low.array() >= a.high.array() + by_mm).any();
}

/// Fills rows from the left, past what already stands.
class Rows {
 public:
  Rows(const Box2& bed, double spacing_mm) : bed_(bed), spacing_mm_(spacing_mm), next_(bed.low) {}

  void addObstacle(const Box2& box) { obstacles_.push_back(box); }

  /// @return lower left corner; none if there is no room
  std::optional<Point2> placed(const Point2& size) {
    while (next_.y() + size.y() <= bed_.high.y()) {
      while (next_.x() + size.x() <= bed_.high.x()) {
        const Box2 box{next_, next_ + size};
        const Box2* const hindrance = hindranceOf(box);
        if (hindrance == nullptr) {
          depth_mm_ = std::max(depth_mm_, size.y());
          next_.x() = box.high.x() + spacing_mm_;
          return box.low;
        }
        next_.x() = hindrance->high.x() + spacing_mm_;
      }
      if (!beginRow()) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const Box2* hindranceOf(const Box2& box) const {
    for (const Box2& obstacle : obstacles_)
      if (!areApart(box, obstacle, spacing_mm_)) return &obstacle;
    return nullptr;
  }

  /// An empty row begins again where the next obstacle ends.
  bool beginRow() {
    double step_mm = depth_mm_ + spacing_mm_;
    if (depth_mm_ == 0.0) {
      step_mm = std::numeric_limits<double>::infinity();
      for (const Box2& obstacle : obstacles_)
        if (obstacle.high.y() + spacing_mm_ > next_.y())
          step_mm = std::min(step_mm, obstacle.high.y() + spacing_mm_ - next_.y());
    }
    next_ = {bed_.low.x(), next_.y() + step_mm};
    depth_mm_ = 0.0;
    return std::isfinite(step_mm);
  }

  Box2 bed_;
  double spacing_mm_;
  Point2 next_;
  double depth_mm_ = 0.0;
  std::vector<Box2> obstacles_;
};

[[noreturn]] void refuseForRoom(const Footprint& footprint, const Box2& bed, double spacing_mm) {
  const Point2 size = boxAt(footprint, Point2::Zero()).size();
  char text[256];
  std::snprintf(
      text, sizeof text,
      "part '%s' of %.4g x %.4g mm%s finds no room: parts and skirt may cover %.4g x %.4g mm of the bed, "
      "%.4g mm apart (plate.spacing_mm)",
      footprint.name.c_str(), size.x(), size.y(), footprint.beside_mm > 0.0 ? " with brim or raft" : "",
      bed.size().x(), bed.size().y(), spacing_mm);
  throw Unreachable(text);
}

std::vector<PlatePlace> inRows(const std::vector<Footprint>& footprints, const Box2& bed, double spacing_mm) {
  Rows rows(bed, spacing_mm);
  for (const Footprint& footprint : footprints)
    if (footprint.at_mm) rows.addObstacle(boxAt(footprint, *footprint.at_mm));
  std::vector<PlatePlace> places;
  for (const Footprint& footprint : footprints) {
    places.push_back({footprint.at_mm.value_or(Point2::Zero()), 0});
    if (footprint.at_mm) continue;
    const Box2 box = boxAt(footprint, Point2::Zero());
    const std::optional<Point2> corner = rows.placed(box.size());
    if (!corner) refuseForRoom(footprint, bed, spacing_mm);
    places.back().at_mm = *corner - box.low;
  }
  return places;
}

std::vector<PlatePlace> packed(const std::vector<Footprint>& footprints, const Box2& bed, double spacing_mm) {
  Packing packing(bed, spacing_mm);
  std::vector<PlatePlace> places(footprints.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!footprints[i].at_mm) {
      order.push_back(i);
      continue;
    }
    places[i].at_mm = *footprints[i].at_mm;
    packing.addFixed(footprints[i], places[i].at_mm);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return signedArea(footprints[a].hull) > signedArea(footprints[b].hull);
  });
  for (const std::size_t i : order) {
    const std::optional<PlatePlace> place = packing.placed(footprints[i]);
    if (!place) refuseForRoom(footprints[i], bed, spacing_mm);
    places[i] = *place;
  }
  return places;
}

/// Of the hull as it is turned, with brim or raft.
Box2 turnedBox(const Footprint& footprint, const PlatePlace& place) {
  Box2 box;
  Box2 whole;
  const Eigen::Rotation2D<double> turn(place.eighths * M_PI / 4.0);
  for (const Point2& corner : footprint.hull) box.include(turn * corner);
  for (const Point2& corner : covered(footprint)) whole.include(turn * corner);
  const Point2 half = 0.5 * box.size();
  return {place.at_mm - half - (box.low - whole.low), place.at_mm + half + (whole.high - box.high)};
}

/// On the bed with all that is laid beside parts; where that has no room, with brims that end at its edge.
std::vector<PlatePlace> placedOn(const Box2& bed, const std::vector<Footprint>& footprints,
                                 const PlateSettings& settings) {
  const auto within = [&](const Box2& area) {
    return settings.arrangement == PlateArrangement::Pack ? packed(footprints, area, settings.spacing_mm)
                                                          : inRows(footprints, area, settings.spacing_mm);
  };
  double cut_mm = footprints.empty() ? 0.0 : footprints.front().cut_mm;
  for (const Footprint& footprint : footprints) cut_mm = std::min(cut_mm, footprint.cut_mm);
  if (cut_mm == 0.0) return within(bed);
  try {
    return within(bed);
  } catch (const Unreachable&) {
    const Point2 beyond = Point2::Constant(cut_mm);
    return within({bed.low - beyond, bed.high + beyond});
  }
}

}  // namespace

std::vector<PlatePlace> arranged(const std::vector<Footprint>& footprints, const Box2& bed,
                                 const PlateSettings& settings) {
  // What is laid beside a part alone on the bed ends at the bed's edge.
  if (footprints.size() == 1 && footprints.front().beside_mm > 0.0) {
    Footprint bare = footprints.front();
    bare.beside_mm = bare.cut_mm = 0.0;
    return arranged({bare}, bed, settings);
  }
  std::vector<PlatePlace> places = placedOn(bed, footprints, settings);
  if (std::any_of(footprints.begin(), footprints.end(),
                  [](const Footprint& f) { return f.at_mm.has_value(); }))
    return places;
  Box2 all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Box2 box = turnedBox(footprints[i], places[i]);
    all.include(box.low);
    all.include(box.high);
  }
  const Point2 shift = bed.centre() - all.centre();
  for (PlatePlace& place : places) place.at_mm += shift;
  return places;
}

}  // namespace lamina
