// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/infill/fill_settings.hpp"
#include "lamina/infill/line_link.hpp"
#include "lamina/planning/adhesion/adhesion_settings.hpp"
#include "lamina/planning/bridges/bridge_settings.hpp"
#include "lamina/planning/compensation/compensation_settings.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/overhangs/overhanging_walls.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "lamina/planning/tools/tool_settings.hpp"

namespace lamina {

/// Cross-section of the beads.
struct BeadSettings {
  double width_mm = 0.4;
  /// Centre distance of neighbouring beads in a solid fill; 0: the distance at which they fill the layer
  /// exactly.
  double pitch_mm = 0.0;
  double flow = 1.0;  ///< factor on the volume of the part's beads; their positions do not change
};

enum class WallOrder { OutsideIn, InsideOut };

/// Closed loops along each outline.
struct WallSettings {
  int count = 2;
  WallOrder order = WallOrder::InsideOut;
  /// Least width of a bead where no loop fits, in pitches; narrower places stay empty.
  double narrowest = 0.3;
};

/// How the area inside the walls is filled.
struct InfillSettings {
  std::string strategy = "zigzag";
  double density = 0.2;         ///< 1 is solid, 0 is none
  double bead_width_mm = 0.0;   ///< 0: the width of walls, in proportion to the nozzles of their tools
  double pitch_mm = 0.0;        ///< distance of neighbouring lines; 0: it follows from the density
  int outer_layers = 0;         ///< number of first and of last layers with a pitch of their own
  double outer_pitch_mm = 0.0;  ///< pitch in these layers; 0 is solid
  double angle_deg = 45.0;
  double alternation_deg = 90.0;  ///< angle added from one layer to the next
  double wall_overlap = 0.15;     ///< overlap of infill with the innermost wall, in bead widths
  int every_layers = 1;  ///< sparse infill is deposited in every n-th layer, in beads as high as n layers
  LineLinks links;       ///< links between lines of sparse infill
};

/// Solid layers where the part is visible from above or below, beside a sparse infill.
struct SkinSettings {
  int top_layers = 0;          ///< number; 0 with `top_mm` 0: none
  int bottom_layers = 0;       ///< number; 0 with `bottom_mm` 0: none
  double top_mm = 0.0;         ///< least thickness, in whole layers
  double bottom_mm = 0.0;      ///< least thickness, in whole layers
  double bead_width_mm = 0.0;  ///< 0: the width of walls, in proportion to the nozzles of their tools
  std::string strategy = "zigzag";
  double angle_deg = 45.0;         ///< angle of the first layer; turned by 90 deg from layer to layer
  double narrowest = 1.0;          ///< least width of a skin, in bead widths
  double anchor_mm = -1.0;         ///< extension of skins into the infill; -1: the thickness of the walls
  double least_infill_mm2 = 15.0;  ///< smaller areas of infill become skin
  bool is_monotonic = true;        ///< lines of top skins are deposited in order, from one side to the other
};

/// A second pass over top skins.
struct IroningSettings {
  bool is_used = false;
  double flow = 0.15;       ///< share of the layer's height that is deposited in that pass
  double spacing_mm = 0.1;  ///< distance of neighbouring lines
  double inset_mm = 0.2;    ///< distance of the lines from the border of the skin
};

/// Whether there are top skins.
inline bool hasTopSkins(const SkinSettings& settings) {
  return settings.top_layers > 0 || settings.top_mm > 0.0;
}

/// Whether there are any skins.
inline bool hasSkins(const SkinSettings& settings) {
  return hasTopSkins(settings) || settings.bottom_layers > 0 || settings.bottom_mm > 0.0;
}

/// Whether the density is 1, within rounding.
inline bool isSolid(const InfillSettings& settings) { return settings.density > 1.0 - 1e-6; }

/// Whether any layer has lines of infill.
inline bool isFilled(const InfillSettings& settings) {
  return settings.density > 0.0 || settings.pitch_mm > 0.0 || settings.outer_layers > 0;
}

/// What is done about voids between walls and infill.
enum class VoidRefill { None, Beads };

struct VoidSettings {
  VoidRefill refill = VoidRefill::None;
  double least_area = 0.25;  ///< smaller voids are not filled; in squares of the pitch
};

struct SkirtSettings {
  int count = 1;
  double distance_mm = 4.0;  ///< distance from part, brim, raft and supports
  int layers = 1;            ///< number of layers with a skirt; all layers for a wind shield
  /// Least total length of the loops in the first layer; loops are added until it is reached.
  double least_length_mm = 0.0;
};

/// Walls of `AdaptedLayers`, which follow the walls of the part.
struct AdaptedWallSettings {
  double contour_offset = 0.5;  ///< distance of the bead's middle from the part's surface, in bead widths
};

enum class SeamPlacement { Nearest, Aligned, Rear, Random, Corner };

struct SeamSettings {
  SeamPlacement placement = SeamPlacement::Aligned;
  int seed = 1;  ///< seed of random placement
};

/// Where travels run.
enum class Combing : std::uint8_t {
  None,    ///< straight
  Inside,  ///< inside their island
  NoSkin   ///< inside their island, but not over top skins
};

/// Which retracted travels hop.
enum class Hopping : std::uint8_t { Never, OverSkin, Always };

struct TravelSettings {
  double feed_mm_s = 150.0;
  double hop_mm = 0.2;                   ///< lift during a retracted travel
  double retraction_threshold_mm = 2.0;  ///< shorter travels neither retract nor hop
  Hopping hop = Hopping::Always;
  Combing comb = Combing::None;
  double keep_off_mm = 0.2;       ///< distance of combed travels from the outline, besides half a bead width
  double comb_longest_mm = 30.0;  ///< longer travels within an island, combed or over infill, are retracted
  /// Greatest ratio of a combed travel's length to the straight distance; beyond it, travels are straight and
  /// retracted.
  double comb_detour = 3.0;
  double wipe_mm = 0.0;     ///< length of a wipe along the previous run; 0 for none
  double wipe_share = 0.7;  ///< share of the retraction that happens during the wipe
};

struct FeedSettings {
  double outer_wall_mm_s = 30.0;
  double inner_wall_mm_s = 45.0;
  double infill_mm_s = 60.0;
  double skin_mm_s = 45.0;      ///< hidden skins, and skins seen from below
  double top_skin_mm_s = 30.0;  ///< skins seen from above
  double bridge_mm_s = 20.0;    ///< bridges, and walls beside them
  double ironing_mm_s = 20.0;   ///< second pass over top skins
  double skirt_mm_s = 40.0;     ///< brim, raft and priming too
  double support_mm_s = 60.0;
  double support_interface_mm_s = 40.0;
  double first_layer_mm_s = 20.0;  ///< an upper bound for all roles in the first layer
};

/// How layers become paths.
struct PlanSettings {
  BeadSettings bead;
  WallSettings walls;
  InfillSettings infill;
  SkinSettings skins;
  IroningSettings ironing;
  BridgeSettings bridges;
  OverhangingWallSettings overhangs;
  FillSettings fill;
  VoidSettings voids;
  SkirtSettings skirt;        ///< of level layers
  AdhesionSettings adhesion;  ///< of level layers
  SupportSettings supports;   ///< of layers in parallel planes
  AnchorSettings anchoring;
  AdaptedWallSettings adapted;
  SeamSettings seam;
  TravelSettings travel;
  FeedSettings feed;
  FirstLayerSettings first_layer;
  ToolSettings tools;
  double simplification_mm = 0.005;  ///< greatest distance of a planned outline from the sliced outline
};

/// Whether layers have one wall and nothing inside it.
inline bool isLoneWall(const PlanSettings& settings) {
  return settings.walls.count == 1 && !isFilled(settings.infill);
}

/// Adds the keys bead.*, walls.*, infill.*, skins.*, ironing.*, bridges.*, overhangs.*, those of the fill
/// strategies, voids.*, skirt.*, brim.*, raft.*, prime.*, supports.*, anchoring.*, seam.*, travel.*, feed.*,
/// first_layer.*, tool.*, tools.* and planning.*.
void describe(SettingsSchema& schema, PlanSettings& settings);

}  // namespace lamina
