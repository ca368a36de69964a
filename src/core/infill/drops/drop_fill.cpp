// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops/drop_fill.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kCorner = toRadians(50.0);
constexpr double kRounding = 1e-6;  // of a pitch: an outline exactly n pitches long has room for n
constexpr double kMostDrops = 5e6;  // of a layer
constexpr double kWidest = 1.25;    // pitches, from drop to drop along the border

double positive(double value, const char* key) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw InvalidInput(std::string(key) + " is " + numberText(value) + " mm; must be positive");
  return value;
}

DropSettings checked(const DropSettings& settings, const Regions& regions) {
  positive(settings.diameter_mm, "drops.diameter_mm");
  positive(settings.pitch_mm, "drops.pitch_mm");
  positive(lineSpacing(settings), "drops.line_spacing_mm");
  requireFewDrops(regions, settings);
  return settings;
}

/// The outline as a way that begins and ends at one of its corners, if it has one.
class OutlineWalk {
 public:
  OutlineWalk(const Polygon& outline, double pitch, double least)
      : outline_(outline), pitch_(pitch), least_(least) {
    const std::size_t n = outline.size();
    while (start_ < n && !isCorner(start_)) ++start_;
    if (start_ == n) start_ = 0;
    at_.resize(n + 1, 0.0);
    for (std::size_t i = 1; i <= n; ++i) at_[i] = at_[i - 1] + (point(i) - point(i - 1)).norm();
  }

  Polyline drops() const {
    const double whole = at_.back();
    if (whole < pitch_) return {boundingBox({outline_}).centre()};
    Polyline drops;
    std::size_t segment = 0;
    double from = 0.0;
    for (std::size_t i = 1; i <= outline_.size(); ++i) {
      const bool is_end = i == outline_.size();
      const bool is_stop =
          isCorner((start_ + i) % outline_.size()) && isLong(from, at_[i]) && isLong(at_[i], whole);
      if (!is_end && !is_stop) continue;
      appendStretch(from, at_[i], segment, drops);
      from = at_[i];
    }
    return drops;
  }

 private:
  const Point2& point(std::size_t i) const { return outline_[(start_ + i) % outline_.size()]; }

  bool isLong(double from, double to) const { return to - from >= pitch_ * (1.0 - kRounding); }

  bool isCorner(std::size_t i) const {
    const std::size_t n = outline_.size();
    const Point2 in = outline_[i] - outline_[(i + n - 1) % n];
    const Point2 out = outline_[(i + 1) % n] - outline_[i];
    return std::abs(turn(in, out)) > kCorner;
  }

  int countAlong(double length) const {
    const int count = std::max(1, static_cast<int>(length / pitch_ + kRounding));
    const bool is_wide = length > kWidest * pitch_ * count;
    return is_wide && length >= least_ * (count + 1) ? count + 1 : count;
  }

  /// Its end belongs to the next stretch.
  void appendStretch(double from, double to, std::size_t& segment, Polyline& drops) const {
    const int count = countAlong(to - from);
    for (int k = 0; k < count; ++k) {
      const double at = from + (to - from) * k / count;
      while (segment + 2 < at_.size() && at_[segment + 1] <= at) ++segment;
      const double span = at_[segment + 1] - at_[segment];
      const double part = span > 0.0 ? (at - at_[segment]) / span : 0.0;
      drops.push_back(point(segment) + part * (point(segment + 1) - point(segment)));
    }
  }

  const Polygon& outline_;
  double pitch_;
  double least_;
  std::size_t start_ = 0;
  std::vector<double> at_;  ///< length of the way up to each point [mm]
};

/// A line of a raster inside the outlines.
struct Section {
  std::int64_t line = 0;
  double left = 0.0;
  double right = 0.0;
  std::size_t run = 0;
  bool is_continued = false;  ///< by a section of the line above
};

/// Sections that follow each other from line to line, to and fro.
class LineRuns {
 public:
  /// Sections come line by line, from left to right.
  void add(Section section, Polyline drops) {
    if (here_.empty() || here_.front().line != section.line) {
      const bool is_next = !here_.empty() && here_.front().line + 1 == section.line;
      below_ = is_next ? std::move(here_) : std::vector<Section>();
      here_.clear();
      first_below_ = 0;
    }
    section.run = continued(section);
    here_.push_back(section);
    if (section.run == runs_.size()) {
      runs_.emplace_back();
      is_leftward_.push_back(false);
    }
    if (is_leftward_[section.run]) std::reverse(drops.begin(), drops.end());
    is_leftward_[section.run] = !is_leftward_[section.run];
    runs_[section.run].insert(runs_[section.run].end(), drops.begin(), drops.end());
  }

  const std::vector<Polyline>& runs() const { return runs_; }

