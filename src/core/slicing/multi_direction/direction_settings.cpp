// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/multi_direction/direction_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, DirectionSettings& settings) {
  schema.integer("directions.count", settings.count, {9, 5001},
                 "Directions that pieces are tried along, at least, evenly over the half sphere.");
  schema.integer("directions.beam", settings.beam, {1, 100},
                 "Sequences of cuts that the search follows side by side.");
  schema.integer("directions.most_cuts", settings.most_cuts, {0, 30}, "Greatest number of cuts.");
  schema.number("directions.max_tilt_deg", settings.max_tilt_deg, {0.0, 90.0},
                "Greatest tilt of a piece's direction from up.");
  schema.number("directions.max_overhang_deg", settings.max_overhang_deg, {0.0, 60.0},
                "Greatest overhang that the material takes, from a piece's direction; 0 on walls along it.");
  schema.number("directions.cell_mm", settings.cell_mm, {0.0, 10.0},
                "Side of the cells that pieces are weighed in; 0 chooses it by the part's volume.");
  schema.number("directions.largest_unsupported_percent", settings.largest_unsupported_percent, {0.0, 100.0},
                "Of the part's surface: how much may overhang by more than is taken before it is refused.");
}

}  // namespace lamina
