// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/variable_width_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "infill/rectilinear/border_connection.hpp"
#include "infill/rectilinear/one_sense_order.hpp"
#include "infill/rectilinear/raster_walk.hpp"
#include "infill/rectilinear/section_order.hpp"
#include "infill/rectilinear/variable_width_pass.hpp"

namespace lamina {
namespace {

/// Which lines of a raster passes run along.
enum class PassLines {
  All,
  Odd,  ///< a pass fills the variable-width line between the even lines below and above it
};

/// The passes of a raster and the sections they form: a section is a stack of passes of which the outline
/// joins each with the next on both sides, a monotone cell.
class BoustrophedonCells {
 public:
  BoustrophedonCells(const RasterWalk& walk, PassLines lines);

  /// Left ends of the passes of each section, from below.
  const std::vector<std::vector<std::uint32_t>>& sections() const { return sections_; }
  /// The crossing on the pass line above that the outline leads to, or none.
  std::uint32_t above(std::uint32_t crossing) const { return above_[crossing]; }
  /// What their order depends on, in the raster frame.
  std::vector<BoustrophedonCell> ends() const;
  /// Left ends of all passes, line by line from below.
  std::vector<std::uint32_t> passes() const;

 private:
  bool isPass(std::size_t inside_line) const;
  std::uint32_t findAbove(std::uint32_t crossing) const;
  /// The pass above joined on both sides, by its left end.
  std::uint32_t stackedOn(std::uint32_t left) const;

