// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modifiers/modified_layers.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "job/part/part_reading.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/box_mesh.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/job/modifiers/modifier.hpp"

namespace lamina {
namespace {

constexpr double kBeyond = 1.0;  // mm, by which a range of heights reaches over the part

/// Numbers of modifiers, ascending.
using ModifierSet = std::vector<std::size_t>;
/// Where in one layer which modifiers hold; apart from each other.
using Overlay = std::vector<std::pair<ModifierSet, Regions>>;

Mesh meshOf(const Modifier& modifier, InputSettings input, Progress& progress) {
  if (modifier.box) return boxMesh(*modifier.box);
  if (modifier.volume) {
    requireSound(*modifier.volume);
    return *modifier.volume;
  }
  input.repair = RepairPolicy::Strict;
  Mesh mesh = readPart(modifier.mesh, input, progress).mesh;
  if (!(volume(mesh) > 0.0))
    throw InvalidMesh("'" + modifier.mesh + "' encloses " + numberText(volume(mesh)) +
                      " mm3; expected a volume above 0");
  return mesh;
}

/// Sections of the modifiers of a part.
class ModifierSections {
 public:
  ModifierSections(const std::vector<Layer>& layers, const SourcePart& source, const InputSettings& input)
      : source_(source), input_(input), part_(boundingBox(source.mesh)) {
    for (const Layer& layer : layers) heights_.push_back(layer.bounds.cut());
  }

  /// By layer.
  std::vector<Regions> of(const Modifier& modifier, Progress& progress) const {
    try {
      return modifier.heights_mm ? between(*modifier.heights_mm) : within(modifier, progress);
    } catch (...) {
      rethrowAt(modifier.place);
    }
  }

 private:
  std::vector<Regions> between(const std::pair<double, double>& heights_mm) const {
    const Point2 low = part_.low.head<2>() - Point2::Constant(kBeyond);
    const Point2 high = part_.high.head<2>() + Point2::Constant(kBeyond);
    const Region whole{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}};
    std::vector<Regions> areas(heights_.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const double height_mm = heights_[i] - part_.low.z();
      if (height_mm >= heights_mm.first && height_mm < heights_mm.second) areas[i] = {whole};
    }
    return areas;
  }

  std::vector<Regions> within(const Modifier& modifier, Progress& progress) const {
    Mesh mesh = meshOf(modifier, input_, progress);
    for (Point3& vertex : mesh.vertices) vertex = source_.part_from_file * vertex;
    const std::vector<Section> sections = sliceMesh(mesh, heights_, progress);
    std::vector<Regions> areas(sections.size());
    parallelFor(
        areas.size(), [&](std::size_t i) { areas[i] = unite(sections[i].contours); }, progress, "slice");
    return areas;
  }

  const SourcePart& source_;
  const InputSettings& input_;
  Box3 part_;
  std::vector<double> heights_;
};

/// Lays one more modifier over those of a layer.
Overlay overlaid(const Overlay& before, std::size_t modifier, const Regions& area) {
  if (area.empty()) return before;
  Overlay after;
  Regions rest = area;
  for (const auto& [set, there] : before) {
    Regions common = intersection(there, area);
    if (common.empty()) {
      after.emplace_back(set, there);
      continue;
    }
    rest = difference(rest, there);
    Regions alone = difference(there, area);
    if (!alone.empty()) after.emplace_back(set, std::move(alone));
    ModifierSet both = set;
    both.push_back(modifier);
    after.emplace_back(std::move(both), std::move(common));
  }
  if (!rest.empty()) after.emplace_back(ModifierSet{modifier}, std::move(rest));
  return after;
}

PlanSettings settingsIn(const ModifierSet& set, const std::vector<Modifier>& modifiers,
                        const JobSettings& of_part) {
  JobSettings settings = of_part;
  SettingsSchema schema;
  describe(schema, settings);
  for (const std::size_t i : set) {
    try {
      for (const SettingText& setting : modifiers[i].settings) schema.set(setting.key, setting.text);
      validate(settings);
    } catch (...) {
      rethrowAt(modifiers[i].place);
    }
  }
  return settings.planning;
}

std::vector<PlanVariant> variantsOf(std::vector<Overlay> layers, const std::vector<Modifier>& modifiers,
                                    const JobSettings& settings) {
  std::map<ModifierSet, PlanVariant> variants;
  for (std::size_t i = 0; i < layers.size(); ++i)
    for (auto& [set, area] : layers[i]) {
      PlanVariant& variant = variants[set];
      variant.areas.resize(layers.size());
      Regions& there = variant.areas[i];
      there.insert(there.end(), std::make_move_iterator(area.begin()), std::make_move_iterator(area.end()));
    }
  std::vector<PlanVariant> found;
  for (auto& [set, variant] : variants) {
    variant.settings = settingsIn(set, modifiers, settings);
    found.push_back(std::move(variant));
  }
  return found;
}

void cutAway(Layer& layer, const Regions& negative) {
  if (negative.empty()) return;
  layer.section.contours = outlines(difference(unite(layer.section.contours), negative));
}

Regions unitedWith(const Regions& marked, const Regions& area) {
  std::vector<Polygon> all = outlines(marked);
  for (Polygon& outline : outlines(area)) all.push_back(std::move(outline));
  return unite(all);
}

Regions without(const Regions& marked, const Regions& area) {
  return marked.empty() ? marked : difference(marked, area);
}

/// Applies modifiers to the layers of a part one by one.
class LayerModifier {
 public:
  explicit LayerModifier(std::vector<Layer> layers) : overlays_(layers.size()) {
    modified_.layers = std::move(layers);
  }

