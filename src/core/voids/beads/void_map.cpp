// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_map.hpp"

#include <algorithm>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/void_class.hpp"
#include "toolpath/deposited_segment.hpp"
#include "voids/beads/bead_spans.hpp"
#include "voids/beads/scan_rows.hpp"

namespace lamina {
namespace {

/// Reports the class of voids that beads leave, by what lies around them:
///
/// | class | around the void |
/// |---|---|
/// | C4 | a corner of the contour of less than 60 degrees within two pitches |
/// | R1 | infill, and a wall or the contour |
/// | between | infill alone |
/// | C2 | walls that go round it and walls that do not |
/// | C1 | one wall, which goes round it |
/// | C3 | any other walls, or none |
class VoidClassifier {
 public:
  /// @param reaches  row by row
  VoidClassifier(const Regions& contour, const ToolpathLayer& layer, const ScanRows& rows,
                 const std::vector<std::vector<BeadSpan>>& reaches);

  /// @param pitch_mm  of the layer's beads
  VoidClass classOf(const Region& area, double pitch_mm) const;

 private:
  std::vector<std::uint32_t> runsAround(const Region& area) const;
  bool liesInSharpCorner(const Polygon& outline, double reach_mm) const;
  bool touchesContour(const Polygon& outline) const;
  bool goesRound(std::uint32_t run, const Point2& point) const;

  const ToolpathLayer& layer_;
  const ScanRows& rows_;
  const std::vector<std::vector<BeadSpan>>& reaches_;
  std::vector<Polygon> contour_;
  std::vector<Point2> sharp_corners_;
};

constexpr double kSharpCorner = M_PI / 3.0;
constexpr double kCornerReach = 2.0;  // pitches

/// Whether material is within less than the sharp angle there.
bool isSharp(const Point2& before, const Point2& at, const Point2& after) {
  const Point2 in = (at - before).normalized();
  const Point2 out = (after - at).normalized();
  return turn(in, out) > M_PI - kSharpCorner;
}

double distanceTo(const Polygon& outline, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point2 along = outline[i] - outline[j];
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((point - outline[j]).dot(along) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (outline[j] + t * along - point).norm());
  }
  return nearest;
}

bool isInfill(const Path& path) { return kindOf(path.role) == RoleKind::Infill; }

VoidClassifier::VoidClassifier(const Regions& contour, const ToolpathLayer& layer, const ScanRows& rows,
                               const std::vector<std::vector<BeadSpan>>& reaches)
    : layer_(layer), rows_(rows), reaches_(reaches), contour_(outlines(contour)) {
  for (const Polygon& outline : contour_)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& before = outline[i == 0 ? outline.size() - 1 : i - 1];
      const Point2& after = outline[i + 1 == outline.size() ? 0 : i + 1];
      if (isSharp(before, outline[i], after)) sharp_corners_.push_back(outline[i]);
    }
}

/// Those that reach the points beside the corners of its outlines.
std::vector<std::uint32_t> VoidClassifier::runsAround(const Region& area) const {
  std::vector<std::uint32_t> runs;
  const double step = 1.5 * rows_.spacing_mm;
  const auto addReaching = [&](const Point2& at) {
    const std::size_t row = rows_.firstAbove(at.y() - 0.5 * rows_.spacing_mm);
    if (row >= rows_.count) return;
    for (const BeadSpan& span : reaches_[row])
      if (span.low <= at.x() && at.x() <= span.high) runs.push_back(span.run);
  };
  for (const Polygon& outline : outlines({area}))
    for (const Point2& corner : outline)
      for (const Point2& aside : {Point2(step, 0), Point2(-step, 0), Point2(0, step), Point2(0, -step)})
        addReaching(corner + aside);
  std::sort(runs.begin(), runs.end());
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  return runs;
}

bool VoidClassifier::liesInSharpCorner(const Polygon& outline, double reach_mm) const {
  return std::any_of(sharp_corners_.begin(), sharp_corners_.end(), [&](const Point2& corner) {
    return encloses(outline, corner) || distanceTo(outline, corner) <= reach_mm;
  });
}

bool VoidClassifier::goesRound(std::uint32_t run, const Point2& point) const {
  const Path& path = layer_.paths[run];
  if (!path.is_closed) return false;
  Polygon loop;
  loop.reserve(path.points.size());
  for (const Point3& each : path.points) loop.emplace_back(each.head<2>());
  return encloses(loop, point);
}

