// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/scaffold/scaffold.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gyroid.hpp"
#include "infill/pattern/gyroid.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

/// One deposit of a layer, in the frame of the part's middle [mm].
struct ScaffoldRun {
  Polyline points;
  bool is_closed = false;
  PathRole role = PathRole::Infill;
  /// Section on the way to each point over that of the nominal bead; empty if it is 1 everywhere.
  std::vector<double> section{};
};

/// Puts layers of runs on each other, with travels between them.
class LayerAssembly {
 public:
  /// @param middle  of the part on the bed
  /// @param fill    section of a bead over its width times height
  LayerAssembly(const ScaffoldSettings& settings, const Point2& middle, double fill);

  void add(double top_mm, const std::vector<ScaffoldRun>& runs);
  Toolpath finish(const std::string& part_name);

 private:
  void travelTo(const Point3& start, ToolpathLayer& layer);
  Path path(const ScaffoldRun& run, const ToolpathLayer& layer) const;

  ScaffoldSettings settings_;
  Point2 middle_;
  double fill_;
  Toolpath toolpath_;
};

constexpr double kJoined = 1e-9;  // mm

double firstHeight(const ScaffoldSettings& settings) {
  return settings.first_layer_height_mm > 0.0 ? settings.first_layer_height_mm : settings.layer_height_mm;
}

/// Height of the top of each layer [mm].
std::vector<double> layerTops(const ScaffoldSettings& settings) {
  const double first = firstHeight(settings);
  const double others = (settings.height_mm - first) / settings.layer_height_mm;
  const auto count = static_cast<std::size_t>(std::max(0.0, std::round(others)));
  std::vector<double> tops;
  for (std::size_t layer = 0; layer <= count; ++layer)
    tops.push_back(first + static_cast<double>(layer) * settings.layer_height_mm);
  return tops;
}

/// The nominal bead of a layer: of a section that fills `fill` of width times height.
Bead scaffoldBead(const ScaffoldSettings& settings, double layer_height_mm, double fill) {
  return beadOfArea(fill * settings.bead_width_mm * layer_height_mm, layer_height_mm);
}

LayerAssembly::LayerAssembly(const ScaffoldSettings& settings, const Point2& middle, double fill)
    : settings_(settings), middle_(middle), fill_(fill) {}

void LayerAssembly::add(double top_mm, const std::vector<ScaffoldRun>& runs) {
  ToolpathLayer layer;
  layer.z_mm = top_mm;
  layer.height_mm = toolpath_.layers.empty() ? top_mm : settings_.layer_height_mm;
  for (const ScaffoldRun& run : runs) {
    Path deposited = path(run, layer);
    travelTo(deposited.firstPoint(), layer);
    layer.paths.push_back(std::move(deposited));
  }
  toolpath_.layers.push_back(std::move(layer));
}

Toolpath LayerAssembly::finish(const std::string& part_name) {
  toolpath_.part_name = part_name;
  return std::move(toolpath_);
}

/// The nozzle rises first, and leaves the part before a layer if it shall.
void LayerAssembly::travelTo(const Point3& start, ToolpathLayer& layer) {
  const bool begins_layer = layer.paths.empty();
  if (begins_layer && toolpath_.layers.empty()) return;
  const auto& paths = begins_layer ? toolpath_.layers.back().paths : layer.paths;
  const Point3 last = paths.back().lastPoint();
  Path travel;
  travel.role = PathRole::Travel;
  travel.feed_mm_s = settings_.travel_feed_mm_s;
  travel.points = {last};
  if (begins_layer) {
    travel.points.emplace_back(last.x(), last.y(), start.z());
    if (settings_.away_mm > 0.0)
      travel.points.emplace_back(settings_.corner_x_mm - settings_.away_mm, middle_.y(), start.z());
  }
  if ((travel.points.back() - start).norm() > kJoined) travel.points.push_back(start);
  if (travel.points.size() > 1) layer.paths.push_back(std::move(travel));
}

