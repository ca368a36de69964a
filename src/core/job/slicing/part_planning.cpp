// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/slicing/part_planning.hpp"

#include <filesystem>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {

std::string PlanningRequest::partName() const { return std::filesystem::path(job.part).stem().string(); }

LayerCounts countsOf(const std::vector<Layer>& layers) {
  LayerCounts counts;
  counts.layers = layers.size();
  for (const Layer& layer : layers) {
    counts.contours += layer.section.contours.size();
    counts.open_contours += layer.section.open_contours.size();
    counts.sliced_volume_mm3 += signedArea(layer.section.contours) * layer.bounds.height();
  }
  return counts;
}

PlannedPart planByMode(SourcePart source, SlicingMode mode, const PlanningRequest& request,
                       Progress& progress) {
  switch (mode) {
    case SlicingMode::Planar:
    case SlicingMode::Inclined:
      return planPlanar(std::move(source), request, progress);
    case SlicingMode::Curved:
      return planCurved(std::move(source), request, progress);
    case SlicingMode::Adapted:
      return planAdapted(std::move(source), request, progress);
    case SlicingMode::Conformal:
      return planConformal(std::move(source), request, progress);
    case SlicingMode::HeightField:
      return planHeightField(std::move(source), request, progress);
    default:
      throw InvalidConfig(std::string("slicing.mode '") + toString(mode) + "' cannot be planned");
  }
}

}  // namespace lamina
