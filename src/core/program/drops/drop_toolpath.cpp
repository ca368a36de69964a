// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/drops/drop_program.hpp"

namespace lamina {
namespace {

constexpr double kSameDropHeight = 1e-4;  // mm
constexpr double kFallbackHeight = 0.2;   // mm: of a layer no higher than the one before, as for beads

double heightOf(const DropProgram& program, std::size_t index) {
  const DropProgramLayer& layer = program.layers[index];
  if (layer.height_mm) return *layer.height_mm;
  if (program.layer_height_mm) return *program.layer_height_mm;
  const double below = index == 0 ? 0.0 : program.layers[index - 1].drops.front().position.z();
  const double rise = layer.drops.front().position.z() - below;
  return rise > kSameDropHeight ? rise : kFallbackHeight;
}

Path travelBetween(const Point3& from, const Point3& to, double feed_mm_s) {
  Path travel;
  travel.role = PathRole::Travel;
  travel.points = {from, to};
  travel.feed_mm_s = feed_mm_s;
  return travel;
}

ToolpathLayer layerOf(const DropProgramLayer& source, double height_mm, double diameter_mm,
                      std::optional<Point3>& reached) {
  ToolpathLayer layer;
  layer.z_mm = source.drops.front().position.z();
  layer.height_mm = height_mm;
  std::size_t section = 0;
  for (std::size_t i = 0; i < source.drops.size(); ++i) {
    const ProgramDrop& drop = source.drops[i];
    if (i == 0 || drop.section != section) {
      if (reached && *reached != drop.position)
        layer.paths.push_back(travelBetween(*reached, drop.position, drop.feed_mm_s));
      Path path;
      path.role = drop.role.value_or(PathRole::Infill);
      path.deposit = Deposit::Drops;
      path.bead = Bead{diameter_mm, height_mm};
      path.feed_mm_s = drop.feed_mm_s;
      layer.paths.push_back(std::move(path));
      section = drop.section;
    }
    layer.paths.back().points.push_back(drop.position);
    reached = drop.position;
  }
  return layer;
}

}  // namespace

Toolpath toolpathOf(const DropProgram& program, const std::string& part_name) {
  if (program.layers.empty())
    throw InvalidProgram("'" + part_name + "' lets no drop go; expected a program of drops");
  if (!program.diameter_mm)
    throw InvalidProgram("'" + part_name + "' lets drops go, but its header states no diameter of drops");
  Toolpath toolpath;
  toolpath.part_name = part_name;
  std::optional<Point3> reached;
  for (std::size_t i = 0; i < program.layers.size(); ++i)
    toolpath.layers.push_back(
        layerOf(program.layers[i], heightOf(program, i), *program.diameter_mm, reached));
  return toolpath;
}

}  // namespace lamina
