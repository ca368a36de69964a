// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/resume/remaining_program.hpp"
#include "lamina/streaming/resume/resume_point.hpp"
#include "robot/resume_robot.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina resume` as it was typed.
struct ResumeArguments {
  std::string program;
  std::string output;
  std::string port;  ///< whose last job is to be reported; empty to write the rest
  std::optional<std::uint64_t> line;
  std::string file;  ///< of a robot's program, that has the line
  std::optional<std::int32_t> layer;
  std::optional<double> height_mm;
  std::optional<double> nozzle_height_mm;
  std::string machine;  ///< of a robot's program; empty for that of the settings
  std::vector<std::string> settings;
};

std::uint64_t lineFrom(const ResumeArguments& arguments, const StreamableProgram& program) {
  if (arguments.line) return *arguments.line;
  if (arguments.layer) return firstLineOfLayer(program, *arguments.layer);
  if (arguments.height_mm) return firstLineAtHeight(program, *arguments.height_mm);
  throw InvalidInput(
      "where to go on is not given; expected --from-line, --from-layer or --from-height (lamina resume "
      "--port reports what is known)");
}

/// What is known of the port's last job, and from where it could be gone on with; nothing is written.
void showOffer(const ResumeArguments& arguments, OutputFormat format) {
  StreamSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : overridesFrom(arguments.settings)) schema.set(setting.key, setting.text);
  const JournalledProgress known = readJournal(journalPath(settings, arguments.port));
  const auto program = StreamableProgram::fromFile(arguments.program);
  const std::string digest = sha256Of(program);
  if (known.job.origin && known.job.origin->program_sha256 == digest)
    throw InvalidProgram(
        arguments.program +
        " was corrected for the port's last job; expected what lamina correct makes of it by "
        "the same maps; known is: " +
        describeProgress(known));
  if (known.job.program_sha256 != digest)
    throw InvalidProgram(
        arguments.program +
        " is not the program of the port's last job, or was changed; known is: " + describeProgress(known));
  const ResumePoint point = resumePointAfter(program, known.progress.taken_through);
  if (format == OutputFormat::Text) {
    std::printf("%s\n%s", describeProgress(known).c_str(), adviceFor(point).c_str());
    return;
  }
  nlohmann::ordered_json json = {{"known", describeProgress(known)},
                                 {"from_line", point.line},
                                 {"from_layer", nullptr},
                                 {"from_height", point.height_mm}};
  if (point.layer) json["from_layer"] = *point.layer;
  std::printf("%s\n", json.dump().c_str());
}

void resumeOnRobot(const ResumeArguments& arguments, OutputFormat format) {
  if (arguments.nozzle_height_mm)
    throw InvalidInput("--nozzle-height is given with a program in " + robotLanguageName(arguments.program) +
                       "; expected none: a robot knows where its nozzle is");
  resumeRobot({arguments.program,
               arguments.output,
               arguments.machine,
               arguments.line,
               arguments.file,
               arguments.layer,
               arguments.height_mm,
               {"", arguments.settings}},
              format);
}

void runResume(const ResumeArguments& arguments, OutputFormat format) {
  if (!arguments.port.empty()) return showOffer(arguments, format);
  if (isRobotFile(arguments.program)) return resumeOnRobot(arguments, format);
  if (!arguments.file.empty())
    throw InvalidInput("--of-file is " + arguments.file + " with " + arguments.program +
                       "; expected it with the program of a robot alone");
  if (!arguments.machine.empty())
    throw InvalidInput("--machine is " + arguments.machine + " with " + arguments.program +
                       "; expected it with the program of a robot alone");
  if (arguments.output.empty()) throw InvalidInput("--output is not given; expected a file for the rest");
  if (!arguments.nozzle_height_mm)
    throw InvalidInput(
        "--nozzle-height is not given: z is not homed onto a part, so that the nozzle's height must be "
        "measured; expected its z [mm] above the bed when the rest begins");
  ResumeSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : overridesFrom(arguments.settings)) schema.set(setting.key, setting.text);
  const auto program = StreamableProgram::fromFile(arguments.program);
  const std::uint64_t line = lineFrom(arguments, program);
  AtomicFile file(arguments.output);
  const RemainingProgramNotes notes = writeRemaining(program, line, *arguments.nozzle_height_mm, settings,
                                                     [&](std::string_view piece) { file.write(piece); });
  file.commit();
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {
        {"from_line", line}, {"lines", program.lines()}, {"to_check", notes.to_check}};
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf("%s: from line %llu of %llu. Run it only if:\n", arguments.output.c_str(),
              static_cast<unsigned long long>(line), static_cast<unsigned long long>(program.lines()));
  for (const std::string& note : notes.to_check) std::printf("- %s\n", note.c_str());
}

}  // namespace

void addResume(CLI::App& app, Chosen& chosen) {
  CLI::App* command = app.add_subcommand(
      "resume", "Write the rest of a program, for a machine that has lost its position; sends nothing");
  auto arguments = std::make_shared<ResumeArguments>();
  command->add_option("program", arguments->program, "G-code file, or program of a robot")->required();
  auto* const output = command->add_option("-o,--output", arguments->output, "file for the rest");
  auto* const line = command->add_option("--from-line", arguments->line, "command to go on from, from 1")
                         ->check([](const std::string& text) {
                           return text.rfind('-', 0) == 0 ? text + "; expected 1 or more" : std::string();
                         });
  command->add_option("--of-file", arguments->file, "file of a robot's program that has the line, as PART_3")
      ->needs(line);
  auto* const layer =
      command->add_option("--from-layer", arguments->layer, "layer to go on from, as comments number them");
  auto* const height =
      command->add_option("--from-height", arguments->height_mm, "height to go on from [mm]");
  line->excludes(layer)->excludes(height);
  layer->excludes(height);
  command->add_option("--nozzle-height", arguments->nozzle_height_mm,
                      "z of the nozzle when the rest begins, as measured [mm]");
  command
      ->add_option("--port,-p", arguments->port,
                   "print what is known of that port's last job and from where it could be gone on with; "
                   "writes nothing")
      ->excludes(output)
      ->excludes(line)
      ->excludes(layer)
      ->excludes(height);
  command->add_option(
      "--set", arguments->settings,
      "key=value, one of resume.*, with --port one of stream.*, of a robot's program any of a "
      "job; may be repeated");
  command->add_option(
      "--machine", arguments->machine,
      "robot that runs the program: a profile, one of machine.name, or a file (.yaml, .urdf)");
  addJsonFlag(*command, chosen);
  command->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { runResume(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
