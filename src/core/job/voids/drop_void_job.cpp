// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/drop_void_job.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

constexpr double kJump = 2.0;  // diameters, and steps: drops so far apart do not follow each other

DropRole dropRole(PathRole role) {
  if (role == PathRole::GapFill) return DropRole::VoidFill;
  return kindOf(role) == RoleKind::Infill ? DropRole::Infill : DropRole::Contour;
}

/// Programs may state one role for several contours: one that is back at its start ends where the
/// next drop is far.
bool isJump(const DropLayer& layer, const DropChain& chain, std::size_t next) {
  if (next < chain.begin + 3) return false;
  const Point2& last = layer.drops[next - 1];
  const double near = kJump * std::max(layer.diameter_mm, (last - layer.drops[next - 2]).norm());
  return (layer.drops[next] - last).norm() > near && (last - layer.drops[chain.begin]).norm() <= near;
}

DropLayer layerOf(const DropProgramLayer& source, const DropProgram& program) {
  DropLayer layer;
  layer.diameter_mm = *program.diameter_mm;
  layer.is_dense = program.strategy.find("dense") != std::string::npos;
  bool has_roles = true;
  for (std::size_t i = 0; i < source.drops.size(); ++i) {
    const ProgramDrop& drop = source.drops[i];
    has_roles = has_roles && drop.role.has_value();
    layer.drops.push_back(drop.position.head<2>());
    if (i == 0 || drop.section != source.drops[i - 1].section || isJump(layer, layer.chains.back(), i))
      layer.chains.push_back({dropRole(drop.role.value_or(PathRole::Infill)), i, i});
    layer.chains.back().end = i + 1;
  }
  if (!has_roles) layer.chains = guessChains(layer.drops, layer.diameter_mm);
  return layer;
}

DropLayer layerOf(const ToolpathLayer& source) {
  DropLayer layer;
  for (const Path& path : source.paths) {
    if (path.deposit != Deposit::Drops) continue;
    const std::size_t begin = layer.drops.size();
    layer.diameter_mm = path.bead.at(0).width_mm;
    for (const Point3& point : path.points) layer.drops.push_back(point.head<2>());
    layer.chains.push_back({dropRole(path.role), begin, layer.drops.size()});
  }
  return layer;
}

DropVoidReport report(const std::vector<DropLayer>& layers, const DropVoidSettings& settings,
                      Progress& progress) {
  DropVoidReport found;
  found.voids.resize(layers.size());
  std::vector<OverlapReading> readings(layers.size());
  std::vector<int> is_unbounded(layers.size(), 0);
  parallelFor(
      layers.size(),
      [&](std::size_t i) {
        if (layers[i].drops.empty()) return;
        is_unbounded[i] = borders(contoursOf(layers[i])).empty() ? 1 : 0;
        found.voids[i] = fillDropVoids(layers[i], settings);
        readings[i] = measureOverlap(layers[i].drops, newDrops(found.voids[i]), layers[i].diameter_mm);
      },
      progress, "fill voids");
  for (const OverlapReading& reading : readings) found.overlap = found.overlap + reading;
  found.layers_without_contour =
      static_cast<std::size_t>(std::count(is_unbounded.begin(), is_unbounded.end(), 1));
  found.is_worth_it = static_cast<double>(found.overlap.added) >=
                          settings.least_share * static_cast<double>(found.overlap.prior) &&
                      found.overlap.added > 0;
  return found;
}

template <class Value>
void forEachVoid(const DropVoidReport& report, Value visit) {
  for (const std::vector<DropVoid>& layer : report.voids)
    for (const DropVoid& each : layer) visit(each);
}

