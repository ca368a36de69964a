// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/arrival_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace lamina {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-12;
// Of a cell: by so little later than level growth, bits being steps, is level.
constexpr double kPull = 1e-6;  // of the pull on a turn: less along an axis is none
constexpr std::size_t kReportEvery = 4096;

/// Where the straight end of a way begins.
struct WayTurn {
  Point3 at = Point3::Zero();
  double growth_mm = 0.0;
  std::uint32_t stand = CellGraph::kNone;  // node on the bed that it lies in; none if not on the bed
};

struct WayOffer {
  double growth_mm = kInfinite;
  double across_mm = kInfinite;  // of equal ways the more upright one is taken
  WayTurn turn;
};

bool isBetter(const WayOffer& a, const WayOffer& b) {
  if (a.growth_mm == kInfinite) return false;
  if (a.growth_mm < b.growth_mm - kSame) return true;
  return a.growth_mm <= b.growth_mm + kSame && a.across_mm < b.across_mm - kSame;
}

double squaredDistance(double from, double low, double high) {
  const double beside = from - std::clamp(from, low, high);
  return beside * beside;
}

/// A corner of bits of a cell, counted in bits from the cell's own.
struct BitCorner {
  int x = 0;
  int y = 0;
  int z = 0;
  std::uint64_t around = 0;  // the bits of the cell that it is a corner of
  bool is_within = false;    // these are all that there are
};

constexpr std::size_t kCornersAlong = CellGraph::kBits + 1;

constexpr std::array<BitCorner, kCornersAlong * kCornersAlong * kCornersAlong> bitCorners() {
  std::array<BitCorner, kCornersAlong * kCornersAlong * kCornersAlong> corners{};
  for (std::size_t number = 0; number < corners.size(); ++number) {
    BitCorner& corner = corners[number];
    corner.x = static_cast<int>(number % kCornersAlong);
    corner.y = static_cast<int>(number / kCornersAlong % kCornersAlong);
    corner.z = static_cast<int>(number / kCornersAlong / kCornersAlong);
    int count = 0;
    for (int bit = 0; bit < 64; ++bit) {
      const int x = corner.x - bit % 4;
      const int y = corner.y - bit / 4 % 4;
      const int z = corner.z - bit / 16;
      if (x < 0 || x > 1 || y < 0 || y > 1 || z < 0 || z > 1) continue;
      corner.around |= std::uint64_t{1} << bit;
      ++count;
    }
    corner.is_within = count == 8;
  }
  return corners;
}

constexpr auto kCorners = bitCorners();

class GrowthMarch {
 public:
  GrowthMarch(const CellGraph& cells, const GrowthGauge& gauge, const GrowthBed& bed)
      : cells_(cells),
        gauge_(gauge),
        bed_(bed),
        best_(cells.nodeCount()),
        tried_(cells.nodeCount(), CellGraph::kNone),
        is_settled_(cells.nodeCount(), 0),
        is_checked_(cells.nodeCount(), 0),
        is_shaded_(cells.nodeCount(), 0) {}

  ArrivalField run(Progress& progress) && {
    ArrivalField field;
    findStands(field);
    std::size_t settled = 0;
    while (!queue_.empty()) {
      const auto [growth, node] = queue_.top();
      queue_.pop();
      if (is_settled_[node] != 0 || growth != best_[node].growth_mm) continue;
      if (is_checked_[node] == 0 && !isOpen(node)) {
        shade(node);
        continue;
      }
      is_settled_[node] = 1;
      for (const std::uint32_t next : cells_.links(node))
        if (is_settled_[next] == 0) spread(node, next);
      if (++settled % kReportEvery != 0) continue;
      throwIfCancelled(progress, "field");
      progress.report("field", static_cast<double>(settled) / cells_.nodeCount());
    }
    finish(field);
    return field;
  }

 private:
  double rise(std::uint32_t node) const { return cells_.middle(node).z() - bed_.level_mm; }

  /// The row of bits that stands on the bed, counted through all cells.
  int contactRow() const {
    const double above = bed_.level_mm - cells_.frame().corner.z();
    const int lowest = static_cast<int>(std::ceil(above / cells_.bitSide() - 0.5 - 1e-6));
    const int row = static_cast<int>(std::floor((above + bed_.contact_mm) / cells_.bitSide()));
    return std::clamp(row, lowest, lowest + CellGraph::kBits - 1 - lowest % CellGraph::kBits);
  }

  void findStands(ArrivalField& field) {
    const int row = contactRow();
    const double area = cells_.bitSide() * cells_.bitSide();
    columns_.assign(cells_.nodeCount(), 0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (cells_.cell(node)[2] != row / CellGraph::kBits) continue;
      columns_[node] = static_cast<std::uint16_t>(cells_.bits(node) >> (16 * (row % CellGraph::kBits)));
      if (columns_[node] == 0) continue;
      ++field.stands;
      for (unsigned rest = columns_[node]; rest != 0; rest &= rest - 1) field.contact_mm2 += area;
    }
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (columns_[node] != 0) take(node, fromStand(node, node));
  }

