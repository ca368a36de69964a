// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A parameter of a part. Its key ends in its unit if it has one: "height_mm", "twist_deg", "segments".
struct PartParameter {
  std::string key;
  std::string default_value;
  std::string bounds;  ///< "(0, 1000]"
  std::string meaning;
};

/// Names of all parametric parts: bevelled_cube, blade, blind_hole_plate, box, bridge, cone, cone_array,
/// curved_wall, cylinder, dome, elbow, flare, flat_wall, pillar_field, pyramid, roof_niche, semi_cone,
/// sphere, stepped_pyramid, tee, tetradecahedron, thin_roof, through_hole_plate, tube, two_towers, u_channel.
std::vector<std::string> partNames();

/// Whether there is a part of that name.
bool isPartName(const std::string& name);

/// Description of a part in one sentence.
/// @throws InvalidConfig if there is no such part; the message names all parts
std::string partMeaning(const std::string& name);

/// The parameters of a part.
/// @throws InvalidConfig if there is no such part; the message names all parts
std::vector<PartParameter> partParameters(const std::string& name);

/// Makes a part [mm], standing on z = 0 with the z axis through its middle: a closed mesh that faces
/// outwards, with every vertex stored once. Round surfaces are inscribed polygons with the given number of
/// segments. Parameters that are not given keep their defaults.
///
/// @throws InvalidConfig if there is no such part or parameter (the message names all), or a value is out of
///   bounds or contradicts another
Mesh makePart(const std::string& name, const std::vector<SettingText>& parameters = {});

}  // namespace lamina
