// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/parts/parts.hpp"

#include <algorithm>
#include <functional>

#include "lamina/base/edit_distance.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

struct Part {
  std::string name;
  std::string meaning;
  std::function<std::vector<PartParameter>()> parameters;
  std::function<Mesh(const std::vector<SettingText>&)> make;
};

template <class Shape>
std::vector<PartParameter> parametersOf() {
  Shape shape;
  SettingsSchema schema;
  describe(schema, shape);
  std::vector<PartParameter> parameters;
  for (const Setting& setting : schema.settings())
    parameters.push_back({setting.key, setting.get(), setting.bounds, setting.meaning});
  return parameters;
}

std::vector<std::string> keysOf(const std::vector<Setting>& settings) {
  std::vector<std::string> keys;
  keys.reserve(settings.size());
  for (const Setting& setting : settings) keys.push_back(setting.key);
  return keys;
}

template <class Shape>
Part part(const std::string& name, const std::string& meaning) {
  const auto make = [name](const std::vector<SettingText>& values) {
    Shape shape;
    SettingsSchema schema;
    describe(schema, shape);
    for (const SettingText& value : values) {
      const auto& settings = schema.settings();
      const auto has_key = [&](const Setting& setting) { return setting.key == value.key; };
      const auto found = std::find_if(settings.begin(), settings.end(), has_key);
      if (found == settings.end())
        throw InvalidConfig("part '" + name + "' has no parameter '" + value.key + "'; it has " +
                            listed(keysOf(settings)) + suggestionFor(keysOf(settings), value.key));
      found->set(value.text);
    }
    return build(shape);
  };
  return {name, meaning, parametersOf<Shape>, make};
}

std::vector<Part> parts() {
  return {part<BevelledCube>("bevelled_cube",
                             "a cube with bevelled upper and lower edges, an octagon from each side"),
          part<Blade>("blade", "a cambered blade that twists and leans with height"),
          part<BlindHolePlate>("blind_hole_plate", "a plate with a round hole from above that ends inside"),
          part<CuboidShape>("box", "a box"),
          part<BridgeShape>("bridge", "two pillars and a plate over both"),
          part<Cone>("cone", "a cone, or a frustum"),
          part<ConeArray>("cone_array", "a row of frustums that lean outwards, each by another angle"),
          part<CurvedWall>("curved_wall", "a thin upright wall along an arc"),
          part<Cylinder>("cylinder", "an upright cylinder"),
          part<Dome>("dome", "the upper half of a sphere"),
          part<Elbow>("elbow", "a round rod that stands upright and bends over"),
          part<Flare>("flare", "a round part whose side leans out, the more the higher"),
          part<FlatWall>("flat_wall", "a thin upright wall"),
          part<PillarField>("pillar_field", "round pins that stand in a square"),
          part<Pyramid>("pyramid", "a pyramid on a rectangle"),
          part<RoofNiche>("roof_niche", "a block with a niche in its side, under a level roof"),
          part<SemiCone>("semi_cone", "half of a cone, cut through its axis"),
          part<Sphere>("sphere", "a sphere"),
          part<SteppedPyramid>("stepped_pyramid", "squares on each other, each smaller all round"),
          part<TeeShape>("tee", "a bar across the top of a stem"),
          part<Tetradecahedron>("tetradecahedron", "a truncated octahedron on one of its squares"),
          part<ThinRoof>("thin_roof", "a hollow cube with a thin roof amid its void"),
          part<ThroughHolePlate>("through_hole_plate", "a plate with a round hole right through"),
          part<Tube>("tube", "an upright tube"),
          part<TwoTowers>("two_towers", "two equal towers beside each other"),
          part<UChannel>("u_channel", "a block with a notch from behind, right through")};
}

Part find(const std::string& name) {
  for (Part& part : parts())
    if (part.name == name) return part;
  throw InvalidConfig("there is no part '" + name + "'; expected one of " + listed(partNames()) +
                      suggestionFor(partNames(), name));
}

}  // namespace

std::vector<std::string> partNames() {
  std::vector<std::string> names;
  for (const Part& part : parts()) names.push_back(part.name);
  return names;
}

bool isPartName(const std::string& name) {
  const std::vector<std::string> names = partNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string partMeaning(const std::string& name) { return find(name).meaning; }

std::vector<PartParameter> partParameters(const std::string& name) { return find(name).parameters(); }

Mesh makePart(const std::string& name, const std::vector<SettingText>& parameters) {
  return find(name).make(parameters);
}

}  // namespace lamina