  const RasterWalk& walk_;
  PassLines lines_;
  std::vector<std::uint32_t> above_;
  std::vector<std::vector<std::uint32_t>> sections_;
};

/// A pass in the order deposited, by the crossing at which it is entered.
using PassEntries = std::vector<std::uint32_t>;

BoustrophedonCells::BoustrophedonCells(const RasterWalk& walk, PassLines lines)
    : walk_(walk), lines_(lines), above_(walk.raster().crossings.size(), kNoCrossing) {
  for (std::size_t i = 0; i < walk.insideLines(); ++i) {
    if (!isPass(i)) continue;
    above_[walk.leftEnd(i)] = findAbove(walk.leftEnd(i));
    above_[walk.rightEnd(i)] = findAbove(walk.rightEnd(i));
  }
  std::vector<bool> is_stacked(walk.insideLines(), false);
  for (std::size_t i = 0; i < walk.insideLines(); ++i) {
    if (!isPass(i) || is_stacked[i]) continue;
    std::vector<std::uint32_t> section;
    for (std::uint32_t left = walk.leftEnd(i); left != kNoCrossing; left = stackedOn(left)) {
      section.push_back(left);
      is_stacked[walk.insideLine(left)] = true;
    }
    sections_.push_back(std::move(section));
  }
}

bool BoustrophedonCells::isPass(std::size_t inside_line) const {
  return lines_ == PassLines::All || walk_.lineOf(walk_.leftEnd(inside_line)) % 2 != 0;
}

std::uint32_t BoustrophedonCells::findAbove(std::uint32_t crossing) const {
  const int steps = lines_ == PassLines::All ? 1 : 2;
  std::uint32_t reached = crossing;
  for (int step = 0; step < steps; ++step) {
    const std::uint32_t next = walk_.next(reached, Vertical::Up);
    if (walk_.lineOf(next) != walk_.lineOf(reached) + 1) return kNoCrossing;
    reached = next;
  }
  return reached;
}

std::uint32_t BoustrophedonCells::stackedOn(std::uint32_t left) const {
  const std::uint32_t on_left = above_[left];
  const std::uint32_t on_right = above_[walk_.otherEnd(left)];
  const bool is_joined = on_left != kNoCrossing && on_right != kNoCrossing && walk_.isLeftEnd(on_left) &&
                         walk_.otherEnd(on_left) == on_right;
  return is_joined ? on_left : kNoCrossing;
}

std::vector<BoustrophedonCell> BoustrophedonCells::ends() const {
  std::vector<BoustrophedonCell> ends;
  ends.reserve(sections_.size());
  for (const std::vector<std::uint32_t>& section : sections_) {
    BoustrophedonCell sides;
    sides.first = {walk_.pointAt(section.front()), walk_.pointAt(walk_.otherEnd(section.front()))};
    sides.last = {walk_.pointAt(section.back()), walk_.pointAt(walk_.otherEnd(section.back()))};
    sides.lines = section.size();
    ends.push_back(sides);
  }
  return ends;
}

std::vector<std::uint32_t> BoustrophedonCells::passes() const {
  std::vector<std::uint32_t> lefts;
  for (std::size_t i = 0; i < walk_.insideLines(); ++i)
    if (isPass(i)) lefts.push_back(walk_.leftEnd(i));
  return lefts;
}

/// How far the pass that ends there goes along the raster: beyond the end of its line it fills what lies
/// between the border that leaves there and the edge of its variable-width line.
double farthestAt(const RasterWalk& walk, std::uint32_t crossing) {
  const double outward = walk.isLeftEnd(crossing) ? -1.0 : 1.0;
  double farthest = walk.pointAt(crossing).x();
  for (const Vertical side : {Vertical::Up, Vertical::Down})
    for (const Point2& point : walk.chain(crossing, side))
      farthest = outward * std::max(outward * farthest, outward * point.x());
  return farthest;
}

/// Passes in one sense across, which are those of the odd lines.
/// @param from  where the nozzle comes from [mm, raster frame]
PassEntries passesInOneSense(const BoustrophedonCells& sections, const RasterWalk& walk, const Point2& from) {
  const std::vector<std::uint32_t> lefts = sections.passes();
  std::vector<RasterRow> rows;
  rows.reserve(lefts.size());
  for (const std::uint32_t left : lefts)
    rows.push_back({walk.lineOf(left) / 2, farthestAt(walk, left), farthestAt(walk, walk.otherEnd(left))});
  const double line_width_mm = 2.0 * walk.raster().spacing_mm;
  PassEntries entries;
  entries.reserve(rows.size());
  for (const RowVisit& visit : orderInOneSense(rows, {line_width_mm, 0.5 * line_width_mm}, from))
    entries.push_back(visit.enters_right ? walk.otherEnd(lefts[visit.row]) : lefts[visit.row]);
  return entries;
}

/// The passes of all sections in the order of the tour.
PassEntries passesOf(const BoustrophedonCells& sections, const RasterWalk& walk, const SectionTour& tour) {
  PassEntries entries;
  for (const SectionVisit& visit : tour) {
    std::vector<std::uint32_t> lefts = sections.sections()[visit.section];
    if (static_cast<int>(visit.entry) >= 2) std::reverse(lefts.begin(), lefts.end());
    bool enters_right = static_cast<int>(visit.entry) % 2 != 0;
    for (const std::uint32_t left : lefts) {
      entries.push_back(enters_right ? walk.otherEnd(left) : left);
      enters_right = !enters_right;
    }
  }
  return entries;
}

/// A border that recedes by more than this from one line to the next gets a narrow link, in widths of a
/// variable-width line.
constexpr double kSteepBorder = 0.6;
/// A link may be this much longer than the way it goes along the raster, in variable-width lines.
constexpr double kLongestDetour = 3.0;
/// A turn keeps this from the border, in variable-width lines: it laps over a little, or its bends would
/// leave the corners empty.
constexpr double kTurnReach = 0.43;
/// A variable-width line that ends this near to a link goes on there, in variable-width lines.
constexpr double kNearTip = 0.3;
/// Motions shorter than this are none [mm].
constexpr double kShortest = 1e-4;
/// Where a bead would turn back twice within this, in variable-width lines, it turns back once: between two
/// passes that meet in a tip, the link would stop there at each corner for material that lies there already.
constexpr double kLongestJog = 0.4;
/// Beads are widened by at most this part for the beads of a jog.
constexpr double kMostWidened = 0.1;

/// How two passes are joined.
struct VariableWidthLink {
  enum class Kind { None, Turn, Border } kind = Kind::None;
  std::uint32_t lower = kNoCrossing;
  std::uint32_t upper = kNoCrossing;
  double inset_mm = 0.0;         ///< of a turn
  bool is_upwards = false;       ///< deposited from the lower pass to the upper one
  bool is_lower_longer = false;  ///< a border link lies on the longer pass
};

/// What becomes of the jogs of links.
enum class Jogs { Kept, LeftOut };

bool turnsBack(const Point2& a, const Point2& b, const Point2& c) { return (b - a).dot(c - b) < 0.0; }

double motionArea(const FillPath& run, std::size_t i) {
  return run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
}

/// The run without the jogs of its links. What their beads would have filled goes into the motions up to the
/// next jog.
class JogRemoval {
 public:
  explicit JogRemoval(double line_width_mm) : longest_mm_(kLongestJog * line_width_mm) {}

