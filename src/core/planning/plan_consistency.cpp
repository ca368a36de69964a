// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/plan_consistency.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/tools/tool_order.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-6;    // of a distance
constexpr double kLeastPitch = 0.5;   // plan widths
constexpr double kMostPitch = 2.0;    // plan widths
constexpr double kNarrowest = 0.5;    // bead, in heights of its layer
constexpr double kMostSpread = 50.0;  // the same

[[noreturn]] void refuse(const std::string& what, const PlanSettings& settings, const std::string& expected) {
  throw InvalidConfig(what + " with infill.strategy '" + settings.infill.strategy +
                      "', which lays drops; expected " + expected);
}

void requireNoInfillPitch(const PlanSettings& settings, const std::string& why) {
  const auto require = [&](const std::string& key, double value) {
    if (value == 0.0) return;
    throw InvalidConfig(key + " is " + numberText(value) + " with infill.strategy '" +
                        settings.infill.strategy + "', " + why + "; expected the default 0");
  };
  require("infill.pitch_mm", settings.infill.pitch_mm);
  require("infill.outer_layers", settings.infill.outer_layers);
}

void requireNoCount(const std::string& key, int count, int usual, const PlanSettings& settings) {
  if (count == 0 || count == usual) return;
  refuse(key + " is " + std::to_string(count), settings,
         "0 or the default " + std::to_string(usual) +
             ": there are no walls and no skirt of beads beside drops, only drops.contours");
}

void requireDistance(const std::string& key, double distance_mm, const DropSettings& drops) {
  const double least_mm = (1.0 - drops.most_overlap) * drops.diameter_mm;
  if (distance_mm >= least_mm * (1.0 - kRounding)) return;
  throw InvalidConfig(key + " is " + numberText(distance_mm) + " mm; must be at least " +
                      numberText(least_mm) +
                      " mm, (1 - drops.most_overlap) times drops.diameter_mm: nearer drops are left out");
}

void requireConsistentDrops(const PlanSettings& settings) {
  const PlanSettings usual;
  const double density = settings.infill.density;
  if (density != 1.0 && density != usual.infill.density)
    refuse("infill.density is " + numberText(density), settings,
           "1 or the default " + numberText(usual.infill.density) +
               ": drops cover the whole section, as densely as drops.pitch_mm reports");
  requireNoInfillPitch(settings, "which lays drops");
  requireNoCount("walls.count", settings.walls.count, usual.walls.count, settings);
  requireNoCount("skirt.count", settings.skirt.count, usual.skirt.count, settings);
  if (settings.voids.refill != VoidRefill::None)
    refuse("voids.refill is 'beads'", settings, "'none': voids between drops are filled by drop_voids.fill");
  if (settings.supports.use)
    refuse("supports.use is true", settings, "false: columns of beads hold up beads only");
  const FirstLayerSettings& first = settings.first_layer;
  if (first.width_factor != 1.0)
    refuse("first_layer.width_factor is " + numberText(first.width_factor), settings, "the default 1");
  if (first.flow != 1.0) refuse("first_layer.flow is " + numberText(first.flow), settings, "the default 1");
  if (settings.bead.flow != 1.0)
    refuse("bead.flow is " + numberText(settings.bead.flow), settings,
           "the default 1: drops are as large as drops.diameter_mm");
  if (settings.travel.comb != Combing::None)
    refuse("travel.comb is not 'none'", settings, "'none': nothing is retracted between drops");
  if (isUsed(settings.adhesion))
    refuse("a brim, raft or prime line is set", settings,
           "brim.width_mm 0, raft.layers 0 and prime.line 'none': they are of beads");
  if (settings.ironing.is_used) refuse("ironing.use is true", settings, "false: there are no skins of beads");
  const DropSettings& drops = settings.fill.drops;
  requireDistance("drops.pitch_mm", drops.pitch_mm, drops);
  requireDistance("drops.line_spacing_mm", lineSpacing(drops), drops);
}

