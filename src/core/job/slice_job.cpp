// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/slice_job.hpp"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/annotations/words_of_dialect.hpp"
#include "job/cooled_part.hpp"
#include "job/first_layer_heat.hpp"
#include "job/flow_control.hpp"
#include "job/joint_program.hpp"
#include "job/laps.hpp"
#include "job/modes/automatic_planning.hpp"
#include "job/modes/part_slicing.hpp"
#include "job/part/belt_travels.hpp"
#include "job/passages/passage_check.hpp"
#include "job/run_changes.hpp"
#include "job/settings_of_language.hpp"
#include "job/slice_run.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/job/annotations/program_annotations.hpp"
#include "lamina/job/annotations/progress_marks.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/planning/hooks/hooks.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "lamina/planning/tools/tool_heating.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// What the program says at its start beyond the start code.
std::string accelerations(const JobSettings& settings) {
  if (!settings.program.states_accelerations) return "";
  const std::string words = gcodeDialects().find(settings.program.dialect).accelerations;
  if (words.empty())
    throw InvalidConfig("program.accelerations is true with program.dialect '" + settings.program.dialect +
                        "', which has no word for it; expected false");
  return "\n" + dialectLine(words, {{"deposit", std::llround(settings.motion.acceleration_mm_s2)},
                                    {"travel", std::llround(settings.motion.travel_acceleration_mm_s2)}});
}

/// The code that heats a printer and lets it go is none that a machining control takes.
ProgramSettings codeFor(ProgramSettings program, const std::optional<JointProgram>& joint_program) {
  const ProgramSettings of_printers;
  const bool is_five_axis = joint_program && program.five_axis.dialect != FiveAxisDialect::Generic;
  // By G28 grbl does not home: it goes straight to a stored place.
  const bool is_linear = !joint_program && !gcodeDialects().find(program.dialect).has_heaters;
  if (!is_five_axis && !is_linear) return program;
  if (program.start_code == of_printers.start_code)
    program.start_code = is_linear ? "G21\nG90\nG0 {lift_axis}5" : "";
  if (program.end_code == of_printers.end_code)
    program.end_code = is_linear ? "G91\nG0 {lift_axis}5\nG90" : "";
  return program;
}

/// What a language made of the program, for notes.
std::vector<std::string> notesOf(const RobotWriting& writing) {
  std::vector<std::string> notes;
  const SpeedRounding& speeds = writing.speeds;
  char note[200];
  if (speeds.motions > 0) {
    std::snprintf(note, sizeof note,
                  "%zu motions have rounded speeds, at most by %.2f %%: %.4g mm/s is written as %.4g mm/s",
                  speeds.motions, 100.0 * speeds.greatest_share, speeds.feed_mm_s, speeds.written_mm_s);
    notes.emplace_back(note);
  }
  for (const RobotLevel& level : writing.unstated)
    notes.push_back("robot_program.levels leads '" + level.name + "' to output " +
                    std::to_string(level.output) +
                    ", which stays at 0: no path states that value (levels.values)");
  if (writing.files.size() > 1)
    notes.push_back("the program takes " + std::to_string(writing.files.size()) + " files, '" +
                    writing.files[1] + "' to '" + writing.files.back() + "' beside the first");
  return notes;
}

/// What an earlier, longer program of that name left would be loaded with this one.
std::vector<std::string> olderFileNotes(const std::string& path, const std::vector<std::string>& names) {
  const std::vector<std::string> older = filesOfLongerProgram(path, names);
  if (older.empty()) return {};
  const std::string range = older.size() == 1
                                ? "'" + older.front() + "' beside the program is"
                                : "'" + older.front() + "' to '" + older.back() + "' beside the program are";
  return {range + " not of it: numbered on from its files, and written before"};
}

std::vector<std::string> rapidNotes(const std::string& output, const std::vector<std::string>& files,
                                    const PlacedToolpath& placed, const RapidSettings& settings) {
  std::vector<std::string> notes = olderFileNotes(output, files);
  const RobotMotion robot{placed.joints->model, placed.joints->path};
  std::string load = rapidLoadNote(settings, &robot);
  if (!load.empty()) notes.push_back(std::move(load));
  return notes;
}

/// What the summary says of what was written.
struct Writing {
  std::vector<std::string> notes;
  double passages_s = 0.0;  ///< time of a robot's ways beside the part
};

