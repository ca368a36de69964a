// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/volumetric_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

void describe(SettingsSchema& schema, VolumetricSettings& settings) {
  schema.number("volumetric.cell_mm", settings.cell_mm, {0.0, 10.0},
                "Side of the cells in which growth is computed; 0 chooses it by the part's volume.");
  schema.number(
      "volumetric.max_overhang_deg", settings.max_overhang_deg, {0.0, 60.0},
      "Greatest overhang that the material takes, from the layer's own normal; 0 on upright walls.");
  schema.number("volumetric.overhang_used_deg", settings.overhang_used_deg, {-1.0, 60.0},
                "Overhang that volumetric layers use up before they bend; negative for 20 deg less than is "
                "taken, or as head and surface ask for.");
  schema.number(
      "volumetric.max_thickness", settings.max_thickness, {1.0, 4.0},
      "Greatest thickness of a volumetric layer, over slicing.layer_height_mm, which is the least.");
  schema.number("volumetric.max_tilt_deg", settings.max_tilt_deg, {0.0, 90.0},
                "Greatest tilt of volumetric layers from level.");
  schema.number(
      "volumetric.deviation_deg", settings.deviation_deg, {0.0, 60.0},
      "How far the tool axis may lean from a layer's normal towards upright, so that the head is clear.");
  schema.number("volumetric.sink_mm", settings.sink_mm, {0.0, 100.0},
                "How far the part is sunk into the bed, and cut there, so that it stands.");
  schema.choice<GrowthTarget>(
      "volumetric.target", settings.target,
      {{"arrival", GrowthTarget::Arrival},
       {"smooth", GrowthTarget::Smooth},
       {"surface", GrowthTarget::Surface},
       {"tangent", GrowthTarget::Tangent},
       {"given", GrowthTarget::Given}},
      "What volumetric layers are fitted to: nothing, smooth layers, upper skins, the "
      "way along the part, or given directions.");
  schema.choice<GrowthFoot>("volumetric.foot", settings.foot,
                            {{"flat", GrowthFoot::Flat}, {"free", GrowthFoot::Free}},
                            "How fitted layers meet the bed: the first one flat, or at any angle.");
  schema.text(
      "volumetric.target_file", settings.target_file,
      "Table of directions (CSV: x,y,z,nx,ny,nz) that layers lie across with volumetric.target given.");
  schema.number(
      "volumetric.skin_slope_deg", settings.skin_slope_deg, {0.0, 60.0},
      "Angle of a skin from the layers below it, up to which layers fitted to the surface follow it.");
  schema.integer("volumetric.rounds", settings.rounds, {1, 50}, "Rounds of the fit of volumetric layers.");
  schema.number("volumetric.largest_pendant_percent", settings.largest_pendant_percent, {0.0, 100.0},
                "Of the part's volume: how much may hang where no layer leads before it is refused.");
  schema.number("volumetric.largest_unsupported_percent", settings.largest_unsupported_percent, {0.0, 100.0},
                "Of the part's surface: how much may overhang by more than is taken before it is refused.");
  schema.number(
      "volumetric.largest_uneven_percent", settings.largest_uneven_percent, {0.0, 100.0},
      "Of the part's volume: how much may be in layers beyond their thickness before it is refused.");
  schema.number(
      "volumetric.largest_uncovered_percent", settings.largest_uncovered_percent, {0.0, 100.0},
      "Of the part's volume: how much layers may leave open that level ones do not, pendants aside, or lay "
      "twice, before it is refused.");
  schema.number(
      "volumetric.largest_left_out_percent", settings.largest_left_out_percent, {0.0, 10.0},
      "Of what a head that tilts deposits, in any slicing mode: how much may be left out where it has no "
      "room.");
}

void requireConsistent(const VolumetricSettings& settings) {
  if (settings.overhang_used_deg > settings.max_overhang_deg)
    throw InvalidConfig("volumetric.overhang_used_deg is " + numberText(settings.overhang_used_deg) +
                        "; must be at most volumetric.max_overhang_deg, " +
                        numberText(settings.max_overhang_deg));
  if (settings.foot == GrowthFoot::Free && settings.target == GrowthTarget::Arrival)
    throw InvalidConfig(
        "volumetric.foot is 'free' with volumetric.target 'arrival', which fits nothing; expected flat, or "
        "another target");
  if (settings.target == GrowthTarget::Given && settings.target_file.empty())
    throw InvalidConfig(
        "volumetric.target is 'given' without volumetric.target_file; expected a table of directions");
  if (settings.target != GrowthTarget::Given && !settings.target_file.empty())
    throw InvalidConfig("volumetric.target_file is '" + settings.target_file +
                        "', which only volumetric.target 'given' reads; expected none");
}

}  // namespace lamina