void requireConsistentVase(const PlanSettings& settings) {
  const PlanSettings usual;
  const auto require = [](const std::string& key, double value, double default_value) {
    if (value == default_value) return;
    throw InvalidConfig(key + " is " + numberText(value) +
                        " with infill.strategy 'vase', which is its own wall; expected the default " +
                        numberText(default_value));
  };
  if (settings.walls.count != 0) require("walls.count", settings.walls.count, usual.walls.count);
  require("infill.density", settings.infill.density, usual.infill.density);
  requireNoInfillPitch(settings, "which is its own wall");
  if (settings.voids.refill != VoidRefill::None)
    throw InvalidConfig(
        "voids.refill is 'beads' with infill.strategy 'vase', which is hollow; expected 'none'");
  if (settings.ironing.is_used)
    throw InvalidConfig(
        "ironing.use is true with infill.strategy 'vase', which has no top skin; expected false");
}

void requireConsistentSkins(const SkinSettings& skins) {
  const InfillStrategy strategy = infillStrategy(skins.strategy);
  if (strategy.deposit == Deposit::Bead && strategy.link == LayerLink::Travel) return;
  throw InvalidConfig("skins.strategy is '" + skins.strategy +
                      "'; must be one that fills each layer with beads, such as zigzag");
}

void requireIronable(const PlanSettings& settings) {
  if (!settings.ironing.is_used || hasTopSkins(settings.skins)) return;
  throw InvalidConfig(
      "ironing.use is true with skins.top_layers " + std::to_string(settings.skins.top_layers) +
      " and skins.top_mm " + numberText(settings.skins.top_mm) +
      " mm, so that nothing is skin for being seen from above; expected top_layers of 1 or more, or "
      "top_mm above 0");
}

/// What is deposited on the bed is then the raft.
void requirePlainFirstLayer(const FirstLayerSettings& first_layer, int raft_layers) {
  const auto require = [raft_layers](const char* key, double value, double usual) {
    if (value == usual) return;
    throw InvalidConfig(std::string(key) + " is " + numberText(value) + " with raft.layers " +
                        std::to_string(raft_layers) + "; expected " + numberText(usual) +
                        ": the first layer of the part does not lie on the bed");
  };
  if (raft_layers == 0) return;
  require("first_layer.flow", first_layer.flow, 1.0);
  require("first_layer.width_factor", first_layer.width_factor, 1.0);
  require("first_layer.inset_mm", first_layer.inset_mm, 0.0);
}

void requireConsistentAdhesion(const AdhesionSettings& adhesion) {
  if (adhesion.brim.width_mm == 0.0 || adhesion.raft.layers == 0) return;
  throw InvalidConfig("brim.width_mm is " + numberText(adhesion.brim.width_mm) + " with raft.layers " +
                      std::to_string(adhesion.raft.layers) +
                      "; expected 0 of one of them: a raft has no brim");
}

void requireConsistentHybrid(const PlanSettings& settings) {
  const HybridSettings& hybrid = settings.fill.hybrid;
  if (hybrid.lines != HybridLines::Metal) return;
  if (settings.fill.raster.direction != RasterDirection::Given)
    throw InvalidConfig(
        "raster.direction is not 'given' with hybrid.lines 'metal', whose lines follow the grid; "
        "expected "
        "'given', or hybrid.lines 'fitted'");
  if (hybrid.add_above < hybrid.delete_below)
    throw InvalidConfig("hybrid.add_above is " + numberText(hybrid.add_above) +
                        " spacings; must be at least hybrid.delete_below, which is " +
                        numberText(hybrid.delete_below));
}

/// Drops have the size of drops, and runs that go on from layer to layer one width.
void requireOwnWidth(const PlanSettings& settings, const InfillStrategy& strategy) {
  if (settings.infill.bead_width_mm == 0.0) return;
  if (strategy.deposit == Deposit::Bead && strategy.link == LayerLink::Travel) return;
  throw InvalidConfig("infill.bead_width_mm is " + numberText(settings.infill.bead_width_mm) +
                      " with infill.strategy '" + settings.infill.strategy +
                      "', which lays drops or goes on from layer to layer; expected the default 0");
}