bool VoidClassifier::touchesContour(const Polygon& outline) const {
  return std::any_of(outline.begin(), outline.end(), [&](const Point2& corner) {
    return std::any_of(contour_.begin(), contour_.end(), [&](const Polygon& border) {
      return distanceTo(border, corner) < 2.0 * rows_.spacing_mm;
    });
  });
}

VoidClass VoidClassifier::classOf(const Region& area, double pitch_mm) const {
  const Polygon& outline = area.outer;
  if (outline.empty()) return VoidClass::Between;
  if (liesInSharpCorner(outline, kCornerReach * pitch_mm)) return VoidClass::Corner;
  bool touches_infill = false;
  std::size_t around = 0;
  std::size_t beside = 0;
  for (const std::uint32_t run : runsAround(area)) {
    if (isInfill(layer_.paths[run]))
      touches_infill = true;
    else
      ++(goesRound(run, outline.front()) ? around : beside);
  }
  if (touches_infill)
    return around + beside > 0 || touchesContour(outline) ? VoidClass::RasterBorder : VoidClass::Between;
  if (around > 0 && beside > 0) return VoidClass::Meeting;
  return around == 1 && beside == 0 ? VoidClass::Core : VoidClass::ShapeChange;
}

/// A connected area: spans that overlap those of the next row.
struct SpanArea {
  Region outline;  ///< true within half a row's spacing
  double area_mm2 = 0.0;
};

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Cell {
  std::size_t row = 0;
  Span span;
};

/// Walks round an area of cells. Side 2 i is the left side of cell i and side 2 i + 1 its right side.
class OutlineWalk {
  using Range = std::pair<std::size_t, std::size_t>;  // of cells

 public:
  /// @param cells  connected, by row, then by x
  OutlineWalk(const std::vector<Cell>& cells, const ScanRows& rows)
      : cells_(cells), rows_(rows), above_(2 * cells.size()), below_(2 * cells.size()) {
    Range lower = {0, 0};
    while (lower.second < cells.size()) {
      Range upper = {lower.second, lower.second};
      while (upper.second < cells.size() && cells[upper.second].row == cells[upper.first].row) ++upper.second;
      link(lower, upper);
      lower = upper;
    }
    link(lower, {cells.size(), cells.size()});
  }

  Region region() {
    Region region;
    std::vector<bool> is_done(2 * cells_.size(), false);
    for (std::size_t side = 0; side < is_done.size(); ++side) {
      Polygon loop = simplify(walk(side, is_done), 0.5 * rows_.spacing_mm);
      if (loop.size() < 3) continue;
      if (signedArea(loop) < 0.0)
        region.holes.push_back(std::move(loop));
      else if (signedArea(loop) > signedArea(region.outer))
        region.outer = std::move(loop);
    }
    return region;
  }

 private:
  double xOf(std::size_t side) const {
    const Span& span = cells_[side / 2].span;
    return side % 2 == 0 ? span.low : span.high;
  }

  /// Between two rows the outline runs wherever one of them has a cell and the other has none.
  void link(Range lower, Range upper) {
    struct End {
      double x;
      std::size_t side;
      bool is_below;
    };
    std::vector<End> ends;
    for (std::size_t i = lower.first; i < lower.second; ++i)
      for (const std::size_t side : {2 * i, 2 * i + 1}) ends.push_back({xOf(side), side, true});
    for (std::size_t i = upper.first; i < upper.second; ++i)
      for (const std::size_t side : {2 * i, 2 * i + 1}) ends.push_back({xOf(side), side, false});
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.x < b.x; });
    for (std::size_t k = 1; k < ends.size(); k += 2) {
      const End& a = ends[k - 1];
      const End& b = ends[k];
      (a.is_below ? above_ : below_)[a.side] = {b.side, a.is_below == b.is_below};
      (b.is_below ? above_ : below_)[b.side] = {a.side, a.is_below == b.is_below};
    }
  }

  /// Left sides are walked down and right sides up, so that the area is on the left.
  Polygon walk(std::size_t side, std::vector<bool>& is_done) const {
    Polygon loop;
    bool goes_down = side % 2 == 0;
    while (!is_done[side]) {
      is_done[side] = true;
      const double y = rows_.at(cells_[side / 2].row);
      loop.emplace_back(xOf(side), y);
      const Link& next = (goes_down ? below_ : above_)[side];
      if (next.side == kNone) break;
      if (next.is_turn) {
        const double edge = y + (goes_down ? -0.5 : 0.5) * rows_.spacing_mm;
        loop.emplace_back(xOf(side), edge);
        loop.emplace_back(xOf(next.side), edge);
        goes_down = !goes_down;
      }
      side = next.side;
    }
    return loop;
  }

  struct Link {
    std::size_t side = kNone;
    bool is_turn = false;  ///< to a side of the same row
  };

  const std::vector<Cell>& cells_;
  const ScanRows& rows_;
  std::vector<Link> above_;
  std::vector<Link> below_;
};

