// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/stack_skins.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "planning/skins/chart_cover.hpp"
#include "planning/skins/skin_areas.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

SkinReach reachOf(const JobSettings& settings) {
  const PlanSettings& planning = settings.planning;
  const SkinSettings& skins = planning.skins;
  const double height_mm = settings.slicing.layer_height_mm;
  return {skinCount(skins.top_layers, skins.top_mm, height_mm),
          skinCount(skins.bottom_layers, skins.bottom_mm, height_mm), planning.bead.width_mm, 0.0};
}

/// Level layers that follow each other.
struct LevelRun {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<LevelRun> levelRuns(const FlatStack& stack) {
  std::vector<LevelRun> runs;
  for (std::size_t i = 0; i < stack.plans.size(); ++i) {
    if (!stack.charts[i].empty()) continue;
    if (!runs.empty() && runs.back().end == i)
      ++runs.back().end;
    else
      runs.push_back({i, i + 1});
  }
  return runs;
}

/// Planes in which layers would be cut that lie above a height, or below it, in ascending order.
std::vector<double> cutsBeyond(double height_mm, std::size_t layers, double step_mm) {
  std::vector<double> cuts;
  cuts.reserve(layers);
  for (std::size_t k = 0; k < layers; ++k)
    cuts.push_back(height_mm + (static_cast<double>(k) + 0.5) * step_mm);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

class StackCovering {
 public:
  StackCovering(const FlatStack& stack, const Mesh& part, const JobSettings& settings)
      : stack_(stack), part_(part), settings_(settings), reach_(reachOf(settings)) {}

  /// By level layers, as in a stack that goes on level above and below them.
  void coverLevel(const LevelRun& run, std::vector<LayerCover>& covers, Progress& progress) const {
    const double height_mm = settings_.slicing.layer_height_mm;
    const std::size_t beyond = std::max(reach_.above, reach_.below);
    std::vector<Section> sections =
        sliceMesh(part_, cutsBeyond(stack_.plans[run.begin].bounds.bottom_mm, beyond, -height_mm), progress);
    for (std::size_t i = run.begin; i < run.end; ++i) sections.push_back(stack_.plans[i].section);
    for (Section& section :
         sliceMesh(part_, cutsBeyond(stack_.plans[run.end - 1].bounds.top_mm, beyond, height_mm), progress))
      sections.push_back(std::move(section));
    std::vector<double> heights_mm(sections.size(), height_mm);
    for (std::size_t i = run.begin; i < run.end; ++i)
      heights_mm[beyond + i - run.begin] = stack_.plans[i].bounds.height();
    std::vector<Regions> material(sections.size());
    parallelFor(
        sections.size(), [&](std::size_t i) { material[i] = materialOf(sections[i]); }, progress, "skins");
    std::vector<LayerCover> found =
        coversOf(std::move(material), heights_mm, settings_.planning.skins, progress);
    for (std::size_t i = run.begin; i < run.end; ++i) covers[i] = std::move(found[beyond + i - run.begin]);
  }

  /// By the part along the growth of each layer.
  void coverBent(std::vector<LayerCover>& covers, Progress& progress) const {
    const PartSpace space(part_);
    const auto cover = [&](std::size_t i) {
      if (stack_.charts[i].empty() || stack_.is_skin[i]) return;
      const Layer& plan = stack_.plans[i];
      SkinReach reach = reach_;
      const LayerBeads beads = beadsByRole(settings_.planning, plan.bounds.height());
      reach.wall_mm = wallThickness(settings_.planning, beads.walls.pitch_mm);
      covers[i] = coverOnCharts(stack_.charts[i], materialOf(plan.section), space, reach);
    };
    parallelFor(covers.size(), cover, progress, "skins");
  }

 private:
  Regions materialOf(const Section& section) const {
    return unite(simplify(section.contours, settings_.planning.simplification_mm));
  }

  const FlatStack& stack_;
  const Mesh& part_;
  const JobSettings& settings_;
  SkinReach reach_;
};

}  // namespace

std::vector<bool> skinsOfStack(std::size_t layers, const SkinSettings& skins, double layer_height_mm) {
  std::vector<bool> is_skin(layers, false);
  std::fill_n(is_skin.begin(),
              std::min(layers, skinCount(skins.bottom_layers, skins.bottom_mm, layer_height_mm)), true);
  std::fill_n(is_skin.rbegin(), std::min(layers, skinCount(skins.top_layers, skins.top_mm, layer_height_mm)),
              true);
  return is_skin;
}

std::vector<LayerCover> coversOfStack(const FlatStack& stack, const Mesh& part, const JobSettings& settings,
                                      Progress& progress) {
  if (part.triangles.empty() || !takesSkins(settings.planning)) return {};
  const StackCovering covering(stack, part, settings);
  std::vector<LayerCover> covers(stack.plans.size());
  for (const LevelRun& run : levelRuns(stack)) covering.coverLevel(run, covers, progress);
  covering.coverBent(covers, progress);
  return dividedOnly(std::move(covers), stack.is_skin);
}

std::vector<LayerCover> dividedOnly(std::vector<LayerCover> covers, const std::vector<bool>& is_skin) {
  for (std::size_t i = 0; i < covers.size(); ++i)
    if (is_skin[i]) covers[i] = LayerCover();
  return covers;
}

}  // namespace lamina