/// Layers share an infill where each lays its own beads in its plane.
void requireOwnInfill(const PlanSettings& settings, const InfillStrategy& strategy) {
  if (settings.infill.every_layers == 1) return;
  if (strategy.deposit == Deposit::Bead && strategy.link == LayerLink::Travel) return;
  throw InvalidConfig("infill.every_layers is " + std::to_string(settings.infill.every_layers) +
                      " with infill.strategy '" + settings.infill.strategy +
                      "', which lays drops or goes on from layer to layer; expected 1");
}

void requireRoofs(const PlanSettings& settings) {
  if (hasSkins(settings.skins) || isSolid(settings.infill)) return;
  throw InvalidConfig("infill.strategy is '" + settings.infill.strategy +
                      "', which holds up skins, and there are none; expected skins.top_layers of 1 or more");
}

/// What purges a tool is hidden by skins; a solid infill has none.
void requireHiddenInfill(const PlanSettings& settings) {
  constexpr double kSolid = 1.25;  // bead widths: lines that are no farther apart touch
  if (!settings.tools.purge_into_infill) return;
  const auto refuse_seen = [](const std::string& what, const std::string& expected) {
    throw InvalidConfig(what + " with tools.purge_into_infill, and what purges would be seen; expected " +
                        expected);
  };
  const InfillSettings& infill = settings.infill;
  if (isSolid(infill))
    refuse_seen("infill.density is " + numberText(infill.density),
                "less than 1: a solid infill has no skins");
  if (infill.pitch_mm > 0.0 && infill.pitch_mm <= kSolid * settings.bead.width_mm)
    refuse_seen("infill.pitch_mm is " + numberText(infill.pitch_mm) + " mm",
                "0 or more than " + numberText(kSolid * settings.bead.width_mm) + " mm");
  if (infill.outer_layers > 0)
    refuse_seen("infill.outer_layers is " + std::to_string(infill.outer_layers), "0");
  if (!hasTopSkins(settings.skins)) refuse_seen("skins.top_layers is 0", "1 or more");
  if (settings.skins.bottom_layers == 0 && settings.skins.bottom_mm == 0.0)
    refuse_seen("skins.bottom_layers is 0", "1 or more");
}

/// The first key that asks for another tool than the first, with its value.
std::string otherTool(const PlanSettings& settings) {
  const ToolSettings& tools = settings.tools;
  const SupportSettings& supports = settings.supports;
  const std::pair<const char*, int> all[] = {{"tool.walls", tools.walls},
                                             {"tool.infill", tools.infill},
                                             {"tool.skin", tools.skin},
                                             {"tool.support", tools.support},
                                             {"tool.interface", tools.interface},
                                             {"supports.tool", supports.tool},
                                             {"supports.interface_tool", supports.interface_tool}};
  for (const auto& [key, tool] : all)
    if (tool > 0) return std::string(key) + " is " + std::to_string(tool);
  return "";
}

/// Runs that go on from layer to layer are those of one tool.
void requireConsistentTools(const PlanSettings& settings, const InfillStrategy& strategy) {
  const ToolSettings& tools = settings.tools;
  requireConsistent(tools);
  requireHiddenInfill(settings);
  const std::size_t count = toolsOf(tools).size();
  if (count > 0 && settings.first_layer.nozzle_temperature_c != 0.0)
    throw InvalidConfig("first_layer.nozzle_temperature_c is " +
                        numberText(settings.first_layer.nozzle_temperature_c) +
                        " degrees C with tools.list; expected 0: each tool has its own temperature");
  const std::pair<const char*, int> of_supports[] = {
      {"supports.tool", settings.supports.tool},
      {"supports.interface_tool", settings.supports.interface_tool}};
  for (const auto& [key, tool] : of_supports)
    if (tool >= static_cast<int>(std::max<std::size_t>(count, 1)))
      throw InvalidConfig(std::string(key) + " is " + std::to_string(tool) + "; tools.list has " +
                          std::to_string(count) + " tools, counted from 0");
  if (!usesTools(settings)) return;
  if (strategy.deposit == Deposit::Drops || strategy.link != LayerLink::Travel)
    throw InvalidConfig(otherTool(settings) + " with infill.strategy '" + settings.infill.strategy +
                        "', which lays drops or runs that go on from layer to layer; expected 0: one tool");
}

}  // namespace