/// A robot's program, and its notes.
Writing writeRobot(const SliceJob& job, const PlacedToolpath& placed, const ProgramSettings& program,
                   const SliceSummary& summary) {
  Writing writing;
  try {
    writing.passages_s = clearPassageTime(job.output, placed, program, job.settings);
  } catch (const Unreachable& refusal) {
    rethrowForChoice(refusal, summary);
  }
  if (programRunner(job.output) == ProgramRunner::OtherRobot) {
    const RobotWriting robot = writeRobotFiles(job.output, placed, program.robot);
    writing.notes = olderFileNotes(job.output, robot.files);
    for (std::string& note : notesOf(robot)) writing.notes.push_back(std::move(note));
  } else {
    const std::vector<std::string> files = writeRapidFiles(job.output, placed, program.rapid);
    writing.notes = rapidNotes(job.output, files, placed, program.rapid);
  }
  return writing;
}

Writing write(const SliceJob& job, const BuildSpace& space, const SlicedPart& sliced,
              const std::optional<JointProgram>& joint_program) {
  if (job.output.empty()) return {};
  ProgramSettings program =
      startedFor(job.settings.planning.first_layer, codeFor(job.settings.program, joint_program));
  program.strategy = job.settings.planning.infill.strategy;
  if (joint_program && joint_program->needs_configurations)
    program.rapid.configuration = RapidConfiguration::Joints;
  program.rapid = rapidWithLoad(program);
  program.tool_offsets_mm = toolOffsets(job.settings.planning.tools);
  ProgramFrame frame(sliced.bed_from_part);
  frame.program_from_bed = space.program_from_bed;
  ProgramAnnotations annotations;
  if (isGcodeFile(job.output)) {
    annotations = annotationsOf(sliced.toolpath, job.settings);
    program.start_code += accelerations(job.settings);
  }
  if (!joint_program) {
    writeOutput(job.output, {sliced.toolpath, frame}, program, annotations);
    return {};
  }
  const PlacedToolpath placed{joint_program->toolpath, frame,
                              ProgramJoints{*joint_program->model, joint_program->joints}};
  if (isRobotFile(job.output)) return writeRobot(job, placed, program, sliced.summary);
  writeOutput(job.output, placed, program, annotations);
  return {};
}

/// Of the toolpath as it is written: with leads, ways to where the nozzle waits, and beads cut short.
void addLengths(SlicedPart& sliced) {
  const ToolpathTotals sums = totals(sliced.toolpath);
  sliced.summary.deposition_mm = sums.deposition_mm;
  sliced.summary.travel_mm = sums.travel_mm;
  sliced.summary.deposited_mm3 = sums.deposited_mm3;
}

/// Within the limits of the joints, where they are led.
void addTime(SlicedPart& sliced, const MotionLimits& limits,
             const std::optional<JointProgram>& joint_program) {
  if (!joint_program || !joint_program->time) {
    sliced.summary.estimated_time_s = estimateTime(sliced.toolpath, limits).total_s;
    return;
  }
  sliced.summary.estimated_time_s = joint_program->time->total_s;
  sliced.summary.slow_bead_share = joint_program->time->slow_bead_share;
}

/// Whether the nozzle waits beside the part for an operator or a tool's temperature.
bool waitsAside(const JobSettings& settings, const std::vector<Tool>& tools) {
  return tools.size() > 1 || !settings.pauses.at_layers.empty() || !settings.pauses.at_heights_mm.empty();
}

/// Temperatures of tools, pauses, and code of the user's own.
void hookPart(SlicedPart& sliced, const JobSettings& settings, const BuildSpace& space) {
  HookSite site;
  site.bed_from_part = sliced.bed_from_part;
  site.program_from_bed = space.program_from_bed;
  site.nozzle_temperature_c = settings.program.nozzle_temperature_c;
  site.bed_temperature_c = settings.program.bed_temperature_c;
  site.limits = settings.motion;
  const std::vector<Tool> tools = toolsOf(settings.planning.tools);
  CoolingSettings parking = settings.cooling;
  if (waitsAside(settings, tools)) parking = reachableParking(sliced, parking, space);
  if (parking.park != settings.cooling.park)
    sliced.summary.notes.emplace_back(
        "the nozzle waits for tools and in pauses over where it is: cooling.park is out of the machine's "
        "reach");
  addToolHeating(sliced.toolpath, tools, {site.nozzle_temperature_c, site.limits, parking});
  addPauses(sliced.toolpath, settings.pauses, parking, site);
  addHooks(sliced.toolpath, settings.hooks, site);
}

void leadForward(SlicedPart& sliced, const JobSettings& settings, const BuildSpace& space) {
  std::optional<double> scan_clearance_mm;
  if (settings.scan.every_layers > 0) scan_clearance_mm = settings.scan.clearance_mm;
  keepBeltForward(sliced.toolpath, space, sliced.bed_from_part, settings.motion, scan_clearance_mm);
}

