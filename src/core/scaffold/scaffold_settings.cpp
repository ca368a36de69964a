// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/scaffold/scaffold_settings.hpp"

namespace lamina {
namespace {

void describeShape(SettingsSchema& schema, ScaffoldSettings& settings) {
  schema.number("scaffold.corner_x_mm", settings.corner_x_mm, {-1e4, 1e4},
                "Low corner of the part on the bed.");
  schema.number("scaffold.corner_y_mm", settings.corner_y_mm, {-1e4, 1e4},
                "Low corner of the part on the bed.");
  schema.number("scaffold.length_mm", settings.length_mm, Bounds::above(0.0, 1000.0),
                "Along x; of cubes and sinusoidal scaffolds along y and of cubes the height too.");
  schema.number("scaffold.breadth_mm", settings.breadth_mm, Bounds::above(0.0, 1000.0), "Along y, of a box.");
  schema.number("scaffold.diameter_mm", settings.diameter_mm, Bounds::above(0.0, 1000.0), "Of a cylinder.");
  schema.number("scaffold.height_mm", settings.height_mm, Bounds::above(0.0, 1000.0),
                "Height of the part, rounded to whole layers.");
}

void describeBeads(SettingsSchema& schema, ScaffoldSettings& settings) {
  schema.number("scaffold.layer_height_mm", settings.layer_height_mm, {0.01, 10.0}, "Of each layer.");
  schema.number("scaffold.first_layer_height_mm", settings.first_layer_height_mm, {0.0, 10.0},
                "Of the first layer; 0 takes that of the others.");
  schema.number("scaffold.bead_width_mm", settings.bead_width_mm, {0.01, 20.0},
                "Width of the beads; at least the height of the layers.");
  schema.number("scaffold.bead_fill", settings.bead_fill, {0.0, 1.0},
                "Section of a bead over its width times height; 0 takes that of the kind.");
  schema.number("scaffold.feed_mm_s", settings.feed_mm_s, Bounds::above(0.0, 1000.0), "While depositing.");
  schema.number("scaffold.travel_feed_mm_s", settings.travel_feed_mm_s, Bounds::above(0.0, 1000.0),
                "Between deposits.");
  schema.number("scaffold.away_mm", settings.away_mm, {0.0, 1000.0},
                "How far the nozzle leaves the part between layers; 0 stays above it.");
}

void describeFill(SettingsSchema& schema, ScaffoldSettings& settings) {
  schema.choice("scaffold.fill", settings.fill,
                {{"rectilinear", ScaffoldFill::Rectilinear},
                 {"concentric", ScaffoldFill::Concentric},
                 {"gyroid", ScaffoldFill::Gyroid}},
                "How cylinders and boxes are filled.");
  schema.choice("scaffold.full_spacing", settings.full_spacing,
                {{"packed", FullSpacing::Packed}, {"width", FullSpacing::Width}},
                "Spacing of lines at density 1: what a stadium fills, or the width of a bead.");
  schema.number("scaffold.density", settings.density, Bounds::above(0.0, 1.0),
                "Filled part inside the perimeters.");
  schema.number("scaffold.angle_deg", settings.angle_deg, {-360.0, 360.0},
                "Of the lines of the first layer.");
  schema.integer("scaffold.perimeters", settings.perimeters, {0, 100}, "Around the fill.");
  schema.integer("scaffold.solid_layers", settings.solid_layers, {0, 1000},
                 "Filled at density 1 at the bottom, and as many at the top.");
}

void describeWaves(SettingsSchema& schema, ScaffoldSettings& settings) {
  schema.choice("scaffold.wave", settings.wave,
                {{"cosine", ScaffoldWave::Cosine},
                 {"sine", ScaffoldWave::Sine},
                 {"sine_cosine", ScaffoldWave::SineCosine}},
                "Line of the filaments of a sinusoidal scaffold.");
  schema.choice("scaffold.first_wave", settings.first_wave,
                {{"sine", FirstWave::Sine}, {"cosine", FirstWave::Cosine}},
                "Line of the first layer of a sine_cosine scaffold; every other layer has it.");
  schema.choice("scaffold.arrangement", settings.arrangement,
                {{"parallel", FilamentArrangement::Parallel}, {"mirrored", FilamentArrangement::Mirrored}},
                "Whether each filament is the same as the one before, or its mirror image.");
  schema.number("scaffold.amplitude_mm", settings.amplitude_mm, {0.0, 100.0}, "Of the wave.");
  schema.integer("scaffold.cycles", settings.cycles, {0, 1000}, "Of the wave along the length.");
  schema.integer("scaffold.filaments", settings.filaments, {2, 1000}, "Of each layer.");
  schema.integer("scaffold.cycle_segments", settings.cycle_segments, {4, 1000},
                 "Straight segments of each cycle.");
}

}  // namespace

void describe(SettingsSchema& schema, ScaffoldSettings& settings) {
  describeShape(schema, settings);
  describeBeads(schema, settings);
  describeFill(schema, settings);
  describeWaves(schema, settings);
}

}  // namespace lamina