std::vector<Cell> cellsOf(const std::vector<Spans>& spans) {
  std::vector<Cell> cells;
  for (std::size_t row = 0; row < spans.size(); ++row)
    for (const Span& span : spans[row]) cells.push_back({row, span});
  return cells;
}

/// Cells of neighbouring rows that overlap hang together: of each cell, the first one of its area.
std::vector<std::size_t> firstOfArea(const std::vector<Cell>& cells) {
  boost::disjoint_sets_with_storage<> sets(cells.size());
  std::size_t below = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto isPassed = [&](const Cell& cell) {
      return cell.row + 1 < cells[i].row ||
             (cell.row + 1 == cells[i].row && cell.span.high <= cells[i].span.low);
    };
    while (below < i && isPassed(cells[below])) ++below;
    for (std::size_t k = below; k < i && cells[k].row + 1 == cells[i].row; ++k) {
      if (cells[k].span.low >= cells[i].span.high) break;
      sets.union_set(k, i);
    }
  }
  const boost::counting_iterator<std::size_t> begin(0);
  const boost::counting_iterator<std::size_t> end(cells.size());
  sets.compress_sets(begin, end);
  sets.normalize_sets(begin, end);
  return sets.parents();
}

/// The connected areas of at least the least size, ordered by their lowest row and then by x.
std::vector<SpanArea> connectedAreas(const std::vector<Spans>& spans, const ScanRows& rows,
                                     double least_mm2) {
  const std::vector<Cell> cells = cellsOf(spans);
  const std::vector<std::size_t> first = firstOfArea(cells);
  std::vector<double> area(cells.size(), 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) area[first[i]] += cells[i].span.length() * rows.spacing_mm;
  std::vector<std::vector<Cell>> members(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (area[first[i]] >= least_mm2) members[first[i]].push_back(cells[i]);
  std::vector<SpanArea> areas;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!members[i].empty()) areas.push_back({OutlineWalk(members[i], rows).region(), area[i]});
  return areas;
}

/// Reports how many passes lie on each other along a row.
class PassCounter {
 public:
  /// @param reach_mm  parts of a run no farther apart along it are one pass
  PassCounter(const ToolpathLayer& layer, double reach_mm);

  /// A piece of a row on which the number of passes is the same.
  struct Piece : Span {
    int passes = 0;
  };

  /// Pieces with one pass at least, ascending.
  /// @param spans  of one row, in any order
  std::vector<Piece> count(std::vector<BeadSpan> spans) const;

 private:
  struct Place {
    std::uint32_t run;
    double arc;
  };

  int passesAt(std::vector<Place>& places) const;
  void addPieces(const std::vector<BeadSpan>& active, Span range, std::vector<Piece>& pieces) const;

  double reach_mm_;
  std::vector<double> closed_length_;  ///< of each path of the layer; 0 if it is open
};

double arcAt(const BeadSpan& span, double x) {
  const double t = (x - span.low) / (span.high - span.low);
  return span.arc_low + t * (span.arc_high - span.arc_low);
}

PassCounter::PassCounter(const ToolpathLayer& layer, double reach_mm) : reach_mm_(reach_mm) {
  for (const Path& path : layer.paths) closed_length_.push_back(path.is_closed ? length(path) : 0.0);
}

int PassCounter::passesAt(std::vector<Place>& places) const {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.run != b.run ? a.run < b.run : a.arc < b.arc; });
  int passes = 0;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    int of_run = 1;
    for (end = begin + 1; end < places.size() && places[end].run == places[begin].run; ++end)
      if (places[end].arc - places[end - 1].arc > reach_mm_) ++of_run;
    const double length = closed_length_[places[begin].run];
    const bool closes = length > 0.0 && places[begin].arc + length - places[end - 1].arc <= reach_mm_;
    passes += closes && of_run > 1 ? of_run - 1 : of_run;
  }
  return passes;
}

