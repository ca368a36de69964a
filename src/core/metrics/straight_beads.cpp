// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics/straight_beads.hpp"

#include <cstddef>

#include "toolpath/bead_space.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kSamePlace = 1e-6;  // mm, as paths join
constexpr double kNoMotion = 1e-9;   // mm
constexpr double kStraight = 1e-4;   // rad
constexpr std::size_t kNone = ~std::size_t{0};

/// Chains pieces as they come.
class Chain {
 public:
  void addDrop(const StraightBead& drop) {
    breakOff();
    pieces_.push_back(drop);
  }

  void add(StraightBead piece) {
    const Point3 way = piece.end - piece.start;
    const double length = way.norm();
    if (length < kNoMotion) return;
    const Point3 direction = way / length;
    const bool is_joined = last_ != kNone && (pieces_[last_].end - piece.start).norm() <= kSamePlace;
    if (!is_joined) first_ = pieces_.size();
    if (is_joined && prolong(piece, direction)) return;
    if (is_joined) {
      pieces_[last_].after = direction;
      piece.before = direction_;
    }
    last_ = pieces_.size();
    direction_ = direction;
    pieces_.push_back(piece);
  }

  void breakOff() { last_ = kNone; }

  /// Joins the run's last piece to its first, if they meet.
  void close() {
    if (last_ == kNone || last_ == first_) return;
    StraightBead& first = pieces_[first_];
    if ((pieces_[last_].end - first.start).norm() > kSamePlace) return;
    pieces_[last_].after = (first.end - first.start).normalized();
    first.before = direction_;
  }

  std::vector<StraightBead> take() { return std::move(pieces_); }

 private:
  bool prolong(const StraightBead& piece, const Point3& direction) {
    StraightBead& last = pieces_[last_];
    const bool is_same = last.bead == piece.bead && (last.tool_axis - piece.tool_axis).norm() < kStraight;
    if (!is_same || direction_.cross(direction).norm() > kStraight || direction_.dot(direction) < 0.0)
      return false;
    // The whole must stay straight, not only each step.
    const Point3 whole = (piece.end - last.start).normalized();
    if (whole.cross(direction).norm() > kStraight) return false;
    last.end = piece.end;
    direction_ = whole;
    return true;
  }

  std::vector<StraightBead> pieces_;
  std::size_t first_ = 0;     // of the run
  std::size_t last_ = kNone;  // none where a run may begin
  Point3 direction_ = Point3::Zero();
};

Point3 placeAt(const Path& path, std::size_t waypoint, const Bead& bead, BeadLine line) {
  if (line == BeadLine::Tip) return path.points[waypoint];
  return sectionMiddle(path.points[waypoint], bead.height_mm, upAt(path, waypoint));
}

void addDrop(const Path& path, const DepositedSegment& segment, BeadLine line, Chain& chain) {
  if (!(segment.bead.width_mm > 0.0)) return;
  StraightBead drop;
  drop.bead = segment.bead;
  drop.plan_width_mm = drop.bead.width_mm;
  drop.tool_axis = -upAt(path, segment.waypoint);
  drop.start = drop.end = placeAt(path, segment.waypoint, drop.bead, line);
  chain.addDrop(drop);
}

void addBead(const Path& path, const DepositedSegment& segment, BeadLine line, Chain& chain) {
  if (!(segment.bead.width_mm > 0.0)) return chain.breakOff();
  StraightBead piece;
  piece.bead = segment.bead;
  piece.plan_width_mm = planWidth(piece.bead);
  piece.tool_axis = -upAt(path, segment.waypoint);
  piece.start = placeAt(path, segment.from, piece.bead, line);
  piece.end = placeAt(path, segment.waypoint, piece.bead, line);
  chain.add(piece);
}

void addPath(const Path& path, BeadLine line, Chain& chain) {
  if (path.role == PathRole::Travel) return chain.breakOff();
  const bool is_drops = path.deposit == Deposit::Drops;
  const bool is_loop = path.is_closed && !is_drops;
  if (is_loop) chain.breakOff();
  forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
    is_drops ? addDrop(path, segment, line, chain) : addBead(path, segment, line, chain);
  });
  if (is_loop) chain.close();
}

}  // namespace

std::vector<StraightBead> straightBeads(const Toolpath& toolpath, BeadLine line) {
  Chain chain;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) addPath(path, line, chain);
  return chain.take();
}

}  // namespace lamina
