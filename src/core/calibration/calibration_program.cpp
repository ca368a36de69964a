// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/calibration_program.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lamina {
namespace {

constexpr double kTravelMmS = 60.0;
constexpr double kSwathShare = 0.95;  // of a swath that its neighbour does not see
constexpr double kScanMarginMm = 5.0;
constexpr double kPatchMm = 20.0;  // along x
constexpr int kPatchBeads = 10;
constexpr double kArmGap = 2.5;  // bead widths between the halves of an arm and the arm they would cross

Point2 middleOf(const CalibrationSettings& settings) { return {settings.x_mm, settings.y_mm}; }

/// Collects paths that join.
class PathChain {
 public:
  explicit PathChain(const CalibrationSettings& settings) : settings_(settings) {}

  void travelTo(const Point3& point) { travel({point}, kTravelMmS); }

  /// Over beads that lie already.
  void hopTo(const Point3& point) {
    const Point3 lift(0.0, 0.0, settings_.clearance_mm);
    travel({paths_.back().lastPoint() + lift, point + lift, point}, kTravelMmS);
  }

  /// Through points at one speed.
  void travel(const std::vector<Point3>& points, double feed_mm_s) {
    std::vector<double> feeds(points.size(), feed_mm_s);
    travel(points, feeds);
  }

  /// Through points, each at the speed of its way there.
  void travel(const std::vector<Point3>& points, const std::vector<double>& feeds_mm_s) {
    Path path;
    path.role = PathRole::Travel;
    path.points = paths_.empty() ? std::vector<Point3>{} : std::vector<Point3>{paths_.back().lastPoint()};
    path.points.insert(path.points.end(), points.begin(), points.end());
    std::vector<double> feeds = feeds_mm_s;
    if (!paths_.empty()) feeds.insert(feeds.begin(), feeds.front());
    path.feed_mm_s = AlongPath<double>(std::move(feeds));
    path.process.is_retracted = true;
    if (path.points.size() > 1) paths_.push_back(std::move(path));
  }

  /// A bead through points, from where the nozzle is brought to.
  /// @param beads  one for each point
  void lay(const std::vector<Point2>& points, const std::vector<Bead>& beads, double feed_mm_s) {
    Path path;
    path.role = PathRole::OuterWall;
    for (const Point2& point : points)
      path.points.emplace_back(point.x(), point.y(), settings_.bead_height_mm);
    if (!paths_.empty()) hopTo(path.points.front());
    path.bead = AlongPath<Bead>(beads);
    path.feed_mm_s = feed_mm_s;
    paths_.push_back(std::move(path));
  }
  void lay(const CalibrationBead& line) {
    const Bead bead{settings_.bead_width_mm, settings_.bead_height_mm};
    lay({line.start, line.end}, {bead, bead}, settings_.bead_mm_s);
  }

  Toolpath toolpath(const std::string& name) && {
    Toolpath toolpath;
    toolpath.part_name = name;
    ToolpathLayer layer;
    layer.z_mm = layer.height_mm = settings_.bead_height_mm;
    layer.paths = std::move(paths_);
    toolpath.layers.push_back(std::move(layer));
    return toolpath;
  }

 private:
  const CalibrationSettings& settings_;
  std::vector<Path> paths_;
};

double scanHeightOf(const CalibrationSettings& settings) {
  return settings.bead_height_mm + settings.clearance_mm;
}

/// How far from the middle a pass along y begins: beyond what is looked for at the greatest offset.
double halfPass(double half_mm, const CalibrationSettings& settings) {
  return half_mm + settings.scan_mm_s * settings.search_s + kScanMarginMm;
}

/// Swaths along y, back and forth, over a box around the middle.
void scan(PathChain& chain, const CalibrationSettings& settings, const Point2& half,
          const Point2& sensor_offset, double z) {
  const double width = 2.0 * (half.x() + kScanMarginMm);
  const int swaths = std::max(1, static_cast<int>(std::ceil(width / (settings.swath_mm * kSwathShare))));
  const double reach = halfPass(half.y(), settings);
  const Point2 middle = middleOf(settings) - sensor_offset;
  for (int i = 0; i < swaths; ++i) {
    const double x = middle.x() + width * ((i + 0.5) / swaths - 0.5);
    const double sense = i % 2 == 0 ? 1.0 : -1.0;
    chain.travelTo({x, middle.y() - sense * reach, z});
    chain.travel({{x, middle.y() + sense * reach, z}}, settings.scan_mm_s);
  }
}

/// Lifts the nozzle straight up from where it is.
void lift(PathChain& chain, const Point2& at, double z) { chain.travelTo({at.x(), at.y(), z}); }

}  // namespace

std::vector<CalibrationBead> crossBeads(const CalibrationSettings& settings) {
  const Point2 middle = middleOf(settings);
  const double side = 0.5 * settings.square_mm;
  const double arm = side - 2.0 * settings.bead_width_mm;
  const double gap = kArmGap * settings.bead_width_mm;
  const auto line = [&](const Point2& start, const Point2& end) {
    return CalibrationBead{middle + start, middle + end};
  };
  return {line({-side, -side}, {side, -side}), line({side, -side}, {side, side}),
          line({side, side}, {-side, side}),   line({-side, side}, {-side, -side}),
          line({-arm, 0.0}, {arm, 0.0}),       line({0.0, arm}, {0.0, gap}),
          line({0.0, -gap}, {0.0, -arm})};
}