  /// The way to a node from the nearest place of what stands on the bed in another.
  WayOffer fromStand(std::uint32_t node, std::uint32_t stand) const {
    const Point3& to = cells_.middle(node);
    const Point3 corner = cells_.corner(stand);
    const double bit = cells_.bitSide();
    Point2 best = corner.head<2>();
    double nearest = kInfinite;
    if (columns_[stand] == 0xFFFFU) {
      const double side = CellGraph::kBits * bit;
      best = Point2(std::clamp(to.x(), corner.x(), corner.x() + side),
                    std::clamp(to.y(), corner.y(), corner.y() + side));
    } else {
      for (int column = 0; column < 16; ++column) {
        if ((columns_[stand] >> column & 1U) == 0) continue;
        const double x = corner.x() + (column % 4) * bit;
        const int row = column / 4;
        const double y = corner.y() + row * bit;
        const double squared = squaredDistance(to.x(), x, x + bit) + squaredDistance(to.y(), y, y + bit);
        if (squared >= nearest) continue;
        nearest = squared;
        best = Point2(std::clamp(to.x(), x, x + bit), std::clamp(to.y(), y, y + bit));
      }
    }
    WayTurn turn{Point3(best.x(), best.y(), bed_.level_mm), 0.0, stand};
    return from(node, turn);
  }

  WayOffer from(std::uint32_t node, const WayTurn& turn) const {
    const Point3 way = cells_.middle(node) - turn.at;
    return {turn.growth_mm + gauge_.cost(way), way.head<2>().norm(), turn};
  }

  /// From the best place on the bed that is found by going from node to node of what stands there.
  WayOffer overBed(std::uint32_t node, WayOffer offer) const {
    for (;;) {
      WayOffer best = offer;
      for (const std::uint32_t stand : cells_.links(offer.turn.stand)) {
        if (columns_[stand] == 0) continue;
        const WayOffer other = fromStand(node, stand);
        if (isBetter(other, best)) best = other;
      }
      if (best.turn.stand == offer.turn.stand) return offer;
      offer = best;
    }
  }

  /// The best way to `node` that begins as that to `by` does.
  WayOffer onwards(std::uint32_t by, std::uint32_t node) {
    const WayTurn& turn = best_[by].turn;
    if (turn.stand == CellGraph::kNone) return from(node, turn);
    if (tried_[node] == turn.stand) return {};
    tried_[node] = turn.stand;
    const WayOffer offer = fromStand(node, turn.stand);
    return isBetter(offer, best_[node]) || is_shaded_[node] != 0 ? overBed(node, offer) : WayOffer{};
  }

  /// The way to a node that turns at a linked one: at the corner of its bits that makes it shortest, of those
  /// that hold it and that it leads to and from within the part.
  WayOffer turnedAt(std::uint32_t by, std::uint32_t node) {
    WayOffer middle = from(node, {cells_.middle(by), best_[by].growth_mm, CellGraph::kNone});
    if (middle.growth_mm > best_[node].growth_mm + 2.0 * cells_.frame().voxel_mm) return {};
    findCorners(by, node, isBetter(middle, best_[node]) ? middle : best_[node]);
    const Point3& before = best_[by].turn.at;
    const NodePlace end{node, cells_.middle(node)};
    for (const WayOffer& corner : corners_) {
      const Point3& at = corner.turn.at;
      if (isHeld(before, at, end.at) && cells_.isClear(end, at) && cells_.isClear({by, at}, before))
        return corner;
    }
    return middle;
  }

  /// Whether a way that turns at a corner of bits is held there: it would be shorter only beside the part.
  bool isHeld(const Point3& before, const Point3& at, const Point3& after) const {
    const Point3 pull = gauge_.gradient(after - at) - gauge_.gradient(at - before);
    const double least = kPull * pull.cwiseAbs().maxCoeff();
    for (int octant = 0; octant < 8; ++octant) {
      Point3 beside = at;
      bool is_pulled_there = true;
      for (int axis = 0; axis < 3; ++axis) {
        const double side = (octant >> axis & 1) != 0 ? 1.0 : -1.0;
        beside[axis] += side * 0.5 * cells_.bitSide();
        is_pulled_there = is_pulled_there && side * pull[axis] >= -least;
      }
      if (is_pulled_there && cells_.nodeAt(beside) != CellGraph::kNone) return false;
    }
    return true;
  }

