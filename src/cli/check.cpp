// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "arguments/machine_run.hpp"
#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/annotations/program_annotations.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/gcode/early_end.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "lamina/trajectory/nozzle_csv.hpp"
#include "lamina/verification/collision/fence_distance.hpp"
#include "lamina/verification/overhang/overhang.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr int kCannotRun = 2;       // 1 is that of a check that could not be made
constexpr std::size_t kShown = 10;  // of each kind, to people; --report and --json have all

/// The command line of `lamina check` as it was typed.
struct CheckArguments {
  MachineRunArguments run;
  std::string report;
  std::string trajectory;
  double rate_hz = NozzleTable().rate_hz;
  SettingOptions settings;
};

/// What was found, and the run in time if it can be run.
struct Checked {
  MachineCheck check;
  SingularBeads singular;
  std::optional<TimedRun> timed;
  RunTime time;                            ///< of that run
  std::optional<FenceDistance> fence;      ///< the nearest that a link comes to a body of the cell
  std::optional<OverhangTotals> overhang;  ///< of an arm's program, along its tool axes
  std::string overhang_unknown;            ///< why it was not looked at
  /// Of a program that was cut off: a warning, for what is there can be run or not.
  std::optional<Finding> early_end;
};

nlohmann::ordered_json toJson(const std::optional<FenceDistance>& fence) {
  if (!fence) return {};
  return {{"distance_mm", fence->distance_mm}, {"link", fence->link},    {"body", fence->body + 1},
          {"layer", fence->at.layer},          {"path", fence->at.path}, {"waypoint", fence->at.waypoint}};
}

std::vector<Finding> findingsOf(const MachineCheck& check) {
  std::vector<Finding> findings = check.faults;
  findings.insert(findings.end(), check.collisions.begin(), check.collisions.end());
  return findings;
}

std::size_t layersOf(const std::vector<Finding>& findings) {
  std::set<std::size_t> layers;
  for (const Finding& finding : findings) layers.insert(finding.at.layer);
  return layers.size();
}

nlohmann::ordered_json toJson(const Finding& finding) {
  return {{"layer", finding.at.layer},
          {"path", finding.at.path},
          {"waypoint", finding.at.waypoint},
          {"tip_mm", {finding.tip.x(), finding.tip.y(), finding.tip.z()}},
          {"line", finding.line > 0 ? nlohmann::ordered_json(finding.line) : nlohmann::ordered_json()},
          {"what", finding.what},
          {"reason", finding.reason}};
}

void printJson(const Checked& checked, const std::string& machine) {
  const MachineCheck& check = checked.check;
  nlohmann::ordered_json json = {{"machine", machine},
                                 {"waypoints", check.waypoints},
                                 {"faulty_waypoints", check.faults.size()},
                                 {"colliding_waypoints", check.collisions.size()},
                                 {"colliding_layers", layersOf(check.collisions)},
                                 {"rewinds", check.rewinds},
                                 {"unchecked", check.ignored},
                                 {"findings", nlohmann::ordered_json::array()}};
  json["time_s"] = nlohmann::ordered_json();
  json["slow_bead_share"] = nlohmann::ordered_json();
  if (checked.timed) {
    json["time_s"] = checked.time.total_s;
    json["slow_bead_share"] = checked.time.slow_bead_share;
  }
  json["unknown_way"] = check.unknown_way;
  json["nearest_body"] = toJson(checked.fence);
  json["overhang_mm"] = nlohmann::ordered_json();
  json["longest_overhang_mm"] = nlohmann::ordered_json();
  if (checked.overhang) {
    json["overhang_mm"] = checked.overhang->all.overhang_mm;
    json["longest_overhang_mm"] = checked.overhang->longest_overhang_mm;
  }
  json["singular_bead_share"] = checked.singular.share();
  json["least_singular_deg"] = checked.singular.least_deg;
  for (const Finding& finding : findingsOf(check)) json["findings"].push_back(toJson(finding));
  if (checked.early_end) json["findings"].push_back(toJson(*checked.early_end));
  std::printf("%s\n", json.dump(2).c_str());
}

