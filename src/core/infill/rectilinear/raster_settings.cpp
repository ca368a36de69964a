// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/rectilinear/raster_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, RasterSettings& settings) {
  schema.choice("raster.direction", settings.direction,
                {{"given", RasterDirection::Given},
                 {"fewest_turns", RasterDirection::FewestTurns},
                 {"least_travel", RasterDirection::LeastTravel}},
                "Direction of a raster: as infill.angle_deg says, or found for each layer.");
  schema.choice("raster.order", settings.order,
                {{"midpoints", SectionOrder::Midpoints},
                 {"ends", SectionOrder::Ends},
                 {"optimised", SectionOrder::Optimised}},
                "Order of the sections of a raster: greedy by midpoints or ends, or improved from there.");
  schema.number("raster.narrowest", settings.narrowest, {0.05, 1.0},
                "Narrowest bead of a solid raster, in pitches.");
  schema.number("raster.longest_connection_mm", settings.longest_connection_mm, {0.0, 100000.0},
                "Sections of a solid raster are connected along the border up to this way; 0 connects none.");
  schema.number("raster.most_connection", settings.most_connection, {0.0, 1.0},
                "Part of a region's area that these connections may overfill.");
}

}  // namespace lamina
