// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/run_changes.hpp"

#include <string>

#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

void noteCount(SlicedPart& sliced, std::size_t count, const std::string& what) {
  if (count > 0) sliced.summary.notes.push_back(std::to_string(count) + " " + what);
}

void noteLeads(SlicedPart& sliced, const LeadCount& leads) {
  noteCount(sliced, leads.added, "leads are added to runs");
  noteCount(sliced, leads.shortened, "of these leads are shortened to the room that there is");
  noteCount(sliced, leads.left_out, "leads are left out for want of room (lead.least_mm)");
}

}  // namespace

void changeRunsOf(SlicedPart& sliced, const JobSettings& settings, const BuildSpace& space) {
  const BeadRunSettings& runs = settings.runs;
  Toolpath& toolpath = sliced.toolpath;
  const std::size_t started = spreadStarts(toolpath, runs.starts);
  const std::size_t overlapped = overlapEnds(toolpath, runs.lead);
  const EndCount ends = addEnds(toolpath, runs.lead, runs.entry);
  const std::size_t woven = weave(toolpath, runs.weave, settings.motion);
  noteCount(sliced, started, "closed runs start elsewhere than planned (starts.rule)");
  noteCount(sliced, overlapped,
            runs.lead.overlap_mm > 0.0 ? "closed runs go on over their start (lead.overlap_mm)"
                                       : "closed runs end before their start (lead.overlap_mm)");
  noteLeads(sliced, ends.leads);
  noteCount(sliced, woven, "paths are woven (weave.kind)");
  noteCount(sliced, ends.entries, "ways to and from runs are straight (entry.distance_mm)");
  noteCount(sliced, ends.without_tangent,
            "of these ways go along the tool axis for want of room along the run (entry.direction)");
  if (started + overlapped + ends.leads.added + woven + ends.entries == 0) return;
  // Heads that turn are judged by their joints once these are planned.
  if (canTurnToolAxis(space))
    requireTipsReachable(toolpath, sliced.bed_from_part, space);
  else
    requireReachable(toolpath, sliced.bed_from_part, space, toolOffsets(settings.planning.tools));
}

}  // namespace lamina