/// To the drops and back to where the layer ended, so that the next one need not know of them.
void appendDrops(ToolpathLayer& layer, const std::vector<Point2>& drops, double travel_feed_mm_s) {
  if (drops.empty()) return;
  const auto last_drops = std::find_if(layer.paths.rbegin(), layer.paths.rend(),
                                       [](const Path& path) { return path.deposit == Deposit::Drops; });
  Path filling = *last_drops;
  filling.role = PathRole::GapFill;
  filling.is_closed = false;
  filling.orientation = filling.orientation.at(0);
  filling.feed_mm_s = filling.feed_mm_s.at(0);
  filling.points.clear();
  for (const Point2& drop : drops) filling.points.emplace_back(drop.x(), drop.y(), layer.z_mm);
  Path travel;
  travel.role = PathRole::Travel;
  travel.orientation = filling.orientation;
  travel.feed_mm_s = travel_feed_mm_s;
  const Point3 end = layer.paths.back().lastPoint();
  travel.points = {end, filling.firstPoint()};
  layer.paths.push_back(travel);
  travel.points = {filling.lastPoint(), end};
  layer.paths.push_back(std::move(filling));
  layer.paths.push_back(std::move(travel));
}

}  // namespace

std::vector<DropLayer> dropLayers(const DropProgram& program) {
  if (program.layers.empty())
    throw InvalidProgram("the program lets no drop go; expected a program of drops");
  if (!program.diameter_mm)
    throw InvalidProgram(
        "the header of the program reports no diameter of drops; expected drop_diameter=...");
  std::vector<DropLayer> layers;
  for (const DropProgramLayer& layer : program.layers) layers.push_back(layerOf(layer, program));
  return layers;
}

std::size_t DropVoidReport::count() const {
  std::size_t sum = 0;
  for (const std::vector<DropVoid>& layer : voids) sum += layer.size();
  return sum;
}

double DropVoidReport::uncoveredBefore() const {
  double sum = 0.0;
  forEachVoid(*this, [&](const DropVoid& each) { sum += each.uncovered_before_mm2; });
  return sum;
}

double DropVoidReport::uncoveredAfter() const {
  double sum = 0.0;
  forEachVoid(*this, [&](const DropVoid& each) { sum += each.uncovered_after_mm2; });
  return sum;
}

double DropVoidReport::largestBefore() const {
  double most = 0.0;
  forEachVoid(*this, [&](const DropVoid& each) { most = std::max(most, each.uncovered_before_mm2); });
  return most;
}

double DropVoidReport::largestAfter() const {
  double most = 0.0;
  forEachVoid(*this, [&](const DropVoid& each) { most = std::max(most, each.uncovered_after_mm2); });
  return most;
}

std::map<VoidClass, std::size_t> DropVoidReport::countByClass() const {
  std::map<VoidClass, std::size_t> counts;
  forEachVoid(*this, [&](const DropVoid& each) { ++counts[each.kind]; });
  return counts;
}

DropVoidReport reportDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                               Progress& progress) {
  DropVoidReport found = report(dropLayers(program), settings, progress);
  found.diameter_mm = *program.diameter_mm;
  for (const DropProgramLayer& layer : program.layers)
    found.heights_mm.push_back(layer.drops.front().position.z());
  return found;
}

FilledDropProgram fillDropProgram(const DropProgram& program, const DropVoidSettings& settings,
                                  const DropDialect& dialect, Progress& progress) {
  FilledDropProgram filled;
  filled.report = reportDropVoids(program, settings, progress);
  std::vector<std::vector<Point2>> added;
  for (const std::vector<DropVoid>& layer : filled.report.voids) added.push_back(newDrops(layer));
  filled.text = withDrops(program, added, dialect);
  return filled;
}

Toolpath withDropVoidsFilled(Toolpath toolpath, const DropVoidSettings& settings, double travel_feed_mm_s,
                             Progress& progress) {
  requireLevelLayers(toolpath, "filling the voids between drops");
  std::vector<DropLayer> layers;
  for (const ToolpathLayer& layer : toolpath.layers) layers.push_back(layerOf(layer));
  const DropVoidReport found = report(layers, settings, progress);
  for (std::size_t i = 0; i < layers.size(); ++i)
    appendDrops(toolpath.layers[i], newDrops(found.voids[i]), travel_feed_mm_s);
  return toolpath;
}

}  // namespace lamina