  void apply(ModifierKind kind, std::size_t number, const std::vector<Regions>& areas, Progress& progress) {
    SupportMarks& marks = modified_.marks;
    if (kind == ModifierKind::SupportBlocker || kind == ModifierKind::SupportEnforcer) {
      marks.never.resize(areas.size());
      marks.always.resize(areas.size());
    }
    if (kind == ModifierKind::SeamHere) modified_.seams.resize(areas.size());
    const auto apply_in = [&](std::size_t i) {
      switch (kind) {
        case ModifierKind::Settings:
          overlays_[i] = overlaid(overlays_[i], number, areas[i]);
          break;
        case ModifierKind::Negative:
          cutAway(modified_.layers[i], areas[i]);
          break;
        case ModifierKind::SupportBlocker:
          if (areas[i].empty()) break;
          marks.always[i] = without(marks.always[i], areas[i]);
          marks.never[i] = unitedWith(marks.never[i], areas[i]);
          break;
        case ModifierKind::SupportEnforcer:
          if (areas[i].empty()) break;
          marks.never[i] = without(marks.never[i], areas[i]);
          marks.always[i] = unitedWith(marks.always[i], areas[i]);
          break;
        case ModifierKind::SeamHere:
          if (!areas[i].empty()) modified_.seams[i] = unitedWith(modified_.seams[i], areas[i]);
          break;
      }
    };
    parallelFor(areas.size(), apply_in, progress, "slice");
  }

  ModifiedLayers finish(const std::vector<Modifier>& modifiers, const JobSettings& settings) && {
    modified_.variants = variantsOf(std::move(overlays_), modifiers, settings);
    return std::move(modified_);
  }

 private:
  ModifiedLayers modified_;
  std::vector<Overlay> overlays_;
};

}  // namespace

ModifiedLayers withModifiers(std::vector<Layer> layers, const SourcePart& source, const JobSettings& settings,
                             Progress& progress) {
  VolumeModifiers of_file = modifiersOf(source.volumes, settings);
  std::vector<Modifier>& modifiers = of_file.modifiers;
  if (!settings.modifiers.empty())
    for (Modifier& modifier : readModifiersFile(settings.modifiers)) modifiers.push_back(std::move(modifier));
  if (modifiers.empty()) return {std::move(layers), {}, {}, {}, std::move(of_file.notes)};
  const ModifierSections sections(layers, source, settings.input);
  LayerModifier modifier(std::move(layers));
  for (std::size_t m = 0; m < modifiers.size(); ++m)
    modifier.apply(modifiers[m].kind, m, sections.of(modifiers[m], progress), progress);
  ModifiedLayers modified = std::move(modifier).finish(modifiers, settings);
  modified.notes = std::move(of_file.notes);
  return modified;
}

bool asksForSupports(const ModifiedLayers& modified) {
  const std::vector<Regions>& always = modified.marks.always;
  return std::any_of(always.begin(), always.end(), [](const Regions& area) { return !area.empty(); }) ||
         std::any_of(modified.variants.begin(), modified.variants.end(),
                     [](const PlanVariant& variant) { return variant.settings.supports.use; });
}

}  // namespace lamina
