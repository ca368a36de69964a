// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Parametric scaffolds.
#include "job/settings/setting_probe.hpp"
#include "lamina/scaffold/scaffold.hpp"

namespace lamina::test {
namespace {

std::function<std::string(const SettingTexts& set)> scaffold(const std::string& name) {
  return [name](const SettingTexts& set) {
    ScaffoldSettings settings = scaffoldDefaults(name);
    SettingsSchema schema;
    describe(schema, settings);
    for (const SettingText& setting : set) schema.set(setting.key, setting.text);
    return toolpathId(makeScaffold(name, settings));
  };
}

SettingProbe boxProbe() {
  return {"a scaffold in a box",
          "scaffold.height_mm=2",
          scaffold("box"),
          {{"scaffold.corner_x_mm=5"},
           {"scaffold.corner_y_mm=5"},
           {"scaffold.length_mm=8"},
           {"scaffold.breadth_mm=8"},
           {"scaffold.height_mm=3"},
           {"scaffold.layer_height_mm=0.4"},
           {"scaffold.first_layer_height_mm=0.4"},
           {"scaffold.bead_width_mm=0.6"},
           {"scaffold.bead_fill=0.5"},
           {"scaffold.feed_mm_s=10"},
           {"scaffold.travel_feed_mm_s=50"},
           {"scaffold.away_mm=5"},
           {"scaffold.fill=concentric"},
           {"scaffold.full_spacing=width", "scaffold.density=1"},
           {"scaffold.density=0.3"},
           {"scaffold.angle_deg=30"},
           {"scaffold.perimeters=1"},
           {"scaffold.solid_layers=1"}}};
}

SettingProbe wavesProbe() {
  return {"a sinusoidal scaffold",
          "",
          scaffold("sinusoidal"),
          {{"scaffold.wave=cosine"},
           {"scaffold.first_wave=cosine", "scaffold.wave=sine_cosine"},
           {"scaffold.arrangement=mirrored"},
           {"scaffold.amplitude_mm=0.3"},
           {"scaffold.cycles=4"},
           {"scaffold.filaments=6"},
           {"scaffold.cycle_segments=12"}}};
}

}  // namespace

std::vector<SettingProbe> scaffoldProbes() {
  return {boxProbe(),
          wavesProbe(),
          {"a scaffold in a cylinder", "", scaffold("cylinder"), {{"scaffold.diameter_mm=8"}}}};
}

}  // namespace lamina::test