  /// Ways to a node that turn at corners of the bits of a linked one, where these may be edges of the part:
  /// those that are better than one that is known, the best first.
  void findCorners(std::uint32_t by, std::uint32_t node, const WayOffer& known) {
    const WayTurn& before = best_[by].turn;
    const Point3 corner = cells_.corner(by);
    const std::uint64_t bits = cells_.bits(by);
    corners_.clear();
    for (const BitCorner& place : kCorners) {
      const std::uint64_t solid = bits & place.around;
      if (solid == 0 || (solid == place.around && place.is_within)) continue;
      const Point3 at = corner + cells_.bitSide() * Point3(place.x, place.y, place.z);
      const double growth = before.growth_mm + gauge_.cost(at - before.at);
      const WayOffer offer = from(node, {at, growth, CellGraph::kNone});
      if (isBetter(offer, known)) corners_.push_back(offer);
    }
    std::sort(corners_.begin(), corners_.end(), isBetter);
  }

  void take(std::uint32_t node, const WayOffer& offer) {
    if (!isBetter(offer, best_[node])) return;
    best_[node] = offer;
    is_checked_[node] = is_shaded_[node];
    queue_.push({offer.growth_mm, node});
  }

  void spread(std::uint32_t by, std::uint32_t node) {
    if (is_shaded_[node] == 0) return take(node, onwards(by, node));
    tried_[node] = CellGraph::kNone;
    const WayOffer offer = onwards(by, node);
    if (!isBetter(offer, best_[node])) return;  // nor is one that turns
    take(node, cells_.isClear({node, cells_.middle(node)}, offer.turn.at) ? offer : turnedAt(by, node));
  }

  /// Whether the straight end of a node's way is in the part. Level growth above level growth is.
  bool isOpen(std::uint32_t node) const {
    constexpr double kLevel = 1e-9;
    if (best_[node].growth_mm - rise(node) <= kLevel)
      for (const std::uint32_t below : cells_.links(node)) {
        if (is_settled_[below] == 0 || best_[below].growth_mm - rise(below) > kLevel) continue;
        const Point3 way = cells_.middle(node) - cells_.middle(below);
        if (way.z() > 0.0 && gauge_.cost(way) <= way.z() + kSame) return true;
      }
    return cells_.isClear({node, cells_.middle(node)}, best_[node].turn.at);
  }

  /// A node from which the turn of its way is not seen: from now on what it is offered is looked at.
  void shade(std::uint32_t node) {
    is_shaded_[node] = 1;
    best_[node] = {};
    for (const std::uint32_t by : cells_.links(node))
      if (is_settled_[by] != 0) spread(by, node);
  }

  void finish(ArrivalField& field) const {
    const std::uint32_t count = cells_.nodeCount();
    field.growth_mm.assign(count, kInfinite);
    field.turn.assign(count, Point3::Zero());
    field.turn_mm.assign(count, 0.0);
    field.is_level.assign(count, 0);
    field.bed_mm = bed_.level_mm;
    const double tolerance = kLevelCells * cells_.frame().voxel_mm;
    for (std::uint32_t node = 0; node < count; ++node) {
      if (is_settled_[node] == 0) continue;
      const WayOffer& best = best_[node];
      field.growth_mm[node] = best.growth_mm;
      field.turn[node] = best.turn.at;
      field.turn_mm[node] = best.turn.growth_mm;
      if (best.growth_mm - rise(node) > tolerance) continue;
      field.growth_mm[node] = rise(node);
      field.is_level[node] = 1;
    }
  }

  using Arrival = std::pair<double, std::uint32_t>;

  const CellGraph& cells_;
  const GrowthGauge& gauge_;
  GrowthBed bed_;
  std::vector<WayOffer> best_;
  std::vector<std::uint32_t> tried_;    // stand from which a way to the node was looked for last
  std::vector<std::uint16_t> columns_;  // of bits that stand on the bed, by node
  std::vector<char> is_settled_;
  std::vector<char> is_checked_;  // its way is known to be in the part
  std::vector<char> is_shaded_;
  std::vector<WayOffer> corners_;  // of the node at which a way may turn
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue_;
};

}  // namespace

GrowthAt ArrivalField::near(const Point3& place, std::uint32_t node, const Point3& middle,
                            const GrowthGauge& gauge) const {
  if (is_level[node] != 0) return {place.z() - bed_mm, Point3::UnitZ()};
  if (!fitted_gradient.empty())
    return {growth_mm[node] + fitted_gradient[node].dot(place - middle), fitted_gradient[node]};
  const Point3 way = place - turn[node];
  const double cost = gauge.cost(way);
  if (std::isfinite(cost)) return {turn_mm[node] + cost, gauge.gradient(way)};
  const Point3 gradient = gauge.gradient(middle - turn[node]);
  return {growth_mm[node] + gradient.dot(place - middle), gradient};
}

ArrivalField arrivalField(const CellGraph& cells, const GrowthGauge& gauge, const GrowthBed& bed,
                          Progress& progress) {
  return GrowthMarch(cells, gauge, bed).run(progress);
}

}  // namespace lamina
