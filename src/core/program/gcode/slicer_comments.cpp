// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/slicer_comments.hpp"

#include <charconv>
#include <utility>

#include "lamina/base/text_search.hpp"

namespace lamina {
namespace {

constexpr std::pair<std::string_view, PathRole> kTypes[] = {
    {"skirt", PathRole::Skirt},
    {"outer_wall", PathRole::OuterWall},
    {"inner_wall", PathRole::InnerWall},
    {"infill", PathRole::Infill},
    {"gap_fill", PathRole::GapFill},
    {"top_skin", PathRole::TopSkin},
    {"skin", PathRole::Skin},
    {"bottom_skin", PathRole::BottomSkin},
    {"bridge", PathRole::Bridge},
    {"support", PathRole::Support},
    {"support_interface", PathRole::SupportInterface},
    {"brim", PathRole::Brim},
    {"raft", PathRole::Raft},
    {"prime", PathRole::Prime},
    {"ironing", PathRole::Ironing},
    // Cura
    {"SKIRT", PathRole::Skirt},
    {"WALL-OUTER", PathRole::OuterWall},
    {"WALL-INNER", PathRole::InnerWall},
    {"FILL", PathRole::Infill},
    {"SKIN", PathRole::Skin},
    {"SUPPORT", PathRole::Support},
    {"SUPPORT-INTERFACE", PathRole::SupportInterface},
    {"PRIME-TOWER", PathRole::Prime},
    // PrusaSlicer
    {"Support material", PathRole::Support},
    {"Support material interface", PathRole::SupportInterface},
    {"Wipe tower", PathRole::Prime},
    {"Skirt", PathRole::Skirt},
    {"Skirt/Brim", PathRole::Skirt},
    {"External perimeter", PathRole::OuterWall},
    {"Overhang perimeter", PathRole::OuterWall},
    {"Perimeter", PathRole::InnerWall},
    {"Internal infill", PathRole::Infill},
    {"Solid infill", PathRole::Skin},
    {"Top solid infill", PathRole::TopSkin},
    {"Bridge infill", PathRole::Bridge},
    {"Gap fill", PathRole::GapFill},
    {"Ironing", PathRole::Ironing},
    // OrcaSlicer
    {"Brim", PathRole::Brim},
    {"Support", PathRole::Support},
    {"Support interface", PathRole::SupportInterface},
    {"Support transition", PathRole::SupportInterface},
    {"Prime tower", PathRole::Prime},
    {"Outer wall", PathRole::OuterWall},
    {"Overhang wall", PathRole::OuterWall},
    {"Inner wall", PathRole::InnerWall},
    {"Sparse infill", PathRole::Infill},
    {"Internal solid infill", PathRole::Skin},
    {"Top surface", PathRole::TopSkin},
    {"Bottom surface", PathRole::BottomSkin},
    {"Bridge", PathRole::Bridge},
    {"Internal Bridge", PathRole::Bridge},
    {"Gap infill", PathRole::GapFill},
};

/// Slic3r reports the role beside each motion.
constexpr std::pair<std::string_view, PathRole> kMotionRemarks[] = {
    {"perimeter", PathRole::InnerWall},
    {"infill", PathRole::Infill},
    {"infill (bridge)", PathRole::Bridge},
    {"skirt", PathRole::Skirt},
    {"brim", PathRole::Brim},
    {"gap fill", PathRole::GapFill},
    {"support material", PathRole::Support},
    {"support material interface", PathRole::SupportInterface},
};

template <std::size_t count>
std::optional<PathRole> find(const std::pair<std::string_view, PathRole> (&names)[count],
                             std::string_view name) {
  for (const auto& entry : names)
    if (entry.first == name) return entry.second;
  return std::nullopt;
}

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return true;
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{}) return std::nullopt;
  return value;
}

void openLayer(std::optional<int> layer, SlicerContext& context) {
  if (!layer) return;
  context.layer = layer;
  context.is_layer_height_open = true;
  ++context.section;
}

