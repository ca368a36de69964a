// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/overhangs/overhanging_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planning/shortest_piece.hpp"

namespace lamina {
namespace {

constexpr double kStep = 1.0;          // bead widths between the places that are looked at, at most
constexpr double kBeyondEntry = 0.01;  // by which a share passes an entry, so that rounding does not
constexpr double kWhole = 0.98;        // from this share on nothing is below
constexpr double kStraight = 0.95;     // of a stretch: the distance of its ends by its length
constexpr double kFactorStep = 0.002;  // factors in between are rounded

double roundedTo(double value, double step) { return std::round(value / step) * step; }

/// A part of a motion whose share lies between two entries.
struct WallPiece {
  Point3 end;
  std::size_t from = 0;  ///< waypoint of the wall that describes it
  double length_mm = 0.0;
  double share = 0.0;  ///< on the average
};

/// Cuts motions where the share passes an entry.
class WallCutter {
 public:
  WallCutter(const Path& wall, const BorderDistance& below, const std::vector<double>& entries)
      : wall_(wall), below_(below), entries_(entries) {
    for (double& entry : entries_) entry = std::min(entry, kWhole);
  }

  std::vector<WallPiece> cut() {
    for (std::size_t m = 0; m < wall_.motionCount(); ++m) cutMotion(m);
    return std::move(pieces_);
  }

 private:
  double shareAt(const Point3& point, double width_mm) const {
    return overhangShare(below_.at(point.head<2>()) + 0.5 * width_mm, width_mm);
  }

  std::size_t entriesBelow(double share) const {
    return static_cast<std::size_t>(std::upper_bound(entries_.begin(), entries_.end(), share) -
                                    entries_.begin());
  }

  /// Whether a share lies clearly outside of what lies between the entries that another lies between.
  bool isBeyond(double share, std::size_t entries) const {
    const bool is_above = entries < entries_.size() && share > entries_[entries] + kBeyondEntry;
    return is_above || (entries > 0 && share < entries_[entries - 1] - kBeyondEntry);
  }

  void cutMotion(std::size_t motion) {
    const std::size_t end = wall_.motionEnd(motion);
    const Point3& from = wall_.points[motion];
    const Point3 way = wall_.points[end] - from;
    const double width = wall_.bead.at(end).width_mm;
    const double length = way.norm();
    const auto steps = static_cast<std::size_t>(std::ceil(std::max(length / (kStep * width), 1.0)));
    double share = shareAt(from, width);
    std::size_t entries = entriesBelow(share);
    double begin = 0.0, at = 0.0, sum = 0.0;  // along the motion, 0 to 1
    const auto add = [&](double to) {
      const double part = to - begin;
      const Point3 point = to < 1.0 ? Point3(from + to * way) : wall_.points[end];
      pieces_.push_back({point, end, part * length, part > 0.0 ? sum / part : share});
      begin = to;
      sum = 0.0;
    };
    for (std::size_t step = 1; step <= steps; ++step) {
      const double next = static_cast<double>(step) / static_cast<double>(steps);
      const double next_share = step < steps ? shareAt(from + next * way, width) : shareAt(from + way, width);
      while (isBeyond(next_share, entries)) {
        const bool rises = entries < entries_.size() && next_share > entries_[entries];
        const double entry = rises ? entries_[entries] : entries_[entries - 1];
        const double part = (entry - share) / (next_share - share);
        const double cut = at + std::clamp(part, 0.0, 1.0) * (next - at);
        sum += 0.5 * (share + entry) * (cut - at);
        if ((cut - begin) * length > kShortestPiece && (1.0 - cut) * length > kShortestPiece) add(cut);
        at = cut;
        share = entry;
        rises ? ++entries : --entries;
      }
      sum += 0.5 * (share + next_share) * (next - at);
      at = next;
      share = next_share;
    }
    add(1.0);
  }

  const Path& wall_;
  const BorderDistance& below_;
  std::vector<double> entries_;
  std::vector<WallPiece> pieces_;
};

bool isWhole(const WallPiece& piece) { return piece.share >= kWhole; }

/// Which pieces belong to straight stretches with nothing below, between two that are carried.
std::vector<bool> spansOf(const Path& wall, const std::vector<WallPiece>& pieces, double anchor_mm) {
  const std::size_t count = pieces.size();
  std::vector<bool> spans(count, false);
  const auto carried = std::find_if_not(pieces.begin(), pieces.end(), isWhole);
  if (carried == pieces.end()) return spans;
  const auto first = static_cast<std::size_t>(carried - pieces.begin());
  const std::size_t steps = wall.is_closed ? count + first : count;
  for (std::size_t i = first; i < steps; ++i) {
    if (!isWhole(pieces[i % count])) continue;
    double length = 0.0;
    std::size_t end = i;
    for (; end < steps && isWhole(pieces[end % count]); ++end) length += pieces[end % count].length_mm;
    const Point3& from = pieces[(i + count - 1) % count].end;
    const double chord = (pieces[(end - 1) % count].end - from).norm();
    const bool is_held = wall.is_closed || end < steps;
    if (is_held && length > anchor_mm && chord >= kStraight * length)
      for (std::size_t k = i; k < end; ++k) spans[k % count] = true;
    i = end;
  }
  return spans;
}

Path turnedRound(Path loop) {
  std::reverse(loop.points.begin() + 1, loop.points.end());
  return loop;
}

/// The wall with a waypoint at the end of each piece.
class PiecedWall {
 public:
  PiecedWall(Path wall, const OverhangRules& rules) : wall_(std::move(wall)), rules_(rules) {}

