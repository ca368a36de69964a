// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modifiers/slicer_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "geometry/mesh_io/volume_origin.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/quotation.hpp"

namespace lamina {
namespace {

/// How a value is written here.
enum class ValueKind {
  AsItIs,
  Share,        ///< 60% is 0.6
  WallOverlap,  ///< the same, or mm
  Feed,         ///< mm/s, or a share of another feed; 0 leaves it to the slicer
  Pattern,
  BridgeAngle,  ///< 0 is sought
  Tool,         ///< from 1; 0 is none of its own
  Percent,      ///< 60 is 0.6
  ToolFromZero  ///< below 0 is none of its own
};

struct SettingNames {
  std::string_view prusa;  ///< PrusaSlicer's
  std::string_view orca;   ///< OrcaSlicer's and Bambu Studio's
  const char* key;
  ValueKind kind = ValueKind::AsItIs;
  const char* base = "";  ///< key of the feed that shares refer to
};

/// What others refer to stands before them.
constexpr std::array<SettingNames, 24> kSettingNames = {{
    {"perimeters", "wall_loops", "walls.count"},
    {"fill_density", "sparse_infill_density", "infill.density", ValueKind::Share},
    {"fill_pattern", "sparse_infill_pattern", "infill.strategy", ValueKind::Pattern},
    {"fill_angle", "infill_direction", "infill.angle_deg"},
    {"infill_overlap", "infill_wall_overlap", "infill.wall_overlap", ValueKind::WallOverlap},
    {"top_solid_layers", "top_shell_layers", "skins.top_layers"},
    {"bottom_solid_layers", "bottom_shell_layers", "skins.bottom_layers"},
    {"top_solid_min_thickness", "top_shell_thickness", "skins.top_mm"},
    {"bottom_solid_min_thickness", "bottom_shell_thickness", "skins.bottom_mm"},
    {"solid_infill_below_area", "minimum_sparse_infill_area", "skins.least_infill_mm2"},
    {"perimeter_speed", "inner_wall_speed", "feed.inner_wall_mm_s", ValueKind::Feed},
    {"external_perimeter_speed", "outer_wall_speed", "feed.outer_wall_mm_s", ValueKind::Feed,
     "feed.inner_wall_mm_s"},
    {"infill_speed", "sparse_infill_speed", "feed.infill_mm_s", ValueKind::Feed},
    {"solid_infill_speed", "internal_solid_infill_speed", "feed.skin_mm_s", ValueKind::Feed,
     "feed.infill_mm_s"},
    {"top_solid_infill_speed", "top_surface_speed", "feed.top_skin_mm_s", ValueKind::Feed, "feed.skin_mm_s"},
    {"bridge_speed", "bridge_speed", "feed.bridge_mm_s", ValueKind::Feed},
    {"ironing_speed", "ironing_speed", "feed.ironing_mm_s", ValueKind::Feed},
    {"bridge_flow_ratio", "bridge_flow", "bridges.flow"},
    {"bridge_angle", "bridge_angle", "bridges.angle_deg", ValueKind::BridgeAngle},
    {"print_flow_ratio", "print_flow_ratio", "bead.flow"},
    {"extruder", "extruder", "tool", ValueKind::Tool},
    {"perimeter_extruder", "wall_filament", "tool.walls", ValueKind::Tool},
    {"infill_extruder", "sparse_infill_filament", "tool.infill", ValueKind::Tool},
    {"solid_infill_extruder", "solid_infill_filament", "tool.skin", ValueKind::Tool},
}};

/// Cura's, by what its files call them.
struct CuraNames {
  std::string_view cura;
  const char* key;
  ValueKind kind = ValueKind::AsItIs;
};

constexpr std::array<CuraNames, 16> kCuraNames = {{
    {"cura:wall_line_count", "walls.count"},
    {"cura:infill_sparse_density", "infill.density", ValueKind::Percent},
    {"cura:infill_pattern", "infill.strategy", ValueKind::Pattern},
    {"cura:infill_overlap", "infill.wall_overlap", ValueKind::Percent},
    {"cura:top_layers", "skins.top_layers"},
    {"cura:bottom_layers", "skins.bottom_layers"},
    {"cura:top_thickness", "skins.top_mm"},
    {"cura:bottom_thickness", "skins.bottom_mm"},
    {"cura:min_infill_area", "skins.least_infill_mm2"},
    {"cura:speed_wall_x", "feed.inner_wall_mm_s", ValueKind::Feed},
    {"cura:speed_wall_0", "feed.outer_wall_mm_s", ValueKind::Feed},
    {"cura:speed_infill", "feed.infill_mm_s", ValueKind::Feed},
    {"cura:speed_topbottom", "feed.skin_mm_s", ValueKind::Feed},
    {"cura:bridge_skin_speed", "feed.bridge_mm_s", ValueKind::Feed},
    {"cura:material_flow", "bead.flow", ValueKind::Percent},
    {"cura:extruder_nr", "tool", ValueKind::ToolFromZero},
}};

/// Those that lay the same lines here; aligned ones do not turn from layer to layer.
constexpr const char* kAligned = "aligned";
constexpr std::array<std::pair<std::string_view, const char*>, 15> kPatterns = {
    {{"rectilinear", "zigzag"},
     {"zig-zag", "zigzag"},
     {"zigzag", "zigzag"},
     {"line", "zigzag"},
     {"lines", "zigzag"},
     {"monotonic", "zigzag"},
     {"monotonicline", "zigzag"},
     {"alignedrectilinear", kAligned},
     {"grid", "grid"},
     {"triangles", "triangles"},
     {"cubic", "cubic"},
     {"gyroid", "gyroid"},
     {"honeycomb", "honeycomb"},
     {"lightning", "lightning"},
     {"hilbertcurve", "hilbert"}}};

std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Of "60%".
std::optional<double> shareIn(std::string_view text) {
  if (text.empty() || text.back() != '%') return std::nullopt;
  const auto percent = numberIn(text.substr(0, text.size() - 1));
  return percent ? std::optional<double>(*percent / 100.0) : std::nullopt;
}

std::string roundedText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

class SettingsTranslation {
 public:
  SettingsTranslation(const std::vector<SettingText>& of_slicer, const JobSettings& of_part)
      : region_(of_part), tools_(toolsOf(of_part.planning.tools).size()) {
    describe(schema_, region_);
    for (const auto& [key, text] : of_slicer)
      if (!saysOrigin(key)) rest_[key] = text;
  }

