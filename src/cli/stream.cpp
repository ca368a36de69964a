// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "arguments/correction_options.hpp"
#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/gcode_rewrite/dry_run.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "output/live_input.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// What is to be done with the job of the port.
enum class StreamMode { Begin, Resume, ShowProgress };

struct StreamArguments {
  std::string program;
  MachinePort port;
  std::vector<std::string> settings;
  CorrectionFiles corrections;
  StreamMode mode = StreamMode::Begin;
  bool is_live = false;
  bool is_dry = false;
};

/// What is set on the command line.
struct StreamCommandSettings {
  StreamSettings stream;
  LoopSettings feeding;
  DryRunSettings dry;
};

/// A program as it is sent; in a folder of its own where it is written for that.
struct ProgramToSend {
  std::unique_ptr<const ScratchFolder> folder;
  StreamableProgram program;
};

StreamCommandSettings settingsFrom(const StreamArguments& arguments) {
  StreamCommandSettings settings;
  SettingsSchema schema;
  describe(schema, settings.stream);
  if (!arguments.corrections.maps.empty()) describeFeeding(schema, settings.feeding);
  if (arguments.is_dry) describe(schema, settings.dry);
  for (const SettingText& setting : overridesFrom(arguments.settings)) schema.set(setting.key, setting.text);
  requireConsistent(settings.stream);
  return settings;
}

/// The program as it is sent: what cannot be corrected, or would be misread once it is, is refused here.
StreamableProgram programFrom(const StreamArguments& arguments, const StreamCommandSettings& settings) {
  if (arguments.corrections.maps.empty()) {
    if (!arguments.corrections.toolpath.empty())
      throw InvalidInput("--toolpath is given without --corrections; expected both, or neither");
    return StreamableProgram::fromFile(arguments.program, settings.stream);
  }
  const auto planned =
      StreamableProgram::fromText(arguments.program, readFile(arguments.program), settings.stream);
  const PlannedCorrection correction =
      correctionFrom(arguments.corrections, settings.feeding, sha256Of(planned));
  return programByMaps(planned, arguments.corrections, correction, settings.stream);
}

/// A dry run leaves out what its process would do, which is reported.
ProgramToSend programToSend(const StreamArguments& arguments, const StreamCommandSettings& settings) {
  StreamableProgram asked = programFrom(arguments, settings);
  if (!arguments.is_dry) return {nullptr, std::move(asked)};
  auto folder = std::make_unique<const ScratchFolder>();
  const std::string path = folder->path() + "/dry.gcode";
  const DryRunReport report = writeDryRun(*asked.openText(), path, settings.dry);
  std::fprintf(stderr, "%s\n", toText(report).c_str());
  return {std::move(folder), StreamableProgram::fromFile(path, settings.stream)};
}

JobStart startOf(const StreamArguments& arguments) {
  return arguments.mode == StreamMode::Resume ? JobStart::Resume : JobStart::New;
}

/// Streams to the end, or to the safe stop after Ctrl-C.
StreamStatus streamWhole(const StreamableProgram& program, const StreamSettings& settings,
                         const StreamArguments& arguments, const StreamJournal& journal) {
  constexpr double kPollInterval = 0.1;  // s
  TerminalProgress progress;
  bool is_warned = false;
  const auto report = [&](const StreamStatus& status) {
    if (!status.warning.empty() && !std::exchange(is_warned, true))
      std::fprintf(stderr, "warning: %s\n", status.warning.c_str());
    progress.report(toString(status.state),
                    static_cast<double>(status.lines_acknowledged) / static_cast<double>(status.lines_total));
  };
  StreamSession session(program, settings, arguments.port, report, {{}, journal, startOf(arguments)});
  LiveInput input;
  while (!session.waitFor(kPollInterval)) {
    if (arguments.is_live) input.follow(session);
    if (arguments.is_live || progress.isCancelled()) input.tell(session);
    if (progress.isCancelled()) session.abort({ErrorCode::Cancelled, "stopped by the user"});
  }
  return session.status();
}

void printStarvation(const Starvation& starvation) {
  const auto count = static_cast<unsigned long long>(starvation.count);
  if (starvation.source == StarvationSource::Nobody) {
    std::printf("starved: not reported by this firmware\n");
  } else if (starvation.count > 0 && starvation.source == StarvationSource::Machine) {
    std::printf("starved: %llu times by the machine's own count, which gives no lengths\n", count);
  } else if (starvation.count > 0) {
    std::printf("starved: %llu times, the longest %.2f s before line %llu\n", count, starvation.longest_s,
                static_cast<unsigned long long>(starvation.line));
  }
}

/// A figure that the machine does not report is null.
nlohmann::ordered_json starvationJson(const Starvation& starvation) {
  nlohmann::ordered_json json = {
      {"starvations", nullptr}, {"longest_starvation_s", nullptr}, {"longest_starvation_line", nullptr}};
  if (starvation.source != StarvationSource::Nobody) json["starvations"] = starvation.count;
  if (starvation.source == StarvationSource::Streamer) {
    json["longest_starvation_s"] = starvation.longest_s;
    json["longest_starvation_line"] = starvation.line;
  }
  return json;
}

