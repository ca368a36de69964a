// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/capabilities.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/job/job_settings.hpp"
#include "planning/tools/tool_order.hpp"

namespace lamina {
namespace {

/// A setting and the capability that it is bounded by.
struct Asked {
  std::string key;
  double value;
  const char* unit;
};

void requireAtMost(const Asked& asked, const char* capability, double greatest, const std::string& because) {
  if (greatest > 0.0 && asked.value > greatest)
    throw InvalidConfig(asked.key + " is " + numberText(asked.value) + " " + asked.unit +
                        "; must be at most " + capability + ", " + numberText(greatest) + " " + asked.unit +
                        because);
}

void requireTemperatures(const JobSettings& settings) {
  const MachineCapabilities& machine = settings.capabilities;
  const std::string material = settings.material.name.empty() ? "the material" : settings.material.name;
  requireAtMost({"program.nozzle_temperature_c", settings.program.nozzle_temperature_c, "degrees C"},
                "machine.greatest_nozzle_c", machine.greatest_nozzle_c,
                ": the nozzle of the machine cannot melt " + material);
  const double bed_c = settings.program.bed_temperature_c;
  if (!machine.has_bed_heater && bed_c > 0.0)
    throw InvalidConfig("program.bed_temperature_c is " + numberText(bed_c) +
                        " degrees C with machine.has_bed_heater false; expected 0");
  requireAtMost({"program.bed_temperature_c", bed_c, "degrees C"}, "machine.greatest_bed_c",
                machine.greatest_bed_c, "");
}

void requireLayerHeight(const std::string& key, double height_mm, const MachineCapabilities& machine) {
  const Asked height{key, height_mm, "mm"};
  requireAtMost(height, "machine.greatest_layer_mm", machine.greatest_layer_mm, "");
  if (height_mm < machine.least_layer_mm)
    throw InvalidConfig(key + " is " + numberText(height_mm) +
                        " mm; must be at least machine.least_layer_mm, " +
                        numberText(machine.least_layer_mm) + " mm");
}

void requireNozzle(const Asked& height, const MachineCapabilities& machine) {
  requireAtMost(height, "machine.nozzle_mm", machine.nozzle_mm,
                ": a layer is no higher than the nozzle is wide");
}

constexpr double kHighestBead = 0.8;  // of the nozzle's diameter

/// Of the tool that lays a role; 0 if it is not known.
double nozzleOf(PathRole role, const ToolSettings& settings) {
  const std::vector<Tool> tools = toolsOf(settings);
  const std::size_t tool = toolFor(role, settings);
  return tool < tools.size() ? tools[tool].nozzle_mm : 0.0;
}

/// The first layer, which the bed presses, is one that the finest nozzle at work can lay, and a raft's base
/// one of its own tool.
void requireLayersForTools(const JobSettings& settings) {
  const std::vector<Tool> tools = toolsOf(settings.planning.tools);
  const RaftSettings& raft = settings.planning.adhesion.raft;
  const double of_raft_mm = raft.layers > 0 ? nozzleOf(PathRole::Raft, settings.planning.tools) : 0.0;
  if (of_raft_mm > 0.0 && raft.base_height_mm > of_raft_mm * (1.0 + 1e-9))
    throw InvalidConfig(
        "raft.base_height_mm is " + numberText(raft.base_height_mm) + " mm and nozzle_mm of tool " +
        std::to_string(toolFor(PathRole::Raft, settings.planning.tools)) + " in tools.list " +
        numberText(of_raft_mm) + " mm; a layer is no higher than the nozzles that lay it are wide");
  const double height_mm = settings.slicing.first_layer_height_mm;
  for (const std::uint32_t tool : toolsAtWork(settings.planning)) {
    const double nozzle_mm = tool < tools.size() ? tools[tool].nozzle_mm : 0.0;
    if (nozzle_mm <= 0.0 || height_mm <= nozzle_mm * (1.0 + 1e-9)) continue;
    throw InvalidConfig("slicing.first_layer_height_mm is " + numberText(height_mm) +
                        " mm and nozzle_mm of tool " + std::to_string(tool) + " in tools.list " +
                        numberText(nozzle_mm) +
                        " mm; a layer is no higher than the nozzles that lay it are wide");
  }
}

/// A bead that is higher is hardly pressed onto what lies below it.
void requirePressed(const Asked& height, const JobSettings& settings) {
  const auto require = [&](double nozzle_mm, const std::string& of) {
    if (nozzle_mm <= 0.0 || height.value <= kHighestBead * nozzle_mm * (1.0 + 1e-9)) return;
    throw InvalidConfig(height.key + " is " + numberText(height.value) + " mm; must be at most " +
                        numberText(kHighestBead * nozzle_mm) + " mm, 0.8 of " + of);
  };
  require(settings.capabilities.nozzle_mm, "machine.nozzle_mm");
  const std::vector<Tool> tools = toolsOf(settings.planning.tools);
  for (const std::uint32_t tool : toolsAtWork(settings.planning))
    if (tool < tools.size())
      require(tools[tool].nozzle_mm, "nozzle_mm of tool " + std::to_string(tool) + " in tools.list");
}

void requireAdaptiveHeights(const JobSettings& settings) {
  if (settings.slicing.heights != LayerHeights::Adaptive) return;
  const AdaptiveSettings& adaptive = settings.slicing.adaptive;
  requireLayerHeight("adaptive.least_mm", adaptive.least_mm, settings.capabilities);
  requireLayerHeight("adaptive.greatest_mm", adaptive.greatest_mm, settings.capabilities);
  requirePressed({"adaptive.greatest_mm", adaptive.greatest_mm, "mm"}, settings);
}

/// Infill of several layers at once is no higher than beads of the nozzle may be.
void requireInfillHeight(const JobSettings& settings) {
  const int layers = settings.planning.infill.every_layers;
  if (layers == 1) return;
  const std::string asked = "infill.every_layers is " + std::to_string(layers);
  if (settings.slicing.heights != LayerHeights::Equal)
    throw InvalidConfig(asked +
                        " with slicing.heights not 'equal'; expected 1: layers share an infill if they "
                        "are equally high");
  const double of_tool_mm = nozzleOf(PathRole::Infill, settings.planning.tools);
  const double of_machine_mm = settings.capabilities.nozzle_mm;
  const double of_bead_mm = of_machine_mm > 0.0 ? of_machine_mm : settings.planning.bead.width_mm;
  const double greatest_mm = kHighestBead * (of_tool_mm > 0.0 ? of_tool_mm : of_bead_mm);
  const char* const of = of_tool_mm > 0.0      ? "nozzle_mm of the tool of infill"
                         : of_machine_mm > 0.0 ? "machine.nozzle_mm"
                                               : "bead.width_mm";
  const double height_mm = layers * settings.slicing.layer_height_mm;
  if (height_mm <= greatest_mm * (1.0 + 1e-9)) return;
  throw InvalidConfig(asked + " of " + numberText(settings.slicing.layer_height_mm) +
                      " mm, which makes beads " + numberText(height_mm) + " mm high; must be at most " +
                      numberText(greatest_mm) + " mm, 0.8 of " + of);
}

}  // namespace

void describe(SettingsSchema& schema, MachineCapabilities& capabilities) {
  const Bounds length{0.0, 100.0};
  const Bounds heat{0.0, 500.0};
  schema.number("machine.nozzle_mm", capabilities.nozzle_mm, length,
                "Diameter of the nozzle, which bounds the height of layers; 0 if not known.");
  schema.number("machine.greatest_nozzle_c", capabilities.greatest_nozzle_c, heat,
                "Greatest temperature of the nozzle; 0 if not known.");
  schema.number("machine.greatest_bed_c", capabilities.greatest_bed_c, heat,
                "Greatest temperature of the bed; 0 if not known.");
  schema.number("machine.least_layer_mm", capabilities.least_layer_mm, length,
                "Least height of layers; 0 for any.");
  schema.number("machine.greatest_layer_mm", capabilities.greatest_layer_mm, length,
                "Greatest height of layers; 0 for any.");
  schema.flag("machine.has_bed_heater", capabilities.has_bed_heater, "Whether the bed can be heated.");
  schema.flag("machine.has_fan", capabilities.has_fan, "Whether there is a fan that cools the part.");
}

void describe(SettingsSchema& schema, MaterialSettings& material) {
  schema.text("material.name", material.name, "Name of the material, in messages.");
  schema.number("material.density_g_cm3", material.density_g_cm3, {0.0, 30.0},
                "Density of the material, by which programs state its mass; 0 if not known.");
}

void requireCapable(const JobSettings& settings) {
  const MachineCapabilities& machine = settings.capabilities;
  requireTemperatures(settings);
  if (settings.fan.is_used && !machine.has_fan)
    throw InvalidConfig("fan.use is true with machine.has_fan false; expected false");
  requireLayerHeight("slicing.layer_height_mm", settings.slicing.layer_height_mm, machine);
  requireLayerHeight("slicing.first_layer_height_mm", settings.slicing.first_layer_height_mm, machine);
  requirePressed({"slicing.layer_height_mm", settings.slicing.layer_height_mm, "mm"}, settings);
  requireNozzle({"slicing.first_layer_height_mm", settings.slicing.first_layer_height_mm, "mm"}, machine);
  requireLayersForTools(settings);
  requireAdaptiveHeights(settings);
  requireInfillHeight(settings);
}

void requireCapableOfTable(const std::vector<double>& heights_mm, const JobSettings& settings) {
  constexpr double kPerMillimetre = 1e6;  // what sums of heights leave is no height
  for (std::size_t i = 0; i < heights_mm.size(); ++i) {
    const Asked height{"layer " + std::to_string(i) + " of slicing.heights_file",
                       std::round(heights_mm[i] * kPerMillimetre) / kPerMillimetre, "mm"};
    requireLayerHeight(height.key, height.value, settings.capabilities);
    if (i == 0)
      requireNozzle(height, settings.capabilities);
    else
      requirePressed(height, settings);
  }
}

}  // namespace lamina