  TranslatedSettings run() && {
    for (const SettingNames& names : kSettingNames) {
      translate(names, std::string(names.prusa));
      translate(names, std::string(names.orca));
    }
    for (const CuraNames& names : kCuraNames)
      translate({{}, {}, names.key, names.kind}, std::string(names.cura));
    passOverLayerHeight();
    fillSolidly();
    Quotation quotation;
    quotation.recognise();
    for (const auto& [key, text] : rest_)
      found_.left_out.push_back(quotation.of(key) + " " + quotation.of(text));
    return std::move(found_);
  }

 private:
  /// What cannot be set stays among the rest.
  void translate(const SettingNames& names, const std::string& key) {
    const auto stated = rest_.find(key);
    if (stated == rest_.end()) return;
    const auto settings = settingsFor(names, stated->second);
    if (!settings) return;
    try {
      for (const SettingText& setting : *settings) schema_.set(setting.key, setting.text);
    } catch (const InvalidConfig&) {
      return;
    }
    found_.settings.insert(found_.settings.end(), settings->begin(), settings->end());
    rest_.erase(stated);
  }

  /// None where the value has no meaning here; no setting where it says nothing.
  std::optional<std::vector<SettingText>> settingsFor(const SettingNames& names,
                                                      const std::string& text) const {
    const std::string key = names.key;
    const auto as = [&](double value) { return std::vector<SettingText>{{key, roundedText(value)}}; };
    const auto number = numberIn(text);
    const auto share = shareIn(text);
    switch (names.kind) {
      case ValueKind::AsItIs:
        return std::vector<SettingText>{{key, text}};
      case ValueKind::Share:
        if (share) return as(*share);
        break;
      case ValueKind::WallOverlap:
        if (share) return as(*share);
        if (number) return as(*number / region_.planning.bead.width_mm);
        break;
      case ValueKind::Feed:
        if (number && *number == 0.0) return std::vector<SettingText>{};
        if (number) return as(*number);
        if (share && *names.base != '\0')
          return as(*share * numberIn(schema_.find(names.base)->get()).value());
        break;
      case ValueKind::Pattern:
        return patternOf(text);
      case ValueKind::BridgeAngle:
        if (number) return as(*number == 0.0 ? -1.0 : *number);
        break;
      case ValueKind::Tool:
        if (number) return toolOf(key, *number);
        break;
      case ValueKind::Percent:
        if (number) return as(*number / 100.0);
        break;
      case ValueKind::ToolFromZero:
        if (number) return toolOf(key, std::max(*number + 1.0, 0.0));
        break;
    }
    return std::nullopt;
  }

  static std::optional<std::vector<SettingText>> patternOf(const std::string& name) {
    for (const auto& [pattern, strategy] : kPatterns) {
      if (pattern != name) continue;
      if (strategy == kAligned)
        return std::vector<SettingText>{{"infill.strategy", "zigzag"}, {"infill.alternation_deg", "0"}};
      return std::vector<SettingText>{{"infill.strategy", strategy}};
    }
    return std::nullopt;
  }

  std::optional<std::vector<SettingText>> toolOf(const std::string& key, double number) const {
    if (number == 0.0) return std::vector<SettingText>{};
    if (number != std::floor(number) || number < 1.0 ||
        number > static_cast<double>(std::max<std::size_t>(tools_, 1)))
      return std::nullopt;
    const std::string tool = std::to_string(static_cast<int>(number) - 1);
    if (key != "tool") return std::vector<SettingText>{{key, tool}};
    return std::vector<SettingText>{{"tool.walls", tool}, {"tool.infill", tool}, {"tool.skin", tool}};
  }

  /// Ranges of heights state it always; that of the part is no other.
  void passOverLayerHeight() {
    const auto stated = rest_.find("layer_height");
    if (stated == rest_.end()) return;
    const auto height_mm = numberIn(stated->second);
    if (height_mm && std::abs(*height_mm - region_.slicing.layer_height_mm) < 1e-9) rest_.erase(stated);
  }

  /// As these slicers do, whose sparse patterns are none of solid fills.
  void fillSolidly() {
    const auto sets = [&](const char* key) {
      return std::any_of(found_.settings.begin(), found_.settings.end(),
                         [&](const SettingText& setting) { return setting.key == key; });
    };
    if (region_.planning.infill.density >= 1.0 && sets("infill.density") && !sets("infill.strategy"))
      found_.settings.push_back({"infill.strategy", "zigzag"});
  }

  JobSettings region_;
  SettingsSchema schema_;
  std::size_t tools_;
  std::map<std::string, std::string> rest_;
  TranslatedSettings found_;
};

}  // namespace

TranslatedSettings translated(const std::vector<SettingText>& of_slicer, const JobSettings& of_part) {
  return SettingsTranslation(of_slicer, of_part).run();
}

}  // namespace lamina
