// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/conformal/conformal_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ConformalSettings& settings) {
  schema.text(
      "conformal.base", settings.base,
      "Mesh file of the surface that the part's layers follow; empty lays a coat on the part itself.");
  schema.number("conformal.max_tilt_deg", settings.max_tilt_deg, Bounds::above(0.0, 90.0),
                "Faces that look away from the direction by no more than this are coated.");
  schema.numbers("conformal.direction", settings.direction, 3,
                 "Where the coated faces look; up if not given.");
  schema.number("conformal.thickness_mm", settings.thickness_mm, Bounds::above(0.0, 1000.0),
                "Thickness of a coat.");
  schema.number("conformal.longest_edge_mm", settings.longest_edge_mm, Bounds::above(0.0, 100.0),
                "Longer edges of the coated surface are halved; layers end true to about its square "
                "over eight times the part's radius of curvature.");
  schema.number("conformal.largest_gap_percent", settings.largest_gap_percent, Bounds::above(0.0, 100.0),
                "Of a part on a base: how much of its volume the layers may leave open or lay too much.");
}

}  // namespace lamina
