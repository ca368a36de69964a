// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/finite_number.hpp"
#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/program/csv/coordinate_matrix.hpp"
#include "lamina/program/gcode/slicer_dialect.hpp"
#include "lamina/toolpath/timing.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina coordinates` as it was typed.
struct CoordinatesArguments {
  std::string input;
  std::string output;
  double density_g_cm3 = 1.24;
  SettingOptions settings;
};

/// What was found in a program.
struct CoordinatesReport {
  ProgramNotes notes;
  double filament_diameter_mm = 0.0;
  std::vector<CoordinateRow> rows;
  double extruded_mm = 0.0;   ///< of filament, for the part
  double extruded_mm3 = 0.0;  ///< for the part
  double nominal_s = 0.0;
  double estimated_s = 0.0;
};

double filamentOf(const std::vector<CoordinateRow>& rows) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i + 1 == rows.size() || rows[i + 1].flag == CoordinateFlag::Start) sum += rows[i].filament_mm;
  return sum;
}

CoordinatesReport reportOn(const std::string& input, const JobSettings& settings) {
  CoordinatesReport report;
  if (isProgramFile(input)) report.notes = notesOf(readTextFile(input));
  const double set_mm = settings.program.filament_diameter_mm;
  report.filament_diameter_mm =
      settings.program.is_diameter_given ? set_mm : report.notes.filament_diameter_mm.value_or(set_mm);
  const Toolpath toolpath = readToolpath(input, settings).toolpath;
  report.rows = coordinateMatrix(toolpath, report.filament_diameter_mm);
  report.extruded_mm = filamentOf(report.rows);
  report.extruded_mm3 =
      report.extruded_mm * 0.25 * M_PI * report.filament_diameter_mm * report.filament_diameter_mm;
  report.nominal_s = nominalTime(toolpath);
  report.estimated_s = estimateTime(toolpath, settings.motion).total_s;
  return report;
}

void print(const CoordinatesReport& report, const CoordinatesArguments& arguments, OutputFormat format) {
  const std::size_t trajectories = trajectoryCount(report.rows);
  const double mass_g = report.extruded_mm3 * arguments.density_g_cm3 / 1e3;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"dialect", toString(report.notes.dialect)},
                                         {"filament_diameter_mm", report.filament_diameter_mm},
                                         {"rows", report.rows.size()},
                                         {"trajectories", trajectories},
                                         {"extruded_mm", report.extruded_mm},
                                         {"extruded_mm3", report.extruded_mm3},
                                         {"mass_g", mass_g},
                                         {"nominal_s", report.nominal_s},
                                         {"estimated_s", report.estimated_s},
                                         {"output", arguments.output}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("dialect      %s, filament of %.4g mm\n", toString(report.notes.dialect),
              report.filament_diameter_mm);
  std::printf("coordinates  %zu in %zu trajectories%s%s\n", report.rows.size(), trajectories,
              arguments.output.empty() ? "" : ", written to ", arguments.output.c_str());
  std::printf("extruded     %.6g mm3 of %.6g mm of filament, %.4g g at %.4g g/cm3\n", report.extruded_mm3,
              report.extruded_mm, mass_g, arguments.density_g_cm3);
  std::printf("time         %.1f s at the feeds, %.1f s with accelerations\n", report.nominal_s,
              report.estimated_s);
}

void coordinates(const CoordinatesArguments& arguments, OutputFormat format) {
  const JobSettings settings = jobSettingsFrom(arguments.settings);
  requireSuffix(arguments.output, {".csv"});
  requireApart({arguments.output}, {arguments.input, arguments.settings.config});
  const CoordinatesReport report = reportOn(arguments.input, settings);
  if (!arguments.output.empty()) writeFile(arguments.output, toCsv(report.rows));
  print(report, arguments, format);
}

}  // namespace

void addCoordinates(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "coordinates", "Report the trajectories that lay a part, as a matrix: x, y, z, flag, filament");
  const auto arguments = std::make_shared<CoordinatesArguments>();
  subcommand
      ->add_option("input", arguments->input,
                   "Program (.gcode, .mod), toolpath (.csv), mesh file or name of a part")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Table to write (.csv)");
  subcommand->add_option("--density-g-cm3", arguments->density_g_cm3, "Density of what is deposited")
      ->check(CLI::PositiveNumber)
      ->check(requireFinite)
      ->capture_default_str();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { coordinates(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