void setHeight(std::string_view text, SlicerContext& context) {
  const auto height_mm = number<double>(text);
  if (!height_mm || !(*height_mm > 0.0 && *height_mm < 1e3)) return;
  context.height_mm = height_mm;
  if (context.is_layer_height_open) context.layer_height_mm = height_mm;
  context.is_layer_height_open = false;
}

/// Simplify3D names what follows in plain words ("feature outer perimeter", before version 4 "outer
/// perimeter"), which its settings, reported in the header, are not.
std::optional<PathRole> featureRole(std::string_view comment) {
  const bool says_feature = takePrefix(comment, "feature ");
  for (const char letter : comment)
    if (letter != ' ' && (letter < 'a' || letter > 'z')) return std::nullopt;
  // Supports come first: "support infill" is none of the part.
  constexpr std::pair<std::string_view, PathRole> kAids[] = {
      {"support", PathRole::Support}, {"skirt", PathRole::Skirt},  {"brim", PathRole::Brim},
      {"raft", PathRole::Raft},       {"pillar", PathRole::Prime}, {"shield", PathRole::Skirt}};
  for (const auto& [name, role] : kAids)
    if (contains(comment, name)) return role;
  if (contains(comment, "outer perimeter") || contains(comment, "external single"))
    return PathRole::OuterWall;
  if (contains(comment, "perimeter") || contains(comment, "internal single")) return PathRole::InnerWall;
  if (contains(comment, "gap fill")) return PathRole::GapFill;
  if (contains(comment, "bridge")) return PathRole::Bridge;
  if (contains(comment, "solid")) return PathRole::Skin;
  if (contains(comment, "fill")) return PathRole::Infill;
  return says_feature ? std::optional(PathRole::Infill) : std::nullopt;
}

/// @return whether the comment is one of Simplify3D's
bool readSimplify3d(std::string_view comment, SlicerContext& context) {
  if (takePrefix(comment, "layer end")) {
    context.layer.reset();
    ++context.section;
  } else if (takePrefix(comment, "layer ")) {
    openLayer(number<int>(comment), context);
  } else if (takePrefix(comment, "tool H")) {
    setHeight(comment, context);
  } else if (const auto role = featureRole(comment)) {
    context.role = role;
    ++context.section;
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::optional<LayerMark> readLayerMark(std::string_view comment) {
  if (takePrefix(comment, "LAYER:") || takePrefix(comment, "move to next layer ("))
    return LayerMark{false, number<int>(comment)};
  return comment == "LAYER_CHANGE" ? std::optional(LayerMark{true, std::nullopt}) : std::nullopt;
}

void readComment(std::string_view comment, SlicerContext& context) {
  context.dialect = dialectAfter(context.dialect, comment);
  if (context.dialect == SlicerDialect::Simplify3d && readSimplify3d(comment, context)) return;
  if (takePrefix(comment, "TYPE:")) {
    context.role = find(kTypes, comment);
    ++context.section;
  } else if (const auto mark = readLayerMark(comment)) {
    openLayer(mark->is_next ? context.layer.value_or(-1) + 1 : mark->number, context);
  } else if (takePrefix(comment, "HEIGHT:") || takePrefix(comment, "Layer height:")) {
    setHeight(comment, context);
  } else if (comment == "end of the part") {
    context.layer.reset();
    ++context.section;
  } else if (const auto role = find(kMotionRemarks, comment)) {
    context.role = role;
  }
}

std::optional<double> statedFilamentDiameter(std::string_view comment) {
  const bool is_stated = takePrefix(comment, "filament_diameter = ") ||
                         takePrefix(comment, "program.filament_diameter_mm = ") ||
                         takePrefix(comment, "filamentDiameters,");
  if (!is_stated) return std::nullopt;
  const auto diameter_mm = number<double>(comment);
  const bool is_possible = diameter_mm && *diameter_mm > 0.1 && *diameter_mm <= 20.0;
  return is_possible ? diameter_mm : std::nullopt;
}

GcodeMotion motionIn(const SlicerContext& context) {
  GcodeMotion motion;
  motion.layer = context.layer;
  motion.role = context.role;
  motion.height_mm = context.height_mm;
  motion.layer_height_mm = context.layer_height_mm;
  motion.section = context.section;
  return motion;
}

}  // namespace lamina
