// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/part/source_part.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/supports/support_marks.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Level layers of a part, and the areas in which other settings hold.
struct ModifiedLayers {
  std::vector<Layer> layers;
  std::vector<PlanVariant> variants;
  SupportMarks marks;
  std::vector<Regions> seams;      ///< where walls start, by layer; empty for none
  std::vector<std::string> notes;  ///< which of the volumes in the part's file are ignored, and why
};

/// Whether supports are asked for anywhere in the layers, by a mark or by settings.
bool asksForSupports(const ModifiedLayers& modified);

/// Cuts negative modifiers out of the layers of a part, and finds the areas of the others. Where several
/// overlap, the settings of all hold; if two set the same key, or one blocks and one enforces supports, the
/// last one wins. Areas for seams are united. A modifier is cut by the planes at the middles of the layers.
/// Without `part.modifiers` the layers are returned unchanged.
/// @param source  the part that was cut into these layers
/// @throws InvalidConfig, InvalidMesh, FileError naming the modifier: also if it encloses nothing or is not
///   sound; Cancelled
ModifiedLayers withModifiers(std::vector<Layer> layers, const SourcePart& source, const JobSettings& settings,
                             Progress& progress);

}  // namespace lamina