void PassCounter::addPieces(const std::vector<BeadSpan>& active, Span range,
                            std::vector<Piece>& pieces) const {
  const auto add = [&](double low, double high, int passes) {
    if (!pieces.empty() && pieces.back().passes == passes && pieces.back().high == low) {
      pieces.back().high = high;
    } else {
      Piece piece;
      piece.low = low, piece.high = high, piece.passes = passes;
      pieces.push_back(piece);
    }
  };
  if (active.size() == 1) return add(range.low, range.high, 1);
  // Two parts of one run may come together along the row: within a quarter of the reach that makes no
  // difference.
  const int steps = 1 + static_cast<int>(4.0 * range.length() / reach_mm_);
  std::vector<Place> places;
  for (int k = 0; k < steps; ++k) {
    const double low = range.low + range.length() * k / steps;
    const double high = k + 1 == steps ? range.high : range.low + range.length() * (k + 1) / steps;
    places.clear();
    for (const BeadSpan& span : active) places.push_back({span.run, arcAt(span, 0.5 * (low + high))});
    add(low, high, passesAt(places));
  }
}

std::vector<PassCounter::Piece> PassCounter::count(std::vector<BeadSpan> spans) const {
  std::sort(spans.begin(), spans.end(), [](const BeadSpan& a, const BeadSpan& b) { return a.low < b.low; });
  std::vector<Piece> pieces;
  std::vector<BeadSpan> active;
  double x = 0.0;
  const auto advanceTo = [&](double target) {
    while (!active.empty() && x < target) {
      double next = target;
      for (const BeadSpan& span : active) next = std::min(next, span.high);
      if (next > x) addPieces(active, {x, next}, pieces);
      x = std::max(x, next);
      active.erase(
          std::remove_if(active.begin(), active.end(), [&](const BeadSpan& span) { return span.high <= x; }),
          active.end());
    }
  };
  for (const BeadSpan& span : spans) {
    advanceTo(span.low);
    x = span.low;
    active.push_back(span);
  }
  if (!spans.empty()) advanceTo(std::numeric_limits<double>::infinity());
  return pieces;
}

/// Of a layer; more would need too much memory.
constexpr double kMostRows = 40000.0;
/// In pitches: parts of a run nearer along it than this are one pass.
constexpr double kPassReach = 1.5;

void requireInRange(const VoidMapSettings& settings) {
  if (!(settings.line_spacing > 0.0 && settings.line_spacing <= 1.0))
    throw InvalidInput("line spacing of the void map is " + numberText(settings.line_spacing) +
                       " pitches; must be in (0, 1]");
  if (!(settings.least_void >= 0.0))
    throw InvalidInput("least void is " + numberText(settings.least_void) +
                       " squared pitches; must not be negative");
}

/// By length of the beads; that of drops if there is no bead.
double meanPlanWidth(const ToolpathLayer& layer) {
  double length = 0.0;
  double area = 0.0;
  double widest_drop = 0.0;
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
      if (path.deposit == Deposit::Drops) widest_drop = std::max(widest_drop, segment.bead.width_mm);
      length += segment.length();
      area += segment.length() * planWidth(segment.bead);
    });
  }
  return length > 0.0 ? area / length : widest_drop;
}

Box2 boxOf(const std::vector<Polygon>& contour, const ToolpathLayer& layer) {
  Box2 box = boundingBox(contour);
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Point2 at = path.points[i].head<2>();
      const double reach = 0.5 * path.bead.at(i).width_mm;
      box.include(at - Point2(reach, reach));
      box.include(at + Point2(reach, reach));
    }
  }
  return box;
}

ScanRows rowsOver(const Box2& box, double spacing_mm) {
  ScanRows rows;
  if (box.isEmpty()) return rows;
  const double count = std::ceil(box.size().y() / std::max(spacing_mm, box.size().y() / kMostRows));
  rows.low_mm = box.low.y();
  rows.count = static_cast<std::size_t>(std::max(1.0, count));
  rows.spacing_mm = box.size().y() > 0.0 ? box.size().y() / static_cast<double>(rows.count) : spacing_mm;
  return rows;
}

double areaOf(const std::vector<Spans>& spans, const ScanRows& rows) {
  double sum = 0.0;
  for (const Spans& row : spans)
    for (const Span& span : row) sum += span.length();
  return sum * rows.spacing_mm;
}