FeederSteps feederSteps(const CalibrationSettings& settings) {
  const double more = 1.0 + settings.step;
  const double less = 1.0 - settings.step;
  FeederSteps steps{{}, {1.0, more, less, more, less, 1.0}};
  const double half = 0.5 * settings.step_mm * static_cast<double>(steps.amount.size());
  const double aside = 0.5 * settings.feeder_gap_mm;
  const Point2 middle = middleOf(settings);
  steps.beads = {{middle + Point2(-aside, -half), middle + Point2(-aside, half)},
                 {middle + Point2(aside, half), middle + Point2(aside, -half)}};
  return steps;
}

Toolpath bobbingToolpath(const CalibrationSettings& settings, const Point2& sensor_offset) {
  const Point2 at = middleOf(settings) - sensor_offset;
  const double middle_mm = scanHeightOf(settings) + settings.bob_mm;
  const double rise = (settings.bob_high_hz - settings.bob_low_hz) / settings.bob_s;
  // The half periods done by a time are 2 (low t + rise t² / 2): when each is done follows from the root.
  const auto doneAt = [&](int halves) {
    const double periods = 0.5 * halves;
    const double root =
        std::sqrt(std::max(0.0, settings.bob_low_hz * settings.bob_low_hz + 2.0 * rise * periods));
    return 2.0 * periods / (settings.bob_low_hz + root);
  };
  std::vector<Point3> points;
  std::vector<double> feeds;
  for (int halves = 1; doneAt(halves) <= settings.bob_s && halves < 100000; ++halves) {
    const double sense = halves % 2 == 0 ? -1.0 : 1.0;
    points.emplace_back(at.x(), at.y(), middle_mm + sense * settings.bob_mm);
    feeds.push_back(2.0 * settings.bob_mm / (doneAt(halves) - doneAt(halves - 1)));
  }
  const Point3 start(at.x(), at.y(), middle_mm - settings.bob_mm);
  PathChain chain(settings);
  chain.travel({start + Point3(0.0, 0.0, 2.0 * settings.bob_mm), start}, kTravelMmS);
  chain.travel(points, feeds);
  return std::move(chain).toolpath("bobbing");
}

Toolpath edgeToolpath(const CalibrationSettings& settings, const Point2& sensor_offset) {
  PathChain chain(settings);
  const Point2 middle = middleOf(settings);
  const Point2 half(0.5 * kPatchMm, 0.5 * kPatchBeads * settings.bead_width_mm);
  for (int i = 0; i < kPatchBeads; ++i) {
    const double y = (i + 0.5 - 0.5 * kPatchBeads) * settings.bead_width_mm;
    const double sense = i % 2 == 0 ? 1.0 : -1.0;
    chain.lay({middle + Point2(-sense * half.x(), y), middle + Point2(sense * half.x(), y)});
  }
  const double z = scanHeightOf(settings);
  lift(chain, middle + half, z);
  const Point2 at = middle - sensor_offset;
  const double reach = halfPass(half.y(), settings);
  chain.travelTo({at.x(), at.y() - reach, z});
  for (int i = 0; i < settings.passes; ++i)
    chain.travel({{at.x(), at.y() + (i % 2 == 0 ? reach : -reach), z}}, settings.scan_mm_s);
  return std::move(chain).toolpath("edge");
}

Toolpath crossToolpath(const CalibrationSettings& settings, const Point2& sensor_offset) {
  PathChain chain(settings);
  for (const CalibrationBead& bead : crossBeads(settings)) chain.lay(bead);
  const double z = scanHeightOf(settings);
  lift(chain, crossBeads(settings).back().end, z);
  const Point2 half(0.5 * settings.square_mm, 0.5 * settings.square_mm);
  scan(chain, settings, half, sensor_offset, z);
  if (settings.lift_mm > 0.0) scan(chain, settings, half, sensor_offset, z + settings.lift_mm);
  return std::move(chain).toolpath("cross");
}

Toolpath feederToolpath(const CalibrationSettings& settings, const Point2& sensor_offset) {
  PathChain chain(settings);
  const FeederSteps steps = feederSteps(settings);
  const double area = crossSection({settings.bead_width_mm, settings.bead_height_mm});
  for (const CalibrationBead& line : steps.beads) {
    std::vector<Point2> points(1, line.start);
    std::vector<Bead> beads(1, beadOfArea(area * steps.amount.front(), settings.bead_height_mm));
    for (std::size_t i = 0; i < steps.amount.size(); ++i) {
      const double part = static_cast<double>(i + 1) / static_cast<double>(steps.amount.size());
      points.push_back(line.start + part * (line.end - line.start));
      beads.push_back(beadOfArea(area * steps.amount[i], settings.bead_height_mm));
    }
    chain.lay(points, beads, settings.feeder_mm_s);
  }
  const double z = scanHeightOf(settings);
  lift(chain, steps.beads.back().end, z);
  const Point2 half(0.5 * settings.feeder_gap_mm,
                    0.5 * settings.step_mm * static_cast<double>(steps.amount.size()));
  scan(chain, settings, half, sensor_offset, z);
  return std::move(chain).toolpath("feeder");
}

}  // namespace lamina