  FillPath without(const FillPath& run) {
    kept_.points.reserve(run.points.size());
    kept_.width_mm.reserve(run.points.size());
    for (std::size_t i = 0; i < run.points.size(); ++i) {
      if (isJog(run, i)) {
        spread();
        left_mm2_ += motionArea(run, i);
        continue;
      }
      kept_.points.push_back(run.points[i]);
      kept_.width_mm.push_back(run.width_mm[i]);
      if (i > 0) left_mm2_ += motionArea(run, i) - motionArea(kept_, kept_.points.size() - 1);
    }
    spread();
    return std::move(kept_);
  }

 private:
  bool isJog(const FillPath& run, std::size_t i) const {
    if (kept_.points.size() < 2 || i + 1 >= run.points.size()) return false;
    const Point2& corner = kept_.points.back();
    return (run.points[i] - corner).norm() < longest_mm_ &&
           turnsBack(kept_.points.rbegin()[1], corner, run.points[i]) &&
           turnsBack(corner, run.points[i], run.points[i + 1]);
  }

  /// Widens what came after the last jog by what is left of it, a little; the rest is left to what follows.
  void spread() {
    double kept_mm2 = 0.0;
    for (std::size_t i = piece_; i < kept_.points.size(); ++i) kept_mm2 += motionArea(kept_, i);
    const double more_mm2 = std::clamp(left_mm2_, -kMostWidened * kept_mm2, kMostWidened * kept_mm2);
    for (std::size_t i = piece_; more_mm2 != 0.0 && i < kept_.points.size(); ++i)
      kept_.width_mm[i] *= 1.0 + more_mm2 / kept_mm2;
    left_mm2_ -= more_mm2;
    piece_ = kept_.points.size();
  }

  double longest_mm_;
  FillPath kept_;
  std::size_t piece_ = 1;  ///< first motion after the last jog
  double left_mm2_ = 0.0;  ///< that has to be filled besides
};

class VariableWidthTracer {
 public:
  VariableWidthTracer(const VariableWidthLines& lines, const BoustrophedonCells& sections,
                      const RasterFrame& frame, Jogs jogs)
      : lines_(lines),
        walk_(lines.walk),
        sections_(sections),
        frame_(frame),
        line_width_(2.0 * walk_.raster().spacing_mm),
        jogs_(jogs) {}

  std::vector<FillPath> trace(const PassEntries& entries) {
    std::vector<FillPath> runs;
    FillPath run;
    VariableWidthLink before;
    FillPath pass_before;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const VariableWidthLink after =
          i + 1 < entries.size() ? linkBetween(entries[i], entries[i + 1]) : VariableWidthLink{};
      FillPath pass = passOf(entries[i], before, after);
      if (before.kind == VariableWidthLink::Kind::None) {
        finish(run, runs);
        run = pass;
      } else {
        join(run, before, pass_before, pass);
      }
      before = after;
      pass_before = std::move(pass);
    }
    finish(run, runs);
    return runs;
  }

 private:
  VariableWidthLink linkBetween(std::uint32_t entered, std::uint32_t next) const {
    const std::uint32_t left_at = walk_.otherEnd(entered);
    VariableWidthLink link;
    if (sections_.above(left_at) == next) {
      link.lower = left_at;
      link.upper = next;
      link.is_upwards = true;
    } else if (sections_.above(next) == left_at) {
      link.lower = next;
      link.upper = left_at;
    } else {
      return link;
    }
    shape(link);
    return link;
  }

  double outward(std::uint32_t crossing) const { return walk_.isLeftEnd(crossing) ? -1.0 : 1.0; }

