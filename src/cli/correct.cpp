// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/correction_options.hpp"
#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/program/corrected_toolpath.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/program/rapid/rapid_texts.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "lamina/program/robot/robot_writer.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina correct` as it was typed.
struct CorrectArguments {
  std::string program;
  CorrectionFiles corrections;
  std::string output;
  SettingOptions settings;
};

/// What is set on the command line.
struct CorrectSettings {
  LoopSettings feeding;
  RapidSettings rapid;
  RobotProgramSettings robot;
};

CorrectSettings settingsFrom(const CorrectArguments& arguments) {
  CorrectSettings settings;
  SettingsSchema schema;
  describeFeeding(schema, settings.feeding);
  const ProgramRunner runner = programRunner(arguments.program);
  if (runner == ProgramRunner::RapidRobot) describe(schema, settings.rapid);
  if (runner == ProgramRunner::OtherRobot) describe(schema, settings.robot);
  applySettings(schema, arguments.settings.config, overridesFrom(arguments.settings.assignments));
  return settings;
}

nlohmann::ordered_json mapsJson(const std::vector<FiledMap>& maps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const FiledMap& each : maps)
    json.push_back({{"layer", each.map.layer}, {"digest", digestOf(each.map)}});
  return json;
}

void print(const CorrectArguments& arguments, const PlannedCorrection& correction,
           const CorrectionReport& report, OutputFormat format) {
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {
        {"output", arguments.output},        {"toolpath_id", correction.planned.id},
        {"maps", mapsJson(correction.maps)}, {"corrected_lines", report.corrected_lines},
        {"added_lines", report.added_lines}, {"off_path_lines", report.off_path_lines},
        {"planned_mm", report.planned_mm},   {"corrected_mm", report.corrected_mm}};
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf(
      "%s: %zu lines corrected by %zu maps, %zu lines added; filament of these %.3f mm, planned %.3f mm\n",
      arguments.output.c_str(), report.corrected_lines, correction.maps.size(), report.added_lines,
      report.corrected_mm, report.planned_mm);
  if (report.off_path_lines > 0)
    std::printf("%zu lines deposit beside the toolpath and are as they were\n", report.off_path_lines);
}

double depositionTime(const Toolpath& toolpath) {
  double time_s = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        time_s += (path.points[end] - path.points[m]).norm() / path.feed_mm_s.at(end);
      }
    }
  return time_s;
}

void printTimes(const CorrectArguments& arguments, const PlannedCorrection& correction,
                const std::pair<double, double>& planned_and_corrected_s, OutputFormat format) {
  const auto& [planned_s, corrected_s] = planned_and_corrected_s;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"output", arguments.output},
                                         {"toolpath_id", correction.planned.id},
                                         {"maps", mapsJson(correction.maps)},
                                         {"planned_s", planned_s},
                                         {"corrected_s", corrected_s}};
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf("%s: corrected by %zu maps; deposits for %.3f s, planned %.3f s\n", arguments.output.c_str(),
              correction.maps.size(), corrected_s, planned_s);
}

/// In the language of the program, over the bed.
void writeCorrected(const CorrectArguments& arguments, const CorrectSettings& settings,
                    const Toolpath& corrected) {
  if (!isRapidFile(arguments.output)) {
    writeRobotFiles(arguments.output, corrected, settings.robot);
    return;
  }
  writeRapidFiles(arguments.output, {corrected, ProgramFrame(Eigen::Isometry3d::Identity())}, settings.rapid);
}

/// What the corrected program would state, before anything of it is on the disk.
StatedEquipment writtenEquipment(const CorrectArguments& arguments, const CorrectSettings& settings,
                                 const Toolpath& corrected) {
  const std::string name = std::filesystem::path(arguments.output).stem().string();
  const Eigen::Isometry3d over_bed = Eigen::Isometry3d::Identity();
  if (!isRapidFile(arguments.output)) {
    const RobotLanguage language = *robotLanguageOf(arguments.output);
    return readEquippedRobotProgram(robotProgram(corrected, over_bed, {language, name, settings.robot}), name)
        .equipment;
  }
  const RapidProgram program(corrected, over_bed, settings.rapid);
  return readEquippedRapid(RapidTexts(program).modules(), name).equipment;
}

