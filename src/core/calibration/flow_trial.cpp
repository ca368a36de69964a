// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/flow_trial.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "recording_table.hpp"

namespace lamina {
namespace {

constexpr double kTrialTravelMmS = 100.0;
constexpr double kHopMm = 0.4;
constexpr std::size_t kLeastReadings = 3;

/// By which two beads on each other are thinner where they meet than at their middles, for each height.
const double kRoundSides = 1.0 - 0.25 * M_PI;

Bead nominalBead(const FlowTrialSettings& settings) { return {settings.width_mm, settings.layer_mm}; }

std::vector<Point2> middlesOf(const FlowTrialSettings& settings) {
  const double pitch_mm = settings.side_mm + settings.gap_mm;
  std::vector<Point2> middles;
  middles.reserve(static_cast<std::size_t>(settings.squares));
  for (int i = 0; i < settings.squares; ++i)
    middles.emplace_back(settings.x_mm + pitch_mm * (i - 0.5 * (settings.squares - 1)), settings.y_mm);
  return middles;
}

Path squareAround(const Point2& middle, double z_mm, double multiplier, const FlowTrialSettings& settings) {
  const double half = 0.5 * settings.side_mm;
  Path path;
  path.role = PathRole::OuterWall;
  path.is_closed = true;
  for (const Point2& corner :
       {Point2(half, -half), Point2(half, half), Point2(-half, half), Point2(-half, -half)})
    path.points.emplace_back(middle.x() + corner.x(), middle.y() + corner.y(), z_mm);
  path.bead = beadOfArea(multiplier * crossSection(nominalBead(settings)), settings.layer_mm);
  path.feed_mm_s = settings.feed_mm_s;
  return path;
}

Path travelTo(const Point3& from, const Point3& to) {
  const Point3 hop(0.0, 0.0, kHopMm);
  const double level = std::max(from.z(), to.z());
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, Point3(from.x(), from.y(), level) + hop, Point3(to.x(), to.y(), level) + hop, to};
  path.feed_mm_s = kTrialTravelMmS;
  path.process.is_retracted = true;
  return path;
}

/// Sums of a line through readings (multiplier of the nominal section, section).
struct LineSums {
  double count = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
};

LineSums lineSumsOf(const std::vector<FlowReading>& readings, double nominal_mm2) {
  LineSums sums;
  for (const FlowReading& reading : readings) {
    const double x = reading.multiplier * nominal_mm2;
    sums.count += 1.0;
    sums.x += x;
    sums.y += reading.section_mm2;
    sums.xx += x * x;
    sums.xy += x * reading.section_mm2;
  }
  return sums;
}

void requireReadings(const std::vector<FlowReading>& readings) {
  if (readings.size() < kLeastReadings)
    throw InvalidInput("there are " + std::to_string(readings.size()) +
                       " readings of walls; expected at least " + std::to_string(kLeastReadings));
  const auto [least, greatest] = std::minmax_element(
      readings.begin(), readings.end(),
      [](const FlowReading& a, const FlowReading& b) { return a.multiplier < b.multiplier; });
  if (!(greatest->multiplier > least->multiplier))
    throw InvalidInput("all readings are of the multiplier " + numberText(least->multiplier) +
                       "; expected walls of two multipliers at least");
}

}  // namespace

void describe(SettingsSchema& schema, FlowTrialSettings& settings) {
  const Bounds place{-1e5, 1e5};
  const Bounds length = Bounds::above(0.0, 1000.0);
  schema.number("flow_trial.x_mm", settings.x_mm, place, "Middle of the row of squares, on the bed.");
  schema.number("flow_trial.y_mm", settings.y_mm, place, "Middle of the row of squares, on the bed.");
  schema.integer("flow_trial.squares", settings.squares, {2, 100}, "Number of squares.");
  schema.number("flow_trial.span", settings.span, Bounds::above(0.0, 0.5),
                "Share by which the first square has less than the nominal flow, and the last one more.");
  schema.number("flow_trial.side_mm", settings.side_mm, length, "Side of each square.");
  schema.number("flow_trial.gap_mm", settings.gap_mm, length, "Distance of neighbouring squares.");
  schema.number("flow_trial.height_mm", settings.height_mm, length, "Height of the squares.");
  schema.number("flow_trial.width_mm", settings.width_mm, Bounds::above(0.0, 100.0),
                "Thickness of walls at the nominal flow.");
  schema.number("flow_trial.layer_mm", settings.layer_mm, {0.01, 100.0}, "Height of layers.");
  schema.number("flow_trial.feed_mm_s", settings.feed_mm_s, Bounds::above(0.0, 1000.0), "Speed of walls.");
  schema.number("flow_trial.reading_mm", settings.reading_mm, Bounds::above(0.0, 1.0),
                "Standard deviation of a reading of a wall's thickness, at least.");
}