  void shape(VariableWidthLink& link) const {
    const Point2 lower = walk_.pointAt(link.lower);
    const Point2 upper = walk_.pointAt(link.upper);
    const double sign = outward(link.lower);
    if (sign != outward(link.upper)) return;
    const double recedes = sign * (lower.x() - upper.x());
    const Polyline border = borderBetween(link);
    if (length(border) > std::abs(recedes) + kLongestDetour * line_width_) return;
    link.is_lower_longer = recedes > 0.0;
    link.inset_mm =
        (kTurnReach * line_width_ - 0.5 * lines_.narrowest_mm) * std::hypot(1.0, recedes / line_width_);
    link.kind = std::abs(recedes) <= kSteepBorder * line_width_ && hasRoomToTurn(link, border)
                    ? VariableWidthLink::Kind::Turn
                    : VariableWidthLink::Kind::Border;
  }

  /// The outline from the lower line to the upper one.
  Polyline borderBetween(const VariableWidthLink& link) const {
    Polyline border = walk_.chain(link.lower, Vertical::Up);
    const Polyline rest = walk_.chain(walk_.next(link.lower, Vertical::Up), Vertical::Up);
    border.insert(border.end(), rest.begin() + 1, rest.end());
    return border;
  }

  bool hasRoomToTurn(const VariableWidthLink& link, const Polyline& border) const {
    const double sign = outward(link.lower);
    const Point2 lower = walk_.pointAt(link.lower) - Point2(sign * link.inset_mm, 0.0);
    const Point2 upper = walk_.pointAt(link.upper) - Point2(sign * link.inset_mm, 0.0);
    const auto turnAt = [&](double y) {
      return lower.x() + (upper.x() - lower.x()) * (y - lower.y()) / (upper.y() - lower.y());
    };
    for (const Point2& point : border)
      if (sign * (point.x() - turnAt(point.y())) < 0.5 * link.inset_mm) return false;
    const Point2 edge = walk_.pointAt(walk_.next(link.lower, Vertical::Up));
    return lineLength(link.lower) > 2.0 * link.inset_mm && lineLength(link.upper) > 2.0 * link.inset_mm &&
           walk_.isInside(walk_.lineOf(link.lower) + 1, edge.x(), turnAt(edge.y()));
  }

  double lineLength(std::uint32_t crossing) const {
    return std::abs(walk_.pointAt(crossing).x() - walk_.pointAt(walk_.otherEnd(crossing)).x());
  }

  /// The pass entered there, in the direction it is deposited.
  FillPath passOf(std::uint32_t entered, const VariableWidthLink& before,
                  const VariableWidthLink& after) const {
    const PassEndShape entry = endShape(entered, before);
    const PassEndShape exit = endShape(walk_.otherEnd(entered), after);
    if (walk_.isLeftEnd(entered)) return passThrough(lines_, entered, entry, exit);
    return reversed(passThrough(lines_, walk_.otherEnd(entered), exit, entry));
  }

  static PassEndShape endShape(std::uint32_t end, const VariableWidthLink& link) {
    if (link.kind == VariableWidthLink::Kind::None) return {};
    const bool is_lower = end == link.lower;
    const Vertical towards = is_lower ? Vertical::Up : Vertical::Down;
    if (link.kind == VariableWidthLink::Kind::Turn) return {PassEnd::Turn, link.inset_mm, towards};
    if (is_lower != link.is_lower_longer) return {PassEnd::Joined, 0.0, towards};
    // The variable-width line beside the link is open on the other side.
    return {is_lower ? PassEnd::LinkAbove : PassEnd::LinkBelow, 0.0,
            is_lower ? Vertical::Down : Vertical::Up};
  }

  void join(FillPath& run, const VariableWidthLink& link, const FillPath& from, const FillPath& to) const {
    if (link.kind == VariableWidthLink::Kind::Turn) {
      append(run, to.points.front(), 0.5 * (from.width_mm.back() + to.width_mm.front()));
    } else {
      for (const Point2& point : borderLink(link, from.points.back(), to.points.front()))
        append(run, point, lines_.narrowest_mm);
      append(run, to.points.front(), lines_.narrowest_mm);
    }
    for (std::size_t i = 1; i < to.points.size(); ++i) append(run, to.points[i], to.width_mm[i]);
  }