 private:
  /// The run of a section below that lies beside this one, or a new run.
  std::size_t continued(const Section& section) {
    while (first_below_ < below_.size() && below_[first_below_].right < section.left) ++first_below_;
    for (std::size_t i = first_below_; i < below_.size() && below_[i].left <= section.right; ++i) {
      if (below_[i].is_continued) continue;
      below_[i].is_continued = true;
      return below_[i].run;
    }
    return runs_.size();
  }

  std::vector<Section> below_;
  std::vector<Section> here_;
  std::size_t first_below_ = 0;
  std::vector<Polyline> runs_;
  std::vector<bool> is_leftward_;  ///< the next line of each run
};

}  // namespace

void requireFewDrops(const Regions& regions, const DropSettings& settings) {
  const double covered_mm2 = area(regions);
  const double drops = covered_mm2 / (settings.pitch_mm * lineSpacing(settings));
  if (!(drops > kMostDrops)) return;
  throw InvalidInput("drops.pitch_mm is " + numberText(settings.pitch_mm) + " mm: a layer of " +
                     numberText(covered_mm2) + " mm2 takes " + std::to_string(std::llround(drops)) +
                     " drops; must be at most " + std::to_string(std::llround(kMostDrops)));
}

Polyline dropsAlong(const Polygon& outline, double pitch_mm, double least_mm) {
  if (outline.size() < 3) return {};
  return OutlineWalk(outline, pitch_mm, least_mm).drops();
}

DropFill::DropFill(const Regions& regions, const DropSettings& settings)
    : settings_(checked(settings, regions)),
      least_distance_((1.0 - settings.most_overlap - kRounding) * settings.diameter_mm),
      deposited_(boundingBox(outlines(regions)), settings.diameter_mm) {}

Regions DropFill::inside(const Regions& regions, std::size_t contours) const {
  return offset(regions,
                -0.5 * settings_.diameter_mm - static_cast<double>(contours) * lineSpacing(settings_));
}

void DropFill::addContours(const Regions& regions, std::size_t most) {
  for (const Region& region : regions) {
    Regions left = offset({region}, -0.5 * settings_.diameter_mm);
    const Regions wide = offset(offset(left, -0.5 * least_distance_), 0.5 * least_distance_);
    addLoops(wide, PathRole::OuterWall);
    addLoops(difference(left, wide), PathRole::Infill);
    for (std::size_t k = 1; k < most && !left.empty(); ++k) {
      left = offset(left, -lineSpacing(settings_));
      addLoops(left, PathRole::InnerWall);
    }
  }
}

void DropFill::addLoops(const Regions& regions, PathRole role) {
  const double least = role == PathRole::OuterWall ? least_distance_ : settings_.pitch_mm;
  for (const Polygon& loop : outlines(regions))
    add(startedNear(dropsAlong(loop, settings_.pitch_mm, least)), role);
}

Polyline DropFill::startedNear(Polyline loop) const {
  if (paths_.empty() || loop.empty()) return loop;
  const Point2 from = paths_.back().points.back();
  const auto nearest = std::min_element(loop.begin(), loop.end(), [&](const Point2& a, const Point2& b) {
    return (a - from).squaredNorm() < (b - from).squaredNorm();
  });
  std::rotate(loop.begin(), nearest, loop.end());
  return loop;
}

void DropFill::addLines(const Raster& raster, const RasterFrame& frame, const DropLine& line) {
  LineRuns runs;
  for (std::size_t i = 0; i + 1 < raster.sorted.size(); i += 2) {
    const Crossing& left = raster.crossings[raster.sorted[i]];
    const double right = raster.crossings[raster.sorted[i + 1]].x;
    Polyline drops;
    for (const double x : line(left.line, left.x, right))
      drops.push_back(frame.outOfRaster({x, static_cast<double>(left.line) * raster.spacing_mm}));
    runs.add({left.line, left.x, right}, std::move(drops));
  }
  for (const Polyline& run : runs.runs()) add(run, PathRole::Infill);
}

void DropFill::add(const Polyline& drops, PathRole role) {
  FillPath path;
  path.role = role;
  path.deposit = Deposit::Drops;
  for (const Point2& drop : drops) {
    if (deposited_.hasNearer(drop, least_distance_)) continue;
    deposited_.insert(drop);
    path.points.push_back(drop);
  }
  if (!path.points.empty()) paths_.push_back(std::move(path));
}

std::vector<FillPath> contoursAndLines(const Regions& regions, const InfillRequest& request, double row_mm,
                                       const DropLine& line) {
  const DropSettings& drops = request.settings.drops;
  const auto contours = static_cast<std::size_t>(drops.contours);
  const RasterFrame frame(request.angle_rad);
  DropFill fill(regions, drops);
  fill.addContours(regions, contours);
  fill.addLines(rasterise(fill.inside(regions, contours), row_mm, frame), frame, line);
  return std::move(fill).take();
}

}  // namespace lamina