void print(const StreamStatus& status, double duration_s, OutputFormat format) {
  const double lines_per_s =
      duration_s > 0.0 ? static_cast<double>(status.lines_acknowledged) / duration_s : 0.0;
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"lines", status.lines_total},
                                   {"acknowledged", status.lines_acknowledged},
                                   {"resends", status.resends},
                                   {"probes", status.probes},
                                   {"duration_s", duration_s},
                                   {"lines_per_s", lines_per_s},
                                   {"firmware", status.firmware_name},
                                   {"not_done", status.commands_not_done},
                                   {"first_not_done", status.first_not_done},
                                   {"warning", status.warning}};
    json.update(starvationJson(status.starvation));
    json["state"] = toString(status.state);
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf("%s: %llu lines in %.1f s (%.0f per second), %llu resends\n", toString(status.state),
              static_cast<unsigned long long>(status.lines_acknowledged), duration_s, lines_per_s,
              static_cast<unsigned long long>(status.resends));
  if (!status.firmware_name.empty()) std::printf("firmware: %s\n", status.firmware_name.c_str());
  if (status.commands_not_done > 0)
    std::printf("not done: %llu commands, the first with \"%s\"\n",
                static_cast<unsigned long long>(status.commands_not_done), status.first_not_done.c_str());
  printStarvation(status.starvation);
}

Counts countsOf(const StreamStatus& status) {
  return {{"lines", status.lines_total},
          {"acknowledged", status.lines_acknowledged},
          {"resends", status.resends},
          {"probes", status.probes},
          {"not_done", status.commands_not_done}};
}

nlohmann::ordered_json originJson(const ProgramOrigin& origin) {
  nlohmann::ordered_json maps = nlohmann::ordered_json::array();
  for (const AppliedMap& map : origin.maps) maps.push_back({{"layer", map.layer}, {"digest", map.digest}});
  return {{"program_sha256", origin.program_sha256}, {"maps", maps}};
}

/// What the progress file of the port says; nothing is sent.
void showProgress(const std::string& journal, OutputFormat format) {
  const JournalledProgress known = readJournal(journal);
  if (format == OutputFormat::Text) {
    std::printf("%s\n", describeProgress(known).c_str());
    return;
  }
  nlohmann::ordered_json json = {{"program", known.job.program},
                                 {"program_sha256", known.job.program_sha256},
                                 {"port", known.job.port},
                                 {"firmware", known.job.firmware_name},
                                 {"uploaded_as", known.job.uploaded_as},
                                 {"lines", known.job.lines_total},
                                 {"taken_through", known.progress.taken_through},
                                 {"sent_through", known.progress.sent_through},
                                 {"layer", known.progress.layer},
                                 {"state", toString(known.progress.state)},
                                 {"time_ms", known.progress.time_ms}};
  if (known.job.origin) json["corrected_from"] = originJson(*known.job.origin);
  std::printf("%s\n", json.dump().c_str());
}

void runStream(const StreamArguments& arguments, Chosen& chosen) {
  const StreamCommandSettings settings = settingsFrom(arguments);
  const std::string journal_path = journalPath(settings.stream, arguments.port.name);
  if (arguments.mode == StreamMode::ShowProgress) return showProgress(journal_path, chosen.format);
  const ProgramToSend sent = programToSend(arguments, settings);
  const SteadyClock clock;
  const double start = clock.now();
  // A dry run leaves the progress of a job that was cut off alone.
  StreamJournal journal;
  if (!arguments.is_dry) journal = journalFor(journal_path, sent.program, arguments.port, startOf(arguments));
  const StreamStatus status = streamWhole(sent.program, settings.stream, arguments, journal);
  chosen.counts = countsOf(status);
  throwIfFailed(status);
  print(status, clock.now() - start, chosen.format);
}

}  // namespace

void addStream(CLI::App& app, Chosen& chosen) {
  CLI::App* command = app.add_subcommand("stream", "Stream a G-code program to a machine");
  auto arguments = std::make_shared<StreamArguments>();
  command->add_option("program", arguments->program, "G-code file")->required();
  command
      ->add_option("--port,-p", arguments->port.name,
                   "serial port such as /dev/ttyUSB0, tcp:host:port, or http://host:port")
      ->required();
  command->add_option("--baud,-b", arguments->port.baud, "baud rate of a serial port")->capture_default_str();
  command->add_option(
      "--set", arguments->settings,
      "key=value, one of stream.*, with --corrections also of loop.*, with --dry of dry.*; may be "
      "repeated");
  command->add_option(
      "--corrections", arguments->corrections.maps,
      "correction map (.csv) or folder of maps, by which the program is corrected as lamina correct "
      "does");
  addToolpathOption(*command, arguments->corrections);
  command->add_flag("--live", arguments->is_live,
                    "follow commands on the standard input, a line each: feed 90, flow 105, babystep -0.05, "
                    "cancel_part 2, pause_at_layer 12, rapid 50, spindle 80, power 80, pause, resume");
  auto* const dry = command->add_flag(
      "--dry", arguments->is_dry,
      "run the program with nothing of its process on: no extrusion, heat, fan, laser or change of tool");
  auto* const resume = command->add_flag_callback(
      "--resume", [arguments] { arguments->mode = StreamMode::Resume; },
      "go on with the job whose streaming was cut off, on a machine that has lived on; at a print server, "
      "follow the print that goes on there");
  resume->excludes(dry);
  command
      ->add_flag_callback(
          "--progress", [arguments] { arguments->mode = StreamMode::ShowProgress; },
          "print what is known of the port's last job, and send nothing")
      ->excludes(resume);
  addJsonFlag(*command, chosen);
  command->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { runStream(*arguments, chosen); }; });
}

}  // namespace lamina::cli
