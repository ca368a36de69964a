// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

enum class Duration { UntilStopped, OneJob };

struct EmulateArguments {
  EmulatedPorts ports;
  double speed_up = 1.0;
  std::vector<std::string> faults;
  std::vector<std::string> settings;
  std::string record;
  Duration duration = Duration::UntilStopped;
};

EmulatedSettings settingsFrom(const EmulateArguments& arguments) {
  EmulatedSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("emulator.speed_up", numberText(arguments.speed_up));
  for (const SettingText& setting : overridesFrom(arguments.settings)) schema.set(setting.key, setting.text);
  return settings;
}

/// Writes what was run: lines of a program as they are, what has no number of its own as a comment.
EmulatedObserver recorder(const std::shared_ptr<AtomicFile>& file) {
  if (!file) return {};
  return {[file](const ExecutedLine& line) {
            const bool is_program = line.number && line.command.compare(0, 4, "M110") != 0;
            file->write((is_program ? "" : "; ") + line.command + "\n");
          },
          {}};
}

void printPorts(const EmulatedMachine& machine, OutputFormat format) {
  std::FILE* const where = format == OutputFormat::Json ? stderr : stdout;
  std::fprintf(where, "pseudo-terminal %s\n", machine.pty().c_str());
  if (machine.tcpPort() != 0) std::fprintf(where, "tcp:127.0.0.1:%d\n", machine.tcpPort());
  std::fflush(where);
}

/// Waits for Ctrl-C or SIGTERM; with OneJob also until lines were run and nothing has happened for a while.
void waitForEnd(const EmulatedMachine& machine, Duration duration) {
  constexpr std::chrono::milliseconds kPoll{50};
  constexpr int kQuietPolls = 100;  // longer than a host waits before it asks again
  const TerminalProgress signals;
  std::uint64_t lines = 0;
  for (int quiet = 0; !signals.isCancelled();) {
    std::this_thread::sleep_for(kPoll);
    const std::uint64_t lines_now = machine.counts().lines_run;
    quiet = lines_now == lines && lines > 0 && machine.isIdle() ? quiet + 1 : 0;
    lines = lines_now;
    if (duration == Duration::OneJob && quiet >= kQuietPolls) return;
  }
}

void print(const EmulatedCounts& counts, OutputFormat format) {
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {
        {"lines_run", counts.lines_run},     {"lines_refused", counts.lines_refused},
        {"bytes_lost", counts.bytes_lost},   {"faults", counts.faults},
        {"starvations", counts.starvations}, {"machine_time_s", counts.machine_time_s}};
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf("ran %llu lines in %.1f s of machine time, refused %llu, %llu faults\n",
              static_cast<unsigned long long>(counts.lines_run), counts.machine_time_s,
              static_cast<unsigned long long>(counts.lines_refused),
              static_cast<unsigned long long>(counts.faults));
}

void runEmulate(const EmulateArguments& arguments, OutputFormat format) {
  std::vector<Fault> faults;
  for (const std::string& text : arguments.faults) faults.push_back(faultFromText(text));
  std::shared_ptr<AtomicFile> record;
  if (!arguments.record.empty()) record = std::make_shared<AtomicFile>(arguments.record);
  EmulatedCounts counts;
  {
    const EmulatedMachine machine(settingsFrom(arguments), faults, arguments.ports, recorder(record));
    printPorts(machine, format);
    waitForEnd(machine, arguments.duration);
    counts = machine.counts();
  }
  if (record) record->commit();
  print(counts, format);
}

}  // namespace

void addEmulate(CLI::App& app, Chosen& chosen) {
  CLI::App* command = app.add_subcommand(
      "emulate", "Emulate a machine with Marlin firmware on a pseudo-terminal and a TCP port");
  auto arguments = std::make_shared<EmulateArguments>();
  command->add_option("--pty", arguments->ports.pty_link,
                      "stable path to make as a link to the pseudo-terminal");
  command->add_option("--tcp", arguments->ports.tcp_port,
                      "TCP port on the loopback interface; 0 for any free one");
  command
      ->add_option("--speed-up", arguments->speed_up, "machine time per wall time; 0 for as fast as possible")
      ->capture_default_str();
  command->add_option(
      "--fault", arguments->faults,
      "kind=rate (0.01) or kind=line,line; kinds: lost_ok, delayed_ok, lost_line, corrupted_line, "
      "spurious_resend, silence, disconnect, reset; may be repeated");
  command->add_option("--record", arguments->record, "file for the lines that were run");
  command->add_option("--set", arguments->settings,
                      "key=value, one of emulator.* or motion.*; may be repeated");
  command->add_flag_callback(
      "--once", [arguments] { arguments->duration = Duration::OneJob; }, "end when one job has been run");
  addJsonFlag(*command, chosen);
  command->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { runEmulate(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