void requireConsistent(const PlanSettings& settings) {
  const InfillStrategy strategy = infillStrategy(settings.infill.strategy);
  if (strategy.deposit == Deposit::Drops) requireConsistentDrops(settings);
  if (strategy.link == LayerLink::Rising) requireConsistentVase(settings);
  if (settings.infill.strategy == "hybrid") requireConsistentHybrid(settings);
  if (strategy.growth == FillGrowth::FromAbove) requireRoofs(settings);
  requireConsistentAdhesion(settings.adhesion);
  requirePlainFirstLayer(settings.first_layer, settings.adhesion.raft.layers);
  if (hasSkins(settings.skins)) requireConsistentSkins(settings.skins);
  requireIronable(settings);
  requireConsistent(settings.overhangs);
  requireConsistentTools(settings, strategy);
  requireOwnWidth(settings, strategy);
  requireOwnInfill(settings, strategy);
}

void requireSensibleWidths(const PlanSettings& settings, double layer_height_mm) {
  const double least_mm = kNarrowest * layer_height_mm;
  if (settings.bead.width_mm < least_mm * (1.0 - kRounding))
    throw InvalidConfig("bead.width_mm is " + numberText(settings.bead.width_mm) + " mm in a layer of " +
                        numberText(layer_height_mm) + " mm; expected at least " + numberText(least_mm) +
                        " mm: a bead more than twice as high as wide does not stand");
  const double most_mm = kMostSpread * layer_height_mm;
  if (settings.bead.width_mm > most_mm * (1.0 + kRounding))
    throw InvalidConfig("bead.width_mm is " + numberText(settings.bead.width_mm) + " mm in a layer of " +
                        numberText(layer_height_mm) + " mm; expected at most " + numberText(most_mm) +
                        " mm: no bead spreads to more than fifty times its height");
  const std::pair<const char*, double> stated[] = {
      {"infill.bead_width_mm", settings.infill.bead_width_mm},
      {"skins.bead_width_mm", settings.skins.bead_width_mm},
      {"supports.bead_width_mm", settings.supports.bead_width_mm}};
  for (const auto& [key, width_mm] : stated)
    if (width_mm != 0.0 && width_mm < layer_height_mm * (1.0 - kRounding))
      throw InvalidConfig(std::string(key) + " is " + numberText(width_mm) + " mm; must be 0 or at least " +
                          numberText(layer_height_mm) +
                          " mm, the height of the layer: beads are wider than high");
}

void requireSensiblePitch(const BeadSettings& bead, double layer_height_mm) {
  if (bead.pitch_mm == 0.0) return;
  const double width_mm = planWidth({bead.width_mm, layer_height_mm});
  const double least_mm = kLeastPitch * width_mm;
  const double most_mm = kMostPitch * width_mm;
  if (bead.pitch_mm >= least_mm && bead.pitch_mm <= most_mm) return;
  throw InvalidConfig("bead.pitch_mm is " + numberText(bead.pitch_mm) + " mm; must be 0 or in [" +
                      numberText(least_mm) + ", " + numberText(most_mm) +
                      "] mm, half to twice the width that a bead of " + numberText(bead.width_mm) +
                      " mm fills in a layer of " + numberText(layer_height_mm) + " mm");
}

}  // namespace lamina