Path LayerAssembly::path(const ScaffoldRun& run, const ToolpathLayer& layer) const {
  Path path;
  path.role = run.role;
  path.is_closed = run.is_closed;
  path.feed_mm_s = settings_.feed_mm_s;
  for (const Point2& point : run.points)
    path.points.emplace_back(middle_.x() + point.x(), middle_.y() + point.y(), layer.z_mm);
  const Bead nominal = scaffoldBead(settings_, layer.height_mm, fill_);
  if (run.section.empty()) {
    path.bead = nominal;
    return path;
  }
  std::vector<Bead> beads;
  beads.reserve(run.section.size());
  for (const double part : run.section)
    beads.push_back(beadOfArea(part * crossSection(nominal), layer.height_mm));
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

constexpr double kParallelFill = M_PI / 4.0;
constexpr double kMirroredFill = 0.98;

void requireConsistent(const ScaffoldSettings& settings) {
  if (2.0 * settings.amplitude_mm > settings.length_mm)
    throw InvalidConfig("scaffold.amplitude_mm is " + numberText(settings.amplitude_mm) +
                        " mm; must be at most half of scaffold.length_mm, " +
                        numberText(0.5 * settings.length_mm) + " mm");
  if (settings.arrangement == FilamentArrangement::Mirrored && settings.wave != ScaffoldWave::Sine)
    throw InvalidConfig("scaffold.arrangement is mirrored; scaffold.wave must then be sine");
}

bool isMirrored(const ScaffoldSettings& settings) {
  return settings.arrangement == FilamentArrangement::Mirrored;
}

/// Offset of a filament from its middle line, over the amplitude.
double waveAt(const ScaffoldSettings& settings, std::size_t layer, double phase) {
  const bool has_first_wave = layer % 2 == 0;
  const bool is_sine =
      settings.wave == ScaffoldWave::Sine || (settings.wave == ScaffoldWave::SineCosine &&
                                              has_first_wave == (settings.first_wave == FirstWave::Sine));
  return is_sine ? std::sin(phase) : std::cos(phase);
}

/// Quarter turns of a layer.
std::size_t turnsOf(const ScaffoldSettings& settings, std::size_t layer) {
  return settings.wave == ScaffoldWave::SineCosine ? layer / 2 : layer;
}

Polyline filament(const ScaffoldSettings& settings, std::size_t layer, int index) {
  const double side = settings.length_mm;
  const double amplitude = settings.amplitude_mm;
  const double sign = isMirrored(settings) && index % 2 != 0 ? -1.0 : 1.0;
  const double middle = amplitude + index * (side - 2.0 * amplitude) / (settings.filaments - 1);
  const int segments = std::max(1, settings.cycles * settings.cycle_segments);
  const Eigen::Rotation2Dd turn(0.5 * M_PI * static_cast<double>(turnsOf(settings, layer) % 4));
  Polyline line;
  for (int s = 0; s <= segments; ++s) {
    const double along = static_cast<double>(s) / segments;
    const double wave = waveAt(settings, layer, 2.0 * M_PI * settings.cycles * along);
    line.push_back(turn * Point2(side * (along - 0.5), middle + sign * amplitude * wave - 0.5 * side));
  }
  return line;
}

/// See `makeScaffold`.
/// @param settings  within their bounds
Toolpath sinusoidalScaffold(const ScaffoldSettings& settings) {
  requireConsistent(settings);
  const double kind_fill = isMirrored(settings) ? kMirroredFill : kParallelFill;
  const Point2 corner(settings.corner_x_mm, settings.corner_y_mm);
  LayerAssembly assembly(settings, corner + Point2::Constant(0.5 * settings.length_mm),
                         settings.bead_fill > 0.0 ? settings.bead_fill : kind_fill);
  const std::vector<double> tops = layerTops(settings);
  for (std::size_t layer = 0; layer < tops.size(); ++layer) {
    std::vector<ScaffoldRun> runs;
    for (int i = 0; i < settings.filaments; ++i) {
      Polyline line = filament(settings, layer, i);
      // To and fro, so that travels are short.
      if (i % 2 != 0) std::reverse(line.begin(), line.end());
      runs.push_back({std::move(line)});
    }
    assembly.add(tops[layer], runs);
  }
  return assembly.finish("sinusoidal");
}

constexpr int kAllThatFit = 1 << 30;

/// What a layer is filled with.
struct LayerFill {
  const ScaffoldSettings& settings;
  std::size_t layer;
  double top_mm;
  double density;
  double pitch_mm;  ///< between lines at density 1
};

InfillRequest requestOf(const LayerFill& fill) {
  InfillRequest request;
  request.pitch_mm = fill.pitch_mm;
  request.spacing_mm = fill.pitch_mm / fill.density;
  request.layer = fill.layer;
  request.turn_rad = fill.layer % 2 == 0 ? 0.0 : 0.5 * M_PI;
  request.angle_rad = toRadians(fill.settings.angle_deg) + request.turn_rad;
  request.settings.perimeters.end_gap = 0.0;
  return request;
}

std::vector<ScaffoldRun> runsFrom(std::vector<FillPath> paths, double pitch_mm) {
  std::vector<ScaffoldRun> runs;
  for (FillPath& path : paths) {
    ScaffoldRun run{std::move(path.points), path.is_closed, path.role, std::move(path.width_mm)};
    for (double& part : run.section) part /= pitch_mm;
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<ScaffoldRun> perimeterRuns(const Regions& regions, const LayerFill& fill) {
  InfillRequest request = requestOf(fill);
  request.spacing_mm = fill.pitch_mm;
  request.settings.perimeters.count = fill.settings.perimeters;
  return runsFrom(infillStrategy("perimeters").fill(regions, request), fill.pitch_mm);
}

std::vector<ScaffoldRun> rings(const Regions& regions, const LayerFill& fill) {
  InfillRequest request = requestOf(fill);
  if (!isSolid(request)) request.settings.perimeters.count = kAllThatFit;
  std::vector<FillPath> paths = infillStrategy("perimeters").fill(regions, request);
  for (FillPath& path : paths) path.role = PathRole::Infill;
  return runsFrom(std::move(paths), fill.pitch_mm);
}

std::vector<ScaffoldRun> gyroidRuns(const Regions& regions, const LayerFill& fill) {
  const GyroidSlice slice{gyroidCell(fill.density / fill.pitch_mm), fill.top_mm,
                          toRadians(fill.settings.angle_deg)};
  std::vector<ScaffoldRun> runs;
  for (const Region& region : offset(regions, -0.5 * fill.pitch_mm))
    for (Polyline& line : gyroidLines(slice, region.outer)) runs.push_back({std::move(line)});
  return runs;
}

std::vector<ScaffoldRun> fillRuns(const Regions& regions, const LayerFill& fill) {
  const bool is_full = fill.density >= 1.0;
  switch (fill.settings.fill) {
    case ScaffoldFill::Concentric:
      return rings(regions, fill);
    case ScaffoldFill::Gyroid:
      // A gyroid has no solid form.
      if (!is_full) return gyroidRuns(regions, fill);
      break;
    case ScaffoldFill::Rectilinear:
      break;
  }
  return runsFrom(infillStrategy("zigzag").fill(regions, requestOf(fill)), fill.pitch_mm);
}

/// A full layer's pitch: what a stadium fills of the layer, or the width of a bead.
double pitchOf(const ScaffoldSettings& settings) {
  return settings.full_spacing == FullSpacing::Width
             ? settings.bead_width_mm
             : planWidth({settings.bead_width_mm, settings.layer_height_mm});
}

double fillOf(const ScaffoldSettings& settings) {
  if (settings.bead_fill > 0.0) return settings.bead_fill;
  return planWidth({settings.bead_width_mm, settings.layer_height_mm}) / settings.bead_width_mm;
}

/// A convex outline in every layer, filled: see `makeScaffold`.
/// @param outline   about its middle, counter-clockwise [mm]
/// @param settings  within their bounds
/// @throws InvalidConfig if a layer has no room for any bead
Toolpath filledShape(const std::string& name, const Polygon& outline, const ScaffoldSettings& settings) {
  const Box2 box = boundingBox({outline});
  const Point2 corner(settings.corner_x_mm, settings.corner_y_mm);
  LayerAssembly assembly(settings, corner - box.low, fillOf(settings));
  const std::vector<double> tops = layerTops(settings);
  const auto solid = static_cast<std::size_t>(settings.solid_layers);
  const double pitch = pitchOf(settings);
  for (std::size_t layer = 0; layer < tops.size(); ++layer) {
    const bool is_solid = layer < solid || layer + solid >= tops.size();
    const LayerFill fill{settings, layer, tops[layer], is_solid ? 1.0 : settings.density, pitch};
    std::vector<ScaffoldRun> runs;
    if (settings.perimeters > 0) runs = perimeterRuns({{outline, {}}}, fill);
    std::vector<ScaffoldRun> inner = fillRuns(offset({{outline, {}}}, -settings.perimeters * pitch), fill);
    std::move(inner.begin(), inner.end(), std::back_inserter(runs));
    if (runs.empty())
      throw InvalidConfig("scaffold.bead_width_mm is " + numberText(settings.bead_width_mm) +
                          " mm; a shape of " + numberText(box.size().x()) + " x " +
                          numberText(box.size().y()) + " mm has no room for a bead of that width");
    assembly.add(tops[layer], runs);
  }
  return assembly.finish(name);
}

constexpr int kCircleCorners = 180;

struct Kind {
  std::string meaning;
  ScaffoldSettings defaults;
  std::function<Toolpath(const ScaffoldSettings&)> make;
};

Polygon rectangle(double length, double breadth) {
  const double x = 0.5 * length;
  const double y = 0.5 * breadth;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Polygon circle(double diameter) {
  Polygon points;
  for (int i = 0; i < kCircleCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCircleCorners;
    points.emplace_back(0.5 * diameter * std::cos(angle), 0.5 * diameter * std::sin(angle));
  }
  return points;
}

ScaffoldSettings cylinderDefaults() {
  ScaffoldSettings settings;
  settings.height_mm = 7.0;
  settings.first_layer_height_mm = 0.35;
  settings.angle_deg = 90.0;
  return settings;
}

ScaffoldSettings specimenDefaults() {
  ScaffoldSettings settings;
  settings.length_mm = 40.0;
  settings.breadth_mm = 5.0;
  settings.height_mm = 2.0;
  settings.fill = ScaffoldFill::Concentric;
  settings.full_spacing = FullSpacing::Width;
  settings.density = 0.2;
  settings.perimeters = 1;
  settings.solid_layers = 1;
  settings.feed_mm_s = 30.0;
  return settings;
}

ScaffoldSettings sinusoidalDefaults() {
  ScaffoldSettings settings;
  settings.away_mm = 10.0;
  return settings;
}

Toolpath cube(const ScaffoldSettings& settings) {
  ScaffoldSettings sides = settings;
  sides.height_mm = settings.length_mm;
  return filledShape("cube", rectangle(settings.length_mm, settings.length_mm), sides);
}

std::function<Toolpath(const ScaffoldSettings&)> boxOf(const std::string& name) {
  return [name](const ScaffoldSettings& settings) {
    return filledShape(name, rectangle(settings.length_mm, settings.breadth_mm), settings);
  };
}

const std::map<std::string, Kind>& kinds() {
  static const std::map<std::string, Kind> by_name = {
      {"bending_specimen",
       {"A bar for three-point bending, of rings with solid layers below and above.", specimenDefaults(),
        boxOf("bending_specimen")}},
      {"box", {"A box filled by lines, rings or a gyroid.", {}, boxOf("box")}},
      {"cube", {"A cube filled by lines, rings or a gyroid.", {}, cube}},
      {"cylinder",
       {"A cylinder filled by lines, rings or a gyroid.", cylinderDefaults(),
        [](const ScaffoldSettings& settings) {
          return filledShape("cylinder", circle(settings.diameter_mm), settings);
        }}},
      {"sinusoidal",
       {"A cube of layers of wavy filaments, turned from layer to layer.", sinusoidalDefaults(),
        sinusoidalScaffold}},
  };
  return by_name;
}

const Kind& kindOf(const std::string& name) {
  const auto found = kinds().find(name);
  if (found != kinds().end()) return found->second;
  throw InvalidConfig("scaffold is '" + name + "'; must be one of " + listed(scaffoldNames(), " | "));
}

void requireWideBeads(const ScaffoldSettings& settings) {
  const double highest = std::max(settings.layer_height_mm, settings.first_layer_height_mm);
  if (settings.bead_width_mm >= highest) return;
  throw InvalidConfig("scaffold.bead_width_mm is " + numberText(settings.bead_width_mm) +
                      " mm; must be at least the height of a layer, " + numberText(highest) + " mm");
}

}  // namespace

std::vector<std::string> scaffoldNames() {
  std::vector<std::string> names;
  for (const auto& entry : kinds()) names.push_back(entry.first);
  return names;
}

std::string scaffoldMeaning(const std::string& name) { return kindOf(name).meaning; }

ScaffoldSettings scaffoldDefaults(const std::string& name) { return kindOf(name).defaults; }

Toolpath makeScaffold(const std::string& name, const ScaffoldSettings& settings) {
  const Kind& kind = kindOf(name);
  ScaffoldSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  requireWideBeads(settings);
  return kind.make(settings);
}

}  // namespace lamina