std::string suffixOfFile(const std::string& path) { return std::filesystem::path(path).extension().string(); }

/// A robot's process runs at a steady rate: the amount is deposited by the time on the way.
void correctRobot(const CorrectArguments& arguments, CorrectSettings settings, OutputFormat format) {
  constexpr double kReadTolerance = 2e-3;  // mm: positions have three decimals at least
  const std::string language = robotLanguageName(arguments.program);
  if (suffixOfFile(arguments.output) != suffixOfFile(arguments.program))
    throw InvalidInput("the program is " + arguments.program + ", the output " + arguments.output +
                       "; expected a program in " + language + " of it, with the suffix " +
                       suffixOfFile(arguments.program));
  PlannedCorrection correction = correctionFrom(arguments.corrections, settings.feeding, {});
  EquippedToolpath read = isRapidFile(arguments.program) ? readEquippedRapidFile(arguments.program)
                                                         : readEquippedRobotProgramFile(arguments.program);
  requireSamePaths(read.toolpath, correction.planned.toolpath, kReadTolerance);
  correction.planned.toolpath = std::move(read.toolpath);
  const Toolpath& planned = correction.planned.toolpath;
  const Toolpath corrected =
      correctedToolpath(planned, ledMaps(correction), CorrectionWriting{}.split_change);
  const std::string keys = isRapidFile(arguments.program) ? "rapid.*" : "robot_program.*";
  // An axis that the program does not use is none to give a value.
  if (read.equipment.external.empty() && settings.rapid.external_axis == 0.0)
    settings.rapid.has_external_axis = false;
  requireSameEquipment(read.equipment, writtenEquipment(arguments, settings, corrected), arguments.program,
                       keys);
  writeCorrected(arguments, settings, corrected);
  std::fprintf(stderr,
               "warning: %s has neither approach nor retract, and the tool and work object of %s, not "
               "those of %s; "
               "expected both to be taken over by hand before it runs\n",
               arguments.output.c_str(), keys.c_str(), arguments.program.c_str());
  const std::string load = isRapidFile(arguments.output) ? rapidLoadNote(settings.rapid, nullptr) : "";
  if (!load.empty()) std::fprintf(stderr, "warning: %s: %s\n", arguments.output.c_str(), load.c_str());
  printTimes(arguments, correction, {depositionTime(planned), depositionTime(corrected)}, format);
}

void correct(const CorrectArguments& arguments, OutputFormat format) {
  requireApart({arguments.output}, {arguments.program, arguments.corrections.maps,
                                    arguments.corrections.toolpath, arguments.settings.config});
  const CorrectSettings settings = settingsFrom(arguments);
  if (isRobotFile(arguments.program)) return correctRobot(arguments, settings, format);
  const std::string program = readFile(arguments.program);
  // Only a record asks of which program its lines are.
  const bool is_recorded = recordedJob(arguments.corrections.maps).has_value();
  const PlannedCorrection correction =
      correctionFrom(arguments.corrections, settings.feeding,
                     is_recorded ? sha256Of(StreamableProgram::fromText(arguments.program, program)) : "");
  const CorrectedProgram corrected = correctedByMaps(arguments.program, program, correction);
  writeFile(arguments.output, corrected.text);
  print(arguments, correction, corrected.report, format);
}

}  // namespace

void addCorrect(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "correct", "Write a program corrected by the maps of the closed loop, to be looked at; sends nothing");
  const auto arguments = std::make_shared<CorrectArguments>();
  subcommand
      ->add_option("program", arguments->program,
                   "Program (.gcode), or program of a robot (.mod, .src, .ls, .jbi)")
      ->required();
  subcommand
      ->add_option("maps", arguments->corrections.maps,
                   "Correction map (.csv), or folder of maps as lamina estimate and the streamer write them")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "File for the corrected program")->required();
  addToolpathOption(*subcommand, arguments->corrections);
  addSettingOptions(*subcommand, arguments->settings,
                    "Settings (YAML) of the feeder: loop.*; of RAPID programs also rapid.*, of other robots' "
                    "robot_program.*");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { correct(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