  Path divided(const std::vector<WallPiece>& pieces) && {
    const std::vector<bool> spans = rules_.bridge_feed_mm_s > 0.0 ? spansOf(wall_, pieces, rules_.anchor_mm)
                                                                  : std::vector<bool>(pieces.size(), false);
    std::vector<double> feeds;
    std::vector<Bead> beads;
    std::vector<double> shares;
    const std::size_t waypoints = pieces.size() + 1;
    feeds.reserve(waypoints);
    beads.reserve(waypoints);
    shares.reserve(waypoints);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      feeds.push_back(spans[i] ? rules_.bridge_feed_mm_s : feedOf(pieces[i]));
      beads.push_back(beadOf(pieces[i]));
      const bool counts =
          spans[i] || (rules_.walls.is_used && pieces[i].share >= rules_.walls.shares.front());
      shares.push_back(counts ? pieces[i].share : 0.0);
    }
    if (std::all_of(shares.begin(), shares.end(), [](double share) { return share == 0.0; }))
      return std::move(wall_);
    Path path = wall_;
    path.points.clear();
    path.points.reserve(waypoints);
    path.points.push_back(wall_.points.front());
    for (const WallPiece& piece : pieces) path.points.push_back(piece.end);
    if (wall_.is_closed) path.points.pop_back();
    path.feed_mm_s = along(std::move(feeds));
    path.bead = along(std::move(beads));
    path.values.push_back({kUnsupported, along(std::move(shares))});
    return path;
  }

 private:
  double feedOf(const WallPiece& piece) const {
    const double feed = wall_.feed_mm_s.at(piece.from);
    if (!rules_.walls.is_used) return feed;
    const double factor = roundedTo(overhangFeedFactor(piece.share, rules_.walls), kFactorStep);
    return std::max(feed * factor, std::min(feed, rules_.walls.least_feed_mm_s));
  }

  Bead beadOf(const WallPiece& piece) const {
    const Bead& bead = wall_.bead.at(piece.from);
    const double factor =
        rules_.walls.is_used ? roundedTo(overhangFlowFactor(piece.share, rules_.walls), kFactorStep) : 1.0;
    return factor == 1.0 ? bead : beadOfArea(factor * crossSection(bead), bead.height_mm);
  }

  /// Of pieces, as waypoints have it: the first one describes the return of a loop.
  template <class Value>
  AlongPath<Value> along(std::vector<Value> of_pieces) const {
    if (std::all_of(of_pieces.begin(), of_pieces.end(),
                    [&](const Value& value) { return value == of_pieces.front(); }))
      return of_pieces.front();
    if (wall_.is_closed)
      std::rotate(of_pieces.begin(), of_pieces.end() - 1, of_pieces.end());
    else
      of_pieces.insert(of_pieces.begin(), of_pieces.front());
    return AlongPath<Value>(std::move(of_pieces));
  }

  Path wall_;
  const OverhangRules& rules_;
};

}  // namespace

Path overhanging(Path wall, const BorderDistance& below, const OverhangRules& rules, std::size_t layer) {
  const std::vector<double>& entries = rules.walls.shares;
  std::vector<WallPiece> pieces = WallCutter(wall, below, entries).cut();
  const double least = rules.walls.is_used ? entries.front() : kWhole;
  const auto hangs = [least](const WallPiece& piece) { return piece.share >= least; };
  if (std::none_of(pieces.begin(), pieces.end(), hangs)) return wall;
  const bool is_turned = rules.walls.is_used && rules.walls.reverses && layer % 2 == 1 && wall.is_closed &&
                         wall.bead.isCommon() && wall.feed_mm_s.isCommon();
  if (is_turned) {
    wall = turnedRound(std::move(wall));
    pieces = WallCutter(wall, below, entries).cut();
  }
  return PiecedWall(std::move(wall), rules).divided(pieces);
}

void markUnsupportedSince(std::vector<Path>& paths, std::size_t before, double feed_mm_s) {
  for (std::size_t i = before; i < paths.size(); ++i) {
    if (paths[i].role == PathRole::Travel) continue;
    paths[i].feed_mm_s = feed_mm_s;
    paths[i].values.push_back({kUnsupported, AlongPath<double>(1.0)});
  }
}

const ProcessValue* unsupportedOf(const Path& path) {
  for (const ProcessValue& each : path.values)
    if (each.name == kUnsupported) return &each;
  return nullptr;
}

void forgetUnsupported(Path& path) {
  const auto is_it = [](const ProcessValue& each) { return each.name == kUnsupported; };
  path.values.erase(std::remove_if(path.values.begin(), path.values.end(), is_it), path.values.end());
}

}  // namespace lamina
