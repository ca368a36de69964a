// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/laid_beside.hpp"

#include <cmath>
#include <vector>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "planning/adhesion/brim.hpp"
#include "planning/adhesion/raft.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

bool hasRaft(const JobSettings& settings) { return settings.planning.adhesion.raft.layers > 0; }

double pitchOfBrim(const JobSettings& settings) {
  return planWidth(beadOf(PathRole::Brim, settings.planning, settings.slicing.first_layer_height_mm).bead);
}

}  // namespace

double reachBeside(const JobSettings& settings) {
  const AdhesionSettings& adhesion = settings.planning.adhesion;
  if (hasRaft(settings)) return adhesion.raft.margin_mm;
  if (adhesion.brim.width_mm == 0.0 || adhesion.brim.where == BrimWhere::Inside) return 0.0;
  const double pitch_mm = pitchOfBrim(settings);
  return adhesion.brim.gap_mm + pitch_mm * std::round(adhesion.brim.width_mm / pitch_mm);
}

double cutAtEdge(const JobSettings& settings) { return hasRaft(settings) ? 0.0 : reachBeside(settings); }

Regions laidBeside(const Mesh& mesh, const JobSettings& settings, const Box2& bed, Progress& progress) {
  const AdhesionSettings& adhesion = settings.planning.adhesion;
  if (!hasRaft(settings) && adhesion.brim.width_mm == 0.0) return {};
  const double cut_mm = 0.5 * settings.slicing.first_layer_height_mm;
  const Regions first = unite(sliceMesh(mesh, {cut_mm}, progress).front().contours);
  if (hasRaft(settings)) return first.empty() ? Regions() : raftArea(first, adhesion.raft);
  return makeBrim(first, adhesion.brim, pitchOfBrim(settings), bed).area;
}

}  // namespace lamina
