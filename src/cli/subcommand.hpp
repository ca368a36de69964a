// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina::cli {

/// How a subcommand reports its results.
enum class OutputFormat { Text, Json };

/// What was done so far, by names in JSON.
using Counts = std::vector<std::pair<std::string, std::uint64_t>>;

/// The subcommand chosen on the command line: its function, and the format of its report. `run` throws on
/// failure; `main` prints the error and chooses the exit code.
struct Chosen {
  std::function<void()> run;
  OutputFormat format = OutputFormat::Text;
  int exit_code = 0;  ///< of a run that does not fail
  Counts counts;      ///< reported beside the error if `run` fails
};

/// Greatest index of a requested layer: no program has more.
inline constexpr int kMostLayers = 1000000000;

/// Adds the flag `--json` to a subcommand.
void addJsonFlag(CLI::App& subcommand, Chosen& chosen);

/// Prints the settings on standard output: as YAML, or as one JSON object of keys and values.
void printConfig(const SettingsSchema& schema, OutputFormat format);

/// Descriptions of subcommands of other executables for `lamina --help`.
inline constexpr char kAlarmsDescription[] = "List the alarms of a cell, and what each asks for";
inline constexpr char kAuditDescription[] =
    "Check whether rows of a cell's audit were edited, removed or added";
inline constexpr char kDecideDescription[] = "Choose one point of a front by weights";
inline constexpr char kEstimateDescription[] =
    "Height errors, gains and correction maps of a recorded print, from its bag";
inline constexpr char kOptimiseDescription[] =
    "Run a study: search configurations for what it wants; stopped, it goes on where it was";
inline constexpr char kRecordDescription[] =
    "Print the record of a part that a cell has made, and check its files";

inline constexpr char kTokenDescription[] = "Tokens of the operator's page: make, list or remove them";

// Each function adds a subcommand with all its options; if the command line names it, `chosen.run` is set.
// `chosen` must outlive the parsing.
void addAlarms(CLI::App& app, Chosen& chosen);
void addAudit(CLI::App& app, Chosen& chosen);
void addCalibrate(CLI::App& app, Chosen& chosen);
void addCheck(CLI::App& app, Chosen& chosen);
void addCompare(CLI::App& app, Chosen& chosen);
void addCoordinates(CLI::App& app, Chosen& chosen);
void addCorrect(CLI::App& app, Chosen& chosen);
void addDecide(CLI::App& app, Chosen& chosen);
void addDeposit(CLI::App& app, Chosen& chosen);
void addEmulate(CLI::App& app, Chosen& chosen);
void addExpand(CLI::App& app, Chosen& chosen);
void addFillVoids(CLI::App& app, Chosen& chosen);
void addFilm(CLI::App& app, Chosen& chosen);
void addHeights(CLI::App& app, Chosen& chosen);
void addIncline(CLI::App& app, Chosen& chosen);
void addInfo(CLI::App& app, Chosen& chosen);
void addLay(CLI::App& app, Chosen& chosen);
void addMetrics(CLI::App& app, Chosen& chosen);
void addOptimise(CLI::App& app, Chosen& chosen);
void addOverhang(CLI::App& app, Chosen& chosen);
void addPart(CLI::App& app, Chosen& chosen);
void addPores(CLI::App& app, Chosen& chosen);
void addPreview(CLI::App& app, Chosen& chosen);
void addProfiles(CLI::App& app, Chosen& chosen);
void addRecord(CLI::App& app, Chosen& chosen);
void addReplan(CLI::App& app, Chosen& chosen);
void addResume(CLI::App& app, Chosen& chosen);
void addRobot(CLI::App& app, Chosen& chosen);
void addRotate(CLI::App& app, Chosen& chosen);
void addScaffold(CLI::App& app, Chosen& chosen);
void addSlice(CLI::App& app, Chosen& chosen);
void addStatistics(CLI::App& app, Chosen& chosen);
void addStiffness(CLI::App& app, Chosen& chosen);
void addStream(CLI::App& app, Chosen& chosen);
void addSweep(CLI::App& app, Chosen& chosen);
void addToken(CLI::App& app, Chosen& chosen);
void addTrack(CLI::App& app, Chosen& chosen);
void addVoids(CLI::App& app, Chosen& chosen);

}  // namespace lamina::cli
