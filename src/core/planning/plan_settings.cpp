// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/plan_settings.hpp"

#include "lamina/infill/strategy.hpp"

namespace lamina {
namespace {

constexpr Bounds kFeed = Bounds::above(0.0, 10000.0);
constexpr Bounds kAngle{-360.0, 360.0};
constexpr Bounds kRoleWidth{0.0, 100.0};

void describe(SettingsSchema& schema, BeadSettings& bead) {
  schema.number("bead.width_mm", bead.width_mm, {0.01, 100.0}, "Width of a bead.");
  schema.number("bead.flow", bead.flow, {0.1, 5.0},
                "Factor on what is deposited of the part; beads stay where they are.");
  schema.number(
      "bead.pitch_mm", bead.pitch_mm, {0.0, 100.0},
      "Distance of neighbouring beads in a solid fill; 0 takes that at which they fill it exactly.");
}

void describe(SettingsSchema& schema, WallSettings& walls) {
  schema.integer("walls.count", walls.count, {0, 1000}, "Number of walls along each outline.");
  schema.choice<WallOrder>("walls.order", walls.order,
                           {{"outside_in", WallOrder::OutsideIn}, {"inside_out", WallOrder::InsideOut}},
                           "Which walls come first.");
  schema.number("walls.narrowest", walls.narrowest, {0.05, 1.0},
                "Narrowest bead where no wall fits, in pitches; what is thinner is not printed.");
}

void describe(SettingsSchema& schema, InfillSettings& infill) {
  schema.choice("infill.strategy", infill.strategy, infillStrategyNames(), "How the inside is filled.");
  schema.number("infill.density", infill.density, {0.0, 1.0},
                "Part of the inside that is filled; 1 is solid.");
  schema.number("infill.bead_width_mm", infill.bead_width_mm, kRoleWidth,
                "Width of beads of infill; 0 takes bead.width_mm, in proportion to the nozzles.");
  schema.number("infill.pitch_mm", infill.pitch_mm, {0.0, 1000.0},
                "Distance of neighbouring lines of infill; 0 takes what infill.density asks for.");
  schema.integer("infill.outer_layers", infill.outer_layers, {0, 100000},
                 "So many first and last layers are filled as infill.outer_pitch_mm says.");
  schema.number("infill.outer_pitch_mm", infill.outer_pitch_mm, {0.0, 1000.0},
                "Distance of neighbouring lines in these; 0 is solid.");
  schema.number("infill.angle_deg", infill.angle_deg, kAngle,
                "Direction of the first layer's infill, from x.");
  schema.number("infill.alternation_deg", infill.alternation_deg, kAngle,
                "Turn of the infill from each layer to the next.");
  schema.number("infill.wall_overlap", infill.wall_overlap, {0.0, 0.9},
                "Part of the bead width by which infill runs into the innermost wall.");
  schema.integer("infill.every_layers", infill.every_layers, {1, 100},
                 "Sparse infill is deposited in one of so many layers, in beads as high as all of them.");
  schema.choice<LineLink>(
      "infill.link", infill.links.link,
      {{"border", LineLink::Border}, {"none", LineLink::None}, {"up_to_mm", LineLink::UpTo}},
      "Whether lines of sparse infill are joined along the border: within three distances of lines, not at "
      "all, or within infill.link_mm.");
  schema.number("infill.link_mm", infill.links.longest_mm, {0.0, 10000.0},
                "Longest of these joints with infill.link up_to_mm.");
}

void describe(SettingsSchema& schema, SkinSettings& skins) {
  schema.integer("skins.top_layers", skins.top_layers, {0, 1000},
                 "Least number of solid layers below what is seen from above; 0 for none.");
  schema.integer("skins.bottom_layers", skins.bottom_layers, {0, 1000},
                 "Least number of solid layers over what is seen from below; 0 for none.");
  schema.number("skins.top_mm", skins.top_mm, {0.0, 100.0}, "Least thickness of these top layers.");
  schema.number("skins.bottom_mm", skins.bottom_mm, {0.0, 100.0}, "Least thickness of these bottom layers.");
  schema.number("skins.bead_width_mm", skins.bead_width_mm, kRoleWidth,
                "Width of beads of skins; 0 takes bead.width_mm, in proportion to the nozzles.");
  schema.choice("skins.strategy", skins.strategy, infillStrategyNames(), "How skins are filled.");
  schema.number("skins.angle_deg", skins.angle_deg, {-180.0, 180.0},
                "Direction of the first layer's skins, from x; each layer is turned by 90 deg.");
  schema.number("skins.narrowest", skins.narrowest, {0.0, 10.0},
                "Narrower places are no skin, in bead widths.");
  schema.number("skins.anchor_mm", skins.anchor_mm, {-1.0, 50.0},
                "By how much skins grow into the infill; -1 takes the thickness of the walls.");
  schema.number("skins.least_infill_mm2", skins.least_infill_mm2, {0.0, 1e6},
                "Smaller areas of sparse infill become skin.");
  schema.flag("skins.monotonic", skins.is_monotonic,
              "Whether zigzags seen from above are deposited in one sense across, none between two deposited "
              "before.");
}

void describe(SettingsSchema& schema, IroningSettings& ironing) {
  schema.flag("ironing.use", ironing.is_used, "Whether skins seen from above are passed over once more.");
  schema.number("ironing.flow", ironing.flow, Bounds::above(0.0, 1.0),
                "What is deposited then, as a share of the layer's height.");
  schema.number("ironing.spacing_mm", ironing.spacing_mm, {0.01, 100.0},
                "Distance of neighbouring lines of ironing.");
  schema.number("ironing.inset_mm", ironing.inset_mm, {0.0, 100.0},
                "Distance of these lines from the border of the skin.");
}

void describe(SettingsSchema& schema, VoidSettings& voids) {
  schema.choice<VoidRefill>("voids.refill", voids.refill,
                            {{"none", VoidRefill::None}, {"beads", VoidRefill::Beads}},
                            "What fills voids that walls and infill leave.");
  schema.number("voids.least_area", voids.least_area, {0.0, 1e6}, "Smaller voids stay, in squared pitches.");
}

void describe(SettingsSchema& schema, SkirtSettings& skirt) {
  schema.integer("skirt.count", skirt.count, {0, 1000},
                 "Number of loops round the first layer; inclined layers have none.");
  schema.number("skirt.distance_mm", skirt.distance_mm, {0.0, 1000.0},
                "Free space between the skirt and what it goes round.");
  schema.integer("skirt.layers", skirt.layers, {1, 100000}, "Number of layers that have a skirt.");
  schema.number("skirt.least_length_mm", skirt.least_length_mm, {0.0, 1e5},
                "Loops are added until a skirt is as long.");
}

void describe(SettingsSchema& schema, AdaptedWallSettings& adapted) {
  schema.number("walls.contour_offset", adapted.contour_offset, {0.0, 1.0},
                "Distance of an adapted wall's bead, its middle, from the part's surface, in bead widths.");
}

void describe(SettingsSchema& schema, SeamSettings& seam) {
  schema.choice<SeamPlacement>("seam.placement", seam.placement,
                               {{"nearest", SeamPlacement::Nearest},
                                {"aligned", SeamPlacement::Aligned},
                                {"rear", SeamPlacement::Rear},
                                {"random", SeamPlacement::Random},
                                {"corner", SeamPlacement::Corner}},
                               "Where closed loops start.");
  schema.integer("seam.seed", seam.seed, {0, 2147483647}, "Seed of random seams.");
}

void describe(SettingsSchema& schema, TravelSettings& travel) {
  schema.number("travel.feed_mm_s", travel.feed_mm_s, kFeed, "Speed of motions that deposit nothing.");
  schema.number("travel.hop_mm", travel.hop_mm, {0.0, 1000.0}, "Lift during a retracted travel.");
  schema.number("travel.retraction_threshold_mm", travel.retraction_threshold_mm, {0.0, 10000.0},
                "Travels up to this length neither retract nor hop.");
  schema.choice<Hopping>(
      "travel.hop", travel.hop,
      {{"never", Hopping::Never}, {"over_skin", Hopping::OverSkin}, {"always", Hopping::Always}},
      "Which retracted travels are lifted.");
  schema.choice<Combing>("travel.comb", travel.comb,
                         {{"none", Combing::None}, {"inside", Combing::Inside}, {"no_skin", Combing::NoSkin}},
                         "Whether travels within an island keep to its inside, over top skins or not.");
  schema.number("travel.keep_off_mm", travel.keep_off_mm, {0.0, 100.0},
                "How far a bead on such a way would lie off the outline.");
  schema.number("travel.comb_longest_mm", travel.comb_longest_mm, {0.0, 10000.0},
                "Longest way inside, combed or over infill, that is not retracted.");
  schema.number("travel.comb_detour", travel.comb_detour, {1.0, 1000.0},
                "Longest way inside, in straight ways; beyond, a travel is straight and retracted.");
  schema.number("travel.wipe_mm", travel.wipe_mm, {0.0, 100.0},
                "Way along the run just deposited before a retracted travel; 0 for none.");
  schema.number("travel.wipe_share", travel.wipe_share, {0.0, 1.0},
                "Share of the retraction that happens on that way.");
}

void describe(SettingsSchema& schema, FeedSettings& feed) {
  schema.number("feed.outer_wall_mm_s", feed.outer_wall_mm_s, kFeed, "Speed of outer walls.");
  schema.number("feed.inner_wall_mm_s", feed.inner_wall_mm_s, kFeed, "Speed of inner walls.");
  schema.number("feed.infill_mm_s", feed.infill_mm_s, kFeed, "Speed of infill.");
  schema.number("feed.skin_mm_s", feed.skin_mm_s, kFeed, "Speed of hidden and bottom skins.");
  schema.number("feed.top_skin_mm_s", feed.top_skin_mm_s, kFeed, "Speed of skins seen from above.");
  schema.number("feed.bridge_mm_s", feed.bridge_mm_s, kFeed, "Speed of bridges and of walls beside them.");
  schema.number("feed.ironing_mm_s", feed.ironing_mm_s, kFeed, "Speed of ironing.");
  schema.number("feed.skirt_mm_s", feed.skirt_mm_s, kFeed, "Speed of skirt, brim, raft and priming.");
  schema.number("feed.support_mm_s", feed.support_mm_s, kFeed, "Speed of supports.");
  schema.number("feed.support_interface_mm_s", feed.support_interface_mm_s, kFeed,
                "Speed of their dense layers below and on the part.");
  schema.number("feed.first_layer_mm_s", feed.first_layer_mm_s, kFeed,
                "Upper bound of these in the first layer.");
}

}  // namespace

void describe(SettingsSchema& schema, PlanSettings& settings) {
  describe(schema, settings.bead);
  describe(schema, settings.walls);
  describe(schema, settings.adapted);
  describe(schema, settings.infill);
  describe(schema, settings.skins);
  describe(schema, settings.ironing);
  describe(schema, settings.bridges);
  describe(schema, settings.overhangs);
  describe(schema, settings.fill);
  describe(schema, settings.voids);
  describe(schema, settings.skirt);
  describe(schema, settings.adhesion);
  describe(schema, settings.supports);
  describe(schema, settings.anchoring);
  describe(schema, settings.seam);
  describe(schema, settings.travel);
  describe(schema, settings.feed);
  describe(schema, settings.first_layer);
  describe(schema, settings.tools);
  schema.number("planning.simplification_mm", settings.simplification_mm, {0.0, 10.0},
                "How far a planned outline may leave the sliced one.");
}

}  // namespace lamina