void requireConsistent(const FlowTrialSettings& settings) {
  const auto require = [](bool is_met, const std::string& key_is, const std::string& expected) {
    if (!is_met) throw InvalidConfig(key_is + "; expected " + expected);
  };
  require(settings.layer_mm <= (1.0 - settings.span) * settings.width_mm,
          "flow_trial.layer_mm is " + numberText(settings.layer_mm) + " mm",
          "at most the walls' thickness at the least flow, " +
              numberText((1.0 - settings.span) * settings.width_mm) + " mm");
  require(settings.side_mm > 4.0 * settings.width_mm,
          "flow_trial.side_mm is " + numberText(settings.side_mm) + " mm",
          "more than four walls, " + numberText(4.0 * settings.width_mm) + " mm");
  require(settings.gap_mm > 2.0 * settings.width_mm,
          "flow_trial.gap_mm is " + numberText(settings.gap_mm) + " mm",
          "more than two walls, " + numberText(2.0 * settings.width_mm) + " mm");
  require(settings.height_mm >= settings.layer_mm,
          "flow_trial.height_mm is " + numberText(settings.height_mm) + " mm",
          "a layer at least, " + numberText(settings.layer_mm) + " mm");
}

std::vector<double> flowMultipliers(const FlowTrialSettings& settings) {
  std::vector<double> multipliers;
  multipliers.reserve(static_cast<std::size_t>(settings.squares));
  for (int i = 0; i < settings.squares; ++i)
    multipliers.push_back(1.0 + settings.span * (2.0 * i / (settings.squares - 1) - 1.0));
  return multipliers;
}

Toolpath flowTrialToolpath(const FlowTrialSettings& settings) {
  requireConsistent(settings);
  const std::vector<double> multipliers = flowMultipliers(settings);
  const std::vector<Point2> middles = middlesOf(settings);
  Toolpath toolpath;
  toolpath.part_name = "flow";
  const auto layers = static_cast<int>(std::lround(settings.height_mm / settings.layer_mm));
  std::optional<Point3> from;
  for (int k = 1; k <= layers; ++k) {
    ToolpathLayer layer;
    layer.z_mm = k * settings.layer_mm;
    layer.height_mm = settings.layer_mm;
    for (std::size_t i = 0; i < middles.size(); ++i) {
      Path square = squareAround(middles[i], layer.z_mm, multipliers[i], settings);
      if (from) layer.paths.push_back(travelTo(*from, square.firstPoint()));
      from = square.lastPoint();
      layer.paths.push_back(std::move(square));
    }
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

std::vector<FlowReading> flowReadings(const std::string& text, const std::string& source,
                                      const FlowTrialSettings& settings) {
  const RecordingTable table = parseRecordingTable(text, source);
  const std::size_t multiplier = requireColumn(table, "multiplier");
  const bool has_sections = findColumn(table, "section_mm2") < table.columns.size();
  const std::size_t measured = requireColumn(table, has_sections ? "section_mm2" : "thickness_mm");
  const double round_mm = kRoundSides * settings.layer_mm;
  std::vector<FlowReading> readings;
  readings.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    FlowReading reading{table.at(row, multiplier), table.at(row, measured)};
    const std::string at = "'" + source + "' line " + std::to_string(table.lines[row]) + ": ";
    if (!(reading.multiplier > 0.0))
      throw InvalidInput(at + "multiplier is " + numberText(reading.multiplier) + "; expected above 0");
    const double least = has_sections ? 0.0 : round_mm;
    if (!(reading.section_mm2 > least))
      throw InvalidInput(at + (has_sections ? "section_mm2 is " : "thickness_mm is ") +
                         numberText(reading.section_mm2) + "; expected above " + numberText(least));
    if (!has_sections) reading.section_mm2 = settings.layer_mm * (reading.section_mm2 - round_mm);
    readings.push_back(reading);
  }
  return readings;
}

FlowFit fitFlow(const std::vector<FlowReading>& readings, const FlowTrialSettings& settings) {
  requireReadings(readings);
  const double nominal_mm2 = crossSection(nominalBead(settings));
  const LineSums sums = lineSumsOf(readings, nominal_mm2);
  FlowFit fit;
  fit.readings = readings.size();
  fit.share = sums.xy / sums.xx;
  double squares = 0.0;
  for (const FlowReading& reading : readings) {
    const double residual = reading.section_mm2 - fit.share * reading.multiplier * nominal_mm2;
    squares += residual * residual;
  }
  fit.rms_mm2 = std::sqrt(squares / sums.count);
  const double scatter_mm2 =
      std::max(std::sqrt(squares / (sums.count - 1.0)), settings.layer_mm * settings.reading_mm);
  fit.share_spread = scatter_mm2 / std::sqrt(sums.xx);
  fit.factor = 1.0 / fit.share;
  fit.factor_spread = fit.share_spread / (fit.share * fit.share);
  const double varied = sums.xx - sums.x * sums.x / sums.count;
  const double slope = (sums.xy - sums.x * sums.y / sums.count) / varied;
  const double level_mm2 = (sums.y - slope * sums.x) / sums.count;
  double off_line = 0.0;
  for (const FlowReading& reading : readings) {
    const double residual = reading.section_mm2 - level_mm2 - slope * reading.multiplier * nominal_mm2;
    off_line += residual * residual;
  }
  const double off_line_mm2 =
      std::max(std::sqrt(off_line / (sums.count - 2.0)), settings.layer_mm * settings.reading_mm);
  fit.follows = slope / fit.share;
  fit.follows_spread = off_line_mm2 / std::sqrt(varied) / fit.share;
  return fit;
}

}  // namespace lamina
