// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/scaffold/scaffold.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "scaffold/filled_shape.hpp"
#include "scaffold/sinusoidal.hpp"

namespace lamina {
namespace {

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
  throw InvalidConfig("scaffold.bead_width_mm is " + std::to_string(settings.bead_width_mm) +
                      " mm; must be at least the height of a layer, " + std::to_string(highest) + " mm");
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