/// One layer's account.
class LayerAccount {
 public:
  LayerAccount(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings)
      : contour_(contour), layer_(layer), borders_(outlines(contour)) {
    result_.z_mm = layer.z_mm;
    result_.pitch_mm = meanPlanWidth(layer);
    result_.area_mm2 = area(contour);
    // Without deposit all is void; a hundredth of the size shows it well enough.
    const Box2 box = boxOf(borders_, layer);
    const double spacing = result_.pitch_mm > 0.0 ? settings.line_spacing * result_.pitch_mm
                                                  : std::max(1e-3, 0.01 * box.size().maxCoeff());
    rows_ = rowsOver(box, spacing);
    least_mm2_ = settings.least_void * result_.pitch_mm * result_.pitch_mm;
    inside_ = insideSpans(borders_, rows_);
  }

  LayerVoids account() && {
    countDeposit();
    findUncovered();
    findOverfill();
    return std::move(result_);
  }

 private:
  void countDeposit() {
    for (const Path& path : layer_.paths) {
      if (!isPartOfPart(path)) continue;
      ++result_.runs;
      if (layer_.height_mm > 0.0) result_.deposited_mm2 += depositedVolume(path) / layer_.height_mm;
    }
  }

  void findUncovered() {
    const std::vector<std::vector<BeadSpan>> reaches = beadSpans(layer_, rows_, BeadMeasure::Reach);
    std::vector<Spans> open(rows_.count);
    for (std::size_t row = 0; row < rows_.count; ++row)
      open[row] = difference(inside_[row], united(Spans(reaches[row].begin(), reaches[row].end())));
    result_.uncovered_mm2 = areaOf(open, rows_);
    const VoidClassifier classifier(contour_, layer_, rows_, reaches);
    for (SpanArea& found : connectedAreas(open, rows_, least_mm2_)) {
      const VoidClass kind = classifier.classOf(found.outline, result_.pitch_mm);
      result_.voids.push_back({std::move(found.outline), found.area_mm2, kind});
    }
  }

  void findOverfill() {
    const PassCounter counter(layer_, kPassReach * result_.pitch_mm);
    std::vector<std::vector<BeadSpan>> plans = beadSpans(layer_, rows_, BeadMeasure::Plan);
    std::vector<Spans> over(rows_.count);
    double sum = 0.0;
    double sum_outside = 0.0;
    for (std::size_t row = 0; row < rows_.count; ++row) {
      Spans filled;
      for (const PassCounter::Piece& piece : counter.count(std::move(plans[row]))) {
        sum += (piece.passes - 1) * piece.length();
        filled.push_back(piece);
        if (piece.passes > 1) over[row].push_back(piece);
      }
      const Spans outside = difference(filled, inside_[row]);
      for (const Span& span : outside) sum_outside += span.length();
      over[row].insert(over[row].end(), outside.begin(), outside.end());
      over[row] = united(std::move(over[row]));
    }
    result_.outside_mm2 = sum_outside * rows_.spacing_mm;
    result_.overfill_mm2 = sum * rows_.spacing_mm + result_.outside_mm2;
    for (SpanArea& found : connectedAreas(over, rows_, least_mm2_))
      result_.overfills.push_back(std::move(found.outline));
  }

  const Regions& contour_;
  const ToolpathLayer& layer_;
  std::vector<Polygon> borders_;
  ScanRows rows_;
  double least_mm2_ = 0.0;
  std::vector<Spans> inside_;  ///< the contour, row by row
  LayerVoids result_;
};

}  // namespace

LayerVoids findVoids(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings) {
  requireInRange(settings);
  return LayerAccount(contour, layer, settings).account();
}

std::vector<LayerVoids> findVoids(const std::vector<Regions>& contours, const Toolpath& toolpath,
                                  const VoidMapSettings& settings, Progress& progress) {
  requireLevelLayers(toolpath, "the void map");
  if (contours.size() != toolpath.layers.size())
    throw InvalidInput("the toolpath has " + std::to_string(toolpath.layers.size()) +
                       " layers and the part " + std::to_string(contours.size()) +
                       " contours; must be as many");
  std::vector<LayerVoids> layers(contours.size());
  parallelFor(
      layers.size(), [&](std::size_t i) { layers[i] = findVoids(contours[i], toolpath.layers[i], settings); },
      progress, "voids");
  return layers;
}

}  // namespace lamina