  /// The border from beside the end of the longer pass to the variable-width line of the other one, or the
  /// other way round.
  Polyline borderLink(const VariableWidthLink& link, const Point2& from, const Point2& to) const {
    const std::uint32_t longer = link.is_lower_longer ? link.lower : link.upper;
    const bool begins_at_longer = link.is_lower_longer == link.is_upwards;
    const double end_x = (begins_at_longer ? from : to).x();
    const Vertical across = link.is_lower_longer ? Vertical::Up : Vertical::Down;
    const Vertical away = link.is_lower_longer ? Vertical::Down : Vertical::Up;
    Polyline border = walk_.chain(longer, across);
    std::reverse(border.begin(), border.end());
    const Polyline rest = walk_.chain(longer, away);
    border.insert(border.end(), rest.begin() + 1, rest.end());
    Polyline along = upTo(border, end_x, outward(longer));
    const Point2& tip = begins_at_longer ? to : from;
    if ((tip - along.front()).norm() > kNearTip * line_width_) {
      Polyline rest_of_way = walk_.chain(link.is_lower_longer ? link.upper : link.lower, away);
      rest_of_way.pop_back();
      along.insert(along.begin(), rest_of_way.begin(), rest_of_way.end());
    }
    if (begins_at_longer) std::reverse(along.begin(), along.end());
    return along;
  }

  /// The border as far as it does not go beyond x.
  static Polyline upTo(const Polyline& border, double x, double sign) {
    Polyline along = {border.front()};
    for (std::size_t i = 1; i < border.size(); ++i) {
      if (sign * (along.back().x() - x) >= 0.0) break;
      if (sign * (border[i].x() - x) > 0.0) {
        const Point2& last = along.back();
        along.emplace_back(last + (x - last.x()) / (border[i].x() - last.x()) * (border[i] - last));
        break;
      }
      along.push_back(border[i]);
    }
    return along;
  }

  static void append(FillPath& run, const Point2& point, double width) {
    if ((run.points.back() - point).norm() < kShortest) return;
    run.points.push_back(point);
    run.width_mm.push_back(width);
  }

  void finish(FillPath& run, std::vector<FillPath>& runs) const {
    if (run.points.size() >= 2 && length(run.points) > kShortest) {
      if (jogs_ == Jogs::LeftOut) run = JogRemoval(line_width_).without(run);
      for (Point2& point : run.points) point = frame_.outOfRaster(point);
      runs.push_back(std::move(run));
    }
    run = {};
  }

  const VariableWidthLines& lines_;
  const RasterWalk& walk_;
  const BoustrophedonCells& sections_;
  const RasterFrame& frame_;
  double line_width_;
  Jogs jogs_;
};

/// Lowest and highest point across the raster [mm].
std::pair<double, double> extent(const Region& region, double angle_rad) {
  const RasterFrame frame(angle_rad);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Point2& point : region.outer) {
    const double y = frame.intoRaster(point).y();
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return {low, high};
}

/// A region cut into variable-width lines.
class VariableWidthRegion {
 public:
  VariableWidthRegion(const Region& links, const InfillRequest& request)
      : narrowest_(narrowestBead(request)),
        frame_(request.angle_rad, extent(links, request.angle_rad).first - 0.5 * narrowest_),
        raster_(rasterise({links}, 0.5 * lineWidth(links, request), frame_)),
        walk_(raster_),
        sections_(walk_, PassLines::Odd),
        lines_{walk_, findNotches(walk_), narrowest_} {}
  VariableWidthRegion(const VariableWidthRegion&) = delete;
  VariableWidthRegion& operator=(const VariableWidthRegion&) = delete;

  /// In the plane of the layer.
  std::vector<BoustrophedonCell> ends() const {
    std::vector<BoustrophedonCell> ends = sections_.ends();
    for (BoustrophedonCell& section : ends)
      for (std::array<Point2, 2>* line : {&section.first, &section.last})
        for (Point2& point : *line) point = frame_.outOfRaster(point);
    return ends;
  }