std::optional<JointProgram> jointProgramOf(const SliceJob& job, const BuildSpace& space, SlicedPart& sliced,
                                           Progress& progress) {
  try {
    return planJointProgram(job, space, sliced, progress);
  } catch (const Unreachable& refusal) {
    rethrowForChoice(refusal, sliced.summary);
  }
}

/// @param refused  what `auto` need not try
SliceFunction slicingWithout(std::vector<ModeCandidate> refused) {
  return [refused = std::move(refused)](const SliceJob& job, const BuildSpace& space, Progress& progress) {
    Laps laps;
    SourcePart source = readSource(job, progress);
    const double read_s = laps.lap();
    SlicedPart sliced = sliceSource(std::move(source), job, space, progress, refused);
    sliced.summary.read_s = read_s;
    return sliced;
  };
}

/// Choice after choice, until the machine can run what was chosen.
SlicedPart runChoosing(const BuildSpace& space, const SliceJob& job, Progress& progress) {
  Laps whole;
  for (std::vector<ModeCandidate> refused;;) {
    try {
      SlicedPart sliced = runIn(space, job, slicingWithout(refused), progress);
      sliced.summary.wall_s = whole.lap();
      return sliced;
    } catch (const ChoiceRefused& refusal) {
      refused = refusal.refused();
    }
  }
}

}  // namespace

SlicedPart runIn(const BuildSpace& space, const SliceJob& job, const SliceFunction& slice,
                 Progress& progress) {
  Laps whole;
  validate(job.settings);
  if (!job.output.empty()) outputWriterFor(job.output);
  requireWordsOfDialect(job.output, job.settings);
  requireProgramFor(job, space);
  requireSettingsOfLanguage(job);
  requireApart({job.output},
               {job.part, job.settings.machine.urdf, job.settings.conformal.base, job.settings.modifiers,
                job.settings.slicing.heights_file, job.settings.volumetric.target_file});
  requireWritableFile(job.output);
  requireToolAxisFor(job, space);
  Laps laps;
  progress.report("read", 0.0);
  SlicedPart sliced = slice(job, space, progress);
  changeRunsOf(sliced, job.settings, space);
  limitFlowOf(sliced, job.settings, progress);
  leadForward(sliced, job.settings, space);
  coolPart(sliced, job, space, progress);
  finishFlowOf(sliced, job.settings, progress);
  stateLevels(sliced.toolpath, job.settings.runs.levels);
  addHeatAfterFirstLayer(sliced.toolpath, job.settings.planning.first_layer, job.settings.program,
                         job.settings.plate.order);
  hookPart(sliced, job.settings, space);
  // Once more, for the ways to where the nozzle waits.
  leadForward(sliced, job.settings, space);
  if (job.settings.program.states_progress && isGcodeFile(job.output))
    addProgressMarks(sliced.toolpath, job.settings.program.dialect, job.settings.motion);
  const std::optional<JointProgram> joint_program = jointProgramOf(job, space, sliced, progress);
  sliced.summary.plan_s = laps.lap() - sliced.summary.read_s - sliced.summary.slice_s;
  progress.report("write", 0.0);
  throwIfCancelled(progress, "write");
  // The figures are walks along the whole toolpath by one thread; they refuse nothing that was planned.
  Writing writing;
  inParallel(
      [&] {
        addLengths(sliced);
        addTime(sliced, job.settings.motion, joint_program);
      },
      [&] { writing = write(job, space, sliced, joint_program); });
  if (joint_program && joint_program->time) sliced.summary.estimated_time_s += writing.passages_s;
  if (sliced.summary.slow_bead_share < 0.0) addNoteOnTipTime(sliced, job, space);
  sliced.summary.notes.insert(sliced.summary.notes.end(), writing.notes.begin(), writing.notes.end());
  if (std::string note = noteOnOtherLanguages(job); !note.empty())
    sliced.summary.notes.push_back(std::move(note));
  sliced.summary.write_s = laps.lap();
  sliced.summary.wall_s = whole.lap();
  sliced.summary.peak_memory_mb = peakMemory();
  return sliced;
}

SlicedPart runSliceJob(const SliceJob& job, Progress& progress) {
  validate(job.settings);
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  const SlicingSettings& slicing = job.settings.slicing;
  if (slicing.mode != kAutoMode || slicing.plane.angle_deg != 0.0) return runChoosing(space, job, progress);
  SliceJob inclined = job;
  inclined.settings.slicing.plane = planeOfHead(space);
  return runChoosing(space, inclined, progress);
}

SlicedPart runLevelSliceJob(SliceJob job, Progress& progress) {
  job.settings.slicing.plane = {};
  job.settings.slicing.mode = "planar";
  validate(job.settings);
  return runIn(withUprightHead(buildSpaceOf(job.settings.machine)), job, slicingWithout({}), progress);
}

}  // namespace lamina
