// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/flow_control.hpp"

#include <cstdio>
#include <string>

#include "job/annotations/words_of_dialect.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/flow/flow.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/flow/role_advances.hpp"

namespace lamina {
namespace {

void makeUpForLag(SlicedPart& sliced, const JobSettings& settings) {
  const FeedForward result =
      feedForward(sliced.toolpath, settings.flow, settings.motion, settings.program.flow);
  if (result.runs == 0) return;
  char note[160];
  std::snprintf(note, sizeof note,
                "%zu runs are pushed ahead of the flow; %.4g mm3 along %.4g mm could not be made up for",
                result.runs, result.unmet_mm3, result.unmet_mm);
  sliced.summary.notes.emplace_back(note);
}

/// Volumes of the summary are of beads as planned.
void noteFlowFactor(SlicedPart& sliced, double factor) {
  if (factor == 1.0) return;
  const double beads_cm3 = totals(sliced.toolpath).deposited_mm3 / 1e3;
  char note[128];
  std::snprintf(note, sizeof note, "program.flow %.4g feeds %.2f cm3 for the %.2f cm3 of the beads", factor,
                factor * beads_cm3, beads_cm3);
  sliced.summary.notes.emplace_back(note);
}

/// With the word of the dialect that the program is written in.
FlowSettings withWord(FlowSettings flow, const std::string& dialect) {
  if (flow.advance_word != AdvanceWord::Dialect) return flow;
  SettingsSchema schema;
  describe(schema, flow);
  schema.set("flow.advance_word", gcodeDialects().find(dialect).advance);
  return flow;
}

/// A drop is no bead whose flow could lag.
void addAdvanceOf(SlicedPart& sliced, const JobSettings& settings) {
  const std::string& strategy = settings.planning.infill.strategy;
  if (!hasAdvance(settings.flow)) return;
  if (depositsDrops(strategy))
    sliced.summary.notes.push_back("flow.advance_s has no effect with infill.strategy '" + strategy + "'");
  else if (hasWordForAdvance(settings))
    addAdvance(sliced.toolpath, withWord(settings.flow, settings.program.dialect));
  else
    sliced.summary.notes.push_back("flow.advance_s has no effect with program.dialect '" +
                                   settings.program.dialect + "', which has no word for it");
}

}  // namespace

void limitFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress) {
  const std::size_t slowed = limitFlow(sliced.toolpath, settings.flow, settings.program.flow, progress);
  if (slowed > 0)
    sliced.summary.notes.push_back(std::to_string(slowed) +
                                   " paths are slowed down to keep the flow within its limits");
}

void finishFlowOf(SlicedPart& sliced, const JobSettings& settings, Progress& progress) {
  const Coasting coasting = coast(sliced.toolpath, settings.flow, progress);
  if (coasting.runs > 0) {
    char note[96];
    std::snprintf(note, sizeof note, "%zu runs end without pushing, by %.4g mm3 in all", coasting.runs,
                  coasting.left_mm3);
    sliced.summary.notes.emplace_back(note);
  }
  makeUpForLag(sliced, settings);
  noteFlowFactor(sliced, settings.program.flow);
  addAdvanceOf(sliced, settings);
}

}  // namespace lamina
