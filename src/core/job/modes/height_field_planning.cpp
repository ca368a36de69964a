// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "job/laps.hpp"
#include "job/modes/part_planning.hpp"
#include "job/modes/stack_skins.hpp"
#include "lamina/planning/lift/height_field_lift.hpp"
#include "lamina/slicing/height_field/height_field_slicer.hpp"
#include "planning/skins/stack_covers.hpp"

namespace lamina {

PlannedPart planHeightField(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  const HeightFieldSlices slices =
      sliceByHeightField(source.mesh, settings.slicing, settings.height_field, progress);
  source = {};
  PlannedPart planned;
  planned.counts = countsOf(slices.layers);
  planned.counts.slice_s = laps.lap();
  planned.notes = notesOf(slices.report, settings.height_field);
  LiftSettings lifting = settings.lifting;
  lifting.tool_axis = ToolAxis::Down;
  LayerLifting lifted{
      heightFieldLift(slices, lifting, settings.planning.travel),
      skinsOfStack(slices.layers.size(), settings.planning.skins, settings.slicing.layer_height_mm)};
  // Bent layers keep their x and y: what covers them does so as if they were level.
  if (takesSkins(settings.planning))
    lifted.covers = dividedOnly(
        stackCovers(slices.layers, settings.planning, StackPlace::NearOrigin, progress), lifted.is_skin);
  planned.plan = planPart(request.partName(), slices.layers, settings.planning, lifted, progress);
  return planned;
}

}  // namespace lamina