void printSingular(const Checked& checked) {
  const SingularBeads& beads = checked.singular;
  if (beads.near == 0) return;
  const std::string line = beads.line > 0 ? "line " + std::to_string(beads.line) + ", " : "";
  std::printf("singularity %.1f %% of the bead's waypoints are near one%s, %.2f deg the nearest: %s%s\n",
              100.0 * beads.share(), checked.check.isClear() ? " and within the joints' limits" : "",
              beads.least_deg, line.c_str(), toText(beads.at).c_str());
}

/// What the tool axis leaves without support where a table is held, and how near fences are.
void printSurroundings(const Checked& checked) {
  if (checked.overhang && checked.overhang->overhangs > 0)
    std::printf(
        "overhang    %zu %s, %.1f mm of bead with nothing below along the tool axis, the longest %.2f mm\n",
        checked.overhang->overhangs, checked.overhang->overhangs == 1 ? "stretch" : "stretches",
        checked.overhang->all.overhang_mm, checked.overhang->longest_overhang_mm);
  if (!checked.overhang_unknown.empty())
    std::printf("overhang    not looked at: %s\n", checked.overhang_unknown.c_str());
  if (checked.fence)
    std::printf("nearest     link '%s' comes to %.1f mm of body %zu of the cell: %s\n",
                checked.fence->link.c_str(), checked.fence->distance_mm, checked.fence->body + 1,
                toText(checked.fence->at).c_str());
}

void print(const Finding& finding) {
  const std::string line = finding.line > 0 ? "line " + std::to_string(finding.line) + ", " : "";
  std::printf("%-11s %s%s: %s\n", finding.what.c_str(), line.c_str(), toText(finding.at).c_str(),
              finding.reason.c_str());
}

std::string verdictOn(const Checked& checked) {
  if (!checked.check.isClear()) return "the machine cannot run it";
  return checked.early_end ? "the machine can run it as far as it goes" : "the machine can run it";
}

void printText(const Checked& checked, const std::string& machine) {
  const MachineCheck& check = checked.check;
  std::printf("machine     %s\n", machine.c_str());
  std::printf("waypoints   %zu\n", check.waypoints);
  std::map<std::string, std::vector<Finding>> by_kind;
  for (const Finding& finding : findingsOf(check)) {
    std::vector<Finding>& kind = by_kind[finding.what];
    kind.push_back(finding);
    if (kind.size() <= kShown) print(finding);
  }
  for (const auto& [what, kind] : by_kind)
    std::printf("%-11s at %zu waypoints in %zu layers\n", what.c_str(), kind.size(), layersOf(kind));
  std::printf("rewinds     %zu\n", check.rewinds);
  for (const auto& [one, other] : check.ignored)
    std::printf("unchecked   %s against %s\n", one.c_str(), other.c_str());
  if (!check.unknown_way.empty()) std::printf("unchecked   %s\n", check.unknown_way.c_str());
  printSingular(checked);
  printSurroundings(checked);
  if (checked.timed)
    std::printf("print time  %s\nbelow feed  %.1f %% of the bead, at less than 95 %% of its feed\n",
                durationText(checked.time.total_s).c_str(), 100.0 * checked.time.slow_bead_share);
  if (checked.early_end) print(*checked.early_end);
  std::printf("%s\n", verdictOn(checked).c_str());
}

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

void writeReport(const MachineCheck& check, const std::string& file) {
  std::string text = "layer,path,waypoint,line,what,reason\n";
  for (const Finding& finding : findingsOf(check))
    text += std::to_string(finding.at.layer) + "," + std::to_string(finding.at.path) + "," +
            std::to_string(finding.at.waypoint) + "," +
            (finding.line > 0 ? std::to_string(finding.line) : "") + "," + finding.what + "," +
            quoted(finding.reason) + "\n";
  writeFile(file, text);
}

/// Before anything else is in memory beside the text.
std::optional<EarlyEnd> earlyEndOf(const std::string& input) {
  return isGcodeFile(input) ? earlyEnd(readTextFile(input)) : std::nullopt;
}

