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

/// Level layers of a part, and where other settings hold in them.
struct ModifiedLayers {
  std::vector<Layer> layers;
  std::vector<PlanVariant> variants;
  SupportMarks marks;
  std::vector<std::string> notes;  ///< what of the volumes of the part's file is left out
};

/// Whether a region asks for supports, be it by a mark or by settings.
bool asksForSupports(const ModifiedLayers& modified);

/// Cuts negative modifiers out of the layers of a part, and lays the others over each other: where several
/// meet, the settings of all hold, of the same key that of the last; of a blocker and an enforcer of supports
/// the last holds. Modifiers are cut by the planes of the
/// layers; one holds in a layer where it holds at its middle. Without `part.modifiers` nothing changes.
/// @param source  whose layers they are
/// @throws InvalidConfig, InvalidMesh, FileError naming the modifier: also if it encloses nothing or is not
///   sound; Cancelled
ModifiedLayers withModifiers(std::vector<Layer> layers, const SourcePart& source, const JobSettings& settings,
                             Progress& progress);

}  // namespace lamina