  std::vector<FillPath> runs(const SectionTour& tour, Jogs jogs) const {
    return VariableWidthTracer(lines_, sections_, frame_, jogs).trace(passesOf(sections_, walk_, tour));
  }

  /// @param from  where the nozzle comes from
  std::vector<FillPath> runsInOneSense(const Point2& from) const {
    return VariableWidthTracer(lines_, sections_, frame_, Jogs::LeftOut)
        .trace(passesInOneSense(sections_, walk_, frame_.intoRaster(from)));
  }

 private:
  double lineWidth(const Region& links, const InfillRequest& request) const {
    const auto [low, high] = extent(links, request.angle_rad);
    const double span = high - low + narrowest_;
    return span / std::max(1.0, std::round(span / request.pitch_mm));
  }

  double narrowest_;
  RasterFrame frame_;
  Raster raster_;
  RasterWalk walk_;
  BoustrophedonCells sections_;
  VariableWidthLines lines_;
};

/// One region after the other, the nearest next. No bead along the border leads from run to run: it would lie
/// beside lines that are deposited later.
std::vector<FillPath> runsInOneSense(const Regions& links, const InfillRequest& request) {
  std::vector<const Region*> left;
  for (const Region& region : links) left.push_back(&region);
  Point2 nozzle = request.start;
  std::vector<FillPath> all;
  while (!left.empty()) {
    const auto distance = [&nozzle](const Region* region) {
      double least = std::numeric_limits<double>::infinity();
      for (const Point2& point : region->outer) least = std::min(least, (point - nozzle).squaredNorm());
      return least;
    };
    std::size_t next = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double away = left.size() > 1 ? distance(left[i]) : 0.0;
      if (away >= least) continue;
      least = away;
      next = i;
    }
    std::vector<FillPath> runs = VariableWidthRegion(*left[next], request).runsInOneSense(nozzle);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
    if (!runs.empty()) nozzle = runs.back().points.back();
    std::move(runs.begin(), runs.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<FillPath> runsInAnySense(const Regions& links, const InfillRequest& request, Jogs jogs) {
  std::vector<std::unique_ptr<VariableWidthRegion>> regions;
  std::vector<BoustrophedonCell> sections;
  std::vector<std::size_t> begin;
  for (const Region& region : links) {
    regions.push_back(std::make_unique<VariableWidthRegion>(region, request));
    begin.push_back(sections.size());
    const std::vector<BoustrophedonCell> more = regions.back()->ends();
    sections.insert(sections.end(), more.begin(), more.end());
  }
  const SectionTour tour = tourOf(sections, request.start, request.settings.raster.order);
  std::vector<FillPath> runs;
  for (std::size_t i = 0; i < tour.size();) {
    const auto region = static_cast<std::size_t>(
        std::upper_bound(begin.begin(), begin.end(), tour[i].section) - begin.begin() - 1);
    const std::size_t end = region + 1 < begin.size() ? begin[region + 1] : sections.size();
    SectionTour within;
    for (; i < tour.size() && tour[i].section >= begin[region] && tour[i].section < end; ++i)
      within.push_back({tour[i].section - begin[region], tour[i].entry});
    // A tour that leaves a region and comes back shares out what may be overfilled there.
    const double share = static_cast<double>(within.size()) / static_cast<double>(end - begin[region]);
    const BorderConnection connection{
        narrowestBead(request), 2.0 * request.pitch_mm, request.settings.raster.longest_connection_mm,
        share * request.settings.raster.most_connection * area({links[region]})};
    for (FillPath& run : connectAlongBorder(regions[region]->runs(within, jogs), {links[region]}, connection))
      runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

double narrowestBead(const InfillRequest& request) {
  return request.settings.raster.narrowest * request.pitch_mm;
}

std::vector<FillPath> variableWidthRuns(const Regions& links, const InfillRequest& request) {
  if (request.advance == LineAdvance::OneSense) return runsInOneSense(links, request);
  return runsInAnySense(links, request, Jogs::LeftOut);
}

std::vector<FillPath> variableWidthRunsWithJogs(const Regions& links, const InfillRequest& request) {
  return runsInAnySense(links, request, Jogs::Kept);
}

}  // namespace lamina