/// At the last waypoint that is there.
std::optional<Finding> findingOf(const std::optional<EarlyEnd>& end, const KinematicModelRun& run) {
  if (!end || run.path.at.empty()) return std::nullopt;
  const WaypointIndex& last = run.path.at.back();
  const Point3& tip = run.toolpath().layers[last.layer].paths[last.path].points[last.waypoint];
  return Finding{run.divided.originalOf(last), tip, "ends early", end->reason, end->line};
}

std::optional<FenceDistance> fenceOf(const KinematicModelRun& run, const CheckedMachine& machine) {
  std::vector<JointPassage> passages;
  passages.reserve(run.passages.size());
  for (const RunPassage& passage : run.passages) passages.push_back(passage.joints);
  std::optional<FenceDistance> fence = nearestToFences(
      {run.toolpath(), run.bed_from_part, machine.model(), run.path}, passages, machine.bodies());
  if (fence) fence->at = run.divided.originalOf(fence->at);
  return fence;
}

/// What cannot be looked at does not take the rest of the check with it.
void findOverhang(Checked& checked, const KinematicModelRun& run, const OverhangSettings& settings,
                  Progress& progress) {
  try {
    checked.overhang = totals(findOverhangs(run.toolpath(), run.bed_from_part, settings, progress));
  } catch (const InvalidInput& error) {
    checked.overhang_unknown = error.what();
  }
}

Checked checkedOn(const KinematicModel& model, const std::string& input, const JobSettings& settings) {
  TerminalProgress progress;
  const CheckedMachine machine(model);
  const std::optional<EarlyEnd> end = earlyEndOf(input);
  KinematicModelRun run = runOfInput(machine, input, settings, progress);
  Checked checked;
  checked.check = checkRun(run, machine, settings.clearance, progress);
  checked.early_end = findingOf(end, run);
  checked.singular = singularBeads(run, model, settings.joints.singular_margin_deg);
  checked.fence = fenceOf(run, machine);
  if (isArm(model)) findOverhang(checked, run, settings.overhang, progress);
  if (!run.path.isRunnable()) return checked;
  checked.timed = inTime(std::move(run), model, runSettings(settings).timing);
  checked.time = plannedTime(*checked.timed, model, settings.motion);
  return checked;
}

void check(const CheckArguments& arguments, Chosen& chosen) {
  requireSuffix(arguments.trajectory, {".csv"});
  requireNozzleRate(arguments.rate_hz);
  requireApart({arguments.report, arguments.trajectory}, {arguments.run.input, arguments.settings.config});
  const JobSettings settings = settingsOnMachine(arguments.settings, arguments.run);
  const auto model = kinematicModelOf(settings.machine);
  const Checked checked = checkedOn(*model, arguments.run.input, settings);
  if (!arguments.report.empty()) writeReport(checked.check, arguments.report);
  if (!checked.check.isClear()) chosen.exit_code = kCannotRun;
  if (!arguments.trajectory.empty()) {
    if (checked.check.isClear())
      writeNozzleCsv(arguments.trajectory, *checked.timed->trajectory, *model,
                     {arguments.rate_hz, levelsIn(checked.timed->run.toolpath())});
    else
      std::fprintf(stderr, "%s is not written: the machine cannot run what it would hold\n",
                   arguments.trajectory.c_str());
  }
  chosen.format == OutputFormat::Json ? printJson(checked, model->name()) : printText(checked, model->name());
}

}  // namespace

void addCheck(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "check",
      "Check that a machine or robot reaches every waypoint and runs into nothing; exits with 2 if not");
  subcommand->alias("clearance");  // the command of the release before
  const auto arguments = std::make_shared<CheckArguments>();
  addMachineRun(*subcommand, arguments->run);
  subcommand->add_option("--report", arguments->report, "File (.csv) for all waypoints that it cannot run");
  CLI::Option* const trajectory = subcommand->add_option(
      "--trajectory", arguments->trajectory,
      "File (.csv) for the nozzle over time: pose, speed and process; only of what can be run");
  subcommand->add_option("--rate-hz", arguments->rate_hz, "Rows a second of --trajectory, 50 to 500")
      ->needs(trajectory);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing, reading and the joints");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { check(*arguments, chosen); }; });
}

}  // namespace lamina::cli
