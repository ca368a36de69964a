// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/finite_number.hpp"
#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/stiffness/calculix_deck.hpp"
#include "lamina/stiffness/stiffness.hpp"
#include "lamina/sweep/abaqus_script.hpp"
#include "lamina/sweep/gmsh_geometry.hpp"
#include "lamina/sweep/inventor_macro.hpp"
#include "lamina/sweep/solid_union.hpp"
#include "output/point_json.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina sweep` as it was typed.
struct SweepArguments {
  std::string input;
  std::string corners;  ///< empty for what the settings say
  std::string output;
  std::string abaqus;
  std::string gmsh;
  std::string inventor;
  std::string deck;
  double density_g_cm3 = 1.24;
  SettingOptions settings;
};

/// What the sweeps of a toolpath are.
struct SweepReport {
  CornerStrategy corners = CornerStrategy::Sections;
  std::vector<Sweep> sweeps;
  double extruded_mm3 = 0.0;
  double volume_mm3 = 0.0;
  Box3 box;
  std::optional<std::size_t> triangles;
  double surface_mm3 = 0.0;       ///< what the triangles enclose
  std::optional<double> force_n;  ///< of plate or punch, as the deck loads it
  double wall_s = 0.0;

  std::size_t trajectories() const { return sweeps.empty() ? 0 : sweeps.back().trajectory + 1; }
  Bead widest() const { return std::max_element(sweeps.begin(), sweeps.end(), isNarrower)->bead; }
  Bead narrowest() const { return std::min_element(sweeps.begin(), sweeps.end(), isNarrower)->bead; }

 private:
  static bool isNarrower(const Sweep& a, const Sweep& b) { return a.bead.width_mm < b.bead.width_mm; }
};

/// Writes what the voxels of the union are asked for, the scripts first: they cost least and refuse most.
void writeOutputs(const std::vector<BeadSolid>& solids, const SweepArguments& arguments,
                  const JobSettings& settings, SweepReport& report) {
  if (!arguments.abaqus.empty()) writeFile(arguments.abaqus, abaqusScript(report.sweeps));
  if (!arguments.gmsh.empty()) writeFile(arguments.gmsh, gmshGeometry(report.sweeps));
  if (!arguments.inventor.empty()) writeFile(arguments.inventor, inventorMacro(report.sweeps));
  if (arguments.output.empty() && arguments.deck.empty()) return;
  TerminalProgress progress;
  const VoxelGrid inside = voxelUnion(solids, settings.sweep.voxel_mm, progress);
  if (!arguments.deck.empty()) {
    const StiffnessResult result = solveStiffness(inside, settings.stiffness, progress);
    writeCalculixDeck(result, settings.stiffness.material, arguments.deck);
    report.force_n = result.force_n;
  }
  if (arguments.output.empty()) return;
  const Mesh mesh = unionSurface(solids, inside);
  writeStl(arguments.output, mesh);
  report.triangles = mesh.triangles.size();
  report.surface_mm3 = volume(mesh);
}

SweepReport sweepAll(const SweepArguments& arguments, const JobSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  TerminalProgress progress;
  SweepReport report;
  report.corners = settings.sweep.corners;
  report.sweeps = sweepsOf(readToolpath(arguments.input, settings).toolpath, settings.sweep);
  if (report.sweeps.empty())
    throw InvalidInput("'" + arguments.input + "' lays no bead of a part; expected one that can be swept");
  report.extruded_mm3 = sweptVolume(report.sweeps);
  const std::vector<BeadSolid> solids = beadSolids(report.sweeps, report.corners);
  report.box = unionBox(solids);
  report.volume_mm3 = unionVolume(solids, progress);
  writeOutputs(solids, arguments, settings, report);
  report.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

double deviationPercent(const SweepReport& report) {
  return 100.0 * (report.volume_mm3 / report.extruded_mm3 - 1.0);
}

void printJson(const SweepReport& report, double mass_g) {
  nlohmann::ordered_json json = {{"corners", toString(report.corners)},
                                 {"trajectories", report.trajectories()},
                                 {"sweeps", report.sweeps.size()},
                                 {"width_min_mm", report.narrowest().width_mm},
                                 {"width_max_mm", report.widest().width_mm},
                                 {"extruded_mm3", report.extruded_mm3},
                                 {"volume_mm3", report.volume_mm3},
                                 {"deviation_percent", deviationPercent(report)},
                                 {"mass_g", mass_g},
                                 {"size_mm", pointToJson(report.box.size())},
                                 {"box_min_mm", pointToJson(report.box.low)},
                                 {"box_max_mm", pointToJson(report.box.high)}};
  if (report.triangles) {
    json["triangles"] = *report.triangles;
    json["surface_encloses_mm3"] = report.surface_mm3;
  }
  if (report.force_n) json["force_n"] = *report.force_n;
  json["wall_s"] = report.wall_s;
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const SweepReport& report, double mass_g) {
  const Point3 size = report.box.size();
  std::printf("sweeps     %zu of %zu trajectories, corners %s\n", report.sweeps.size(), report.trajectories(),
              toString(report.corners));
  std::printf("widths     %.4g to %.4g mm\n", report.narrowest().width_mm, report.widest().width_mm);
  std::printf("volume     %.6g mm3, %+.3f %% of the %.6g mm3 extruded; %.4g g\n", report.volume_mm3,
              deviationPercent(report), report.extruded_mm3, mass_g);
  std::printf("size       %.6g x %.6g x %.6g mm\n", size.x(), size.y(), size.z());
  if (report.triangles)
    std::printf("surface    %zu triangles enclose %.6g mm3\n", *report.triangles, report.surface_mm3);
  if (report.force_n) std::printf("force      %.6g N, as the deck is loaded\n", *report.force_n);
  std::printf("took       %.2f s\n", report.wall_s);
}

void sweep(const SweepArguments& arguments, OutputFormat format) {
  SettingOptions options = arguments.settings;
  if (!arguments.corners.empty()) options.assignments.push_back("sweep.corners=" + arguments.corners);
  const JobSettings settings = jobSettingsFrom(options);
  requireSuffix(arguments.output, {".stl"});
  requireSuffix(arguments.abaqus, {".py"});
  requireSuffix(arguments.gmsh, {".geo"});
  requireSuffix(arguments.inventor, {".bas"});
  requireSuffix(arguments.deck, {".inp"});
  requireApart({arguments.output, arguments.abaqus, arguments.gmsh, arguments.inventor, arguments.deck},
               {arguments.input, options.config});
  const SweepReport report = sweepAll(arguments, settings);
  const double mass_g = report.volume_mm3 * arguments.density_g_cm3 / 1e3;
  format == OutputFormat::Json ? printJson(report, mass_g) : printText(report, mass_g);
}

}  // namespace

void addSweep(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("sweep", "Build the solid of the beads of a program, swept along their paths");
  const auto arguments = std::make_shared<SweepArguments>();
  subcommand
      ->add_option("input", arguments->input,
                   "Program (.gcode, .mod), toolpath (.csv), mesh file or name of a part")
      ->required();
  subcommand->add_option("--corners", arguments->corners, "How beads go round corners, as sweep.corners")
      ->check(CLI::IsMember({"whole", "lines", "revolved", "sections"}));
  subcommand->add_option("-o,--output", arguments->output, "Surface of the union to write (.stl)");
  subcommand->add_option("--abaqus", arguments->abaqus, "Script for Abaqus/CAE to write (.py)");
  subcommand->add_option("--gmsh", arguments->gmsh, "Geometry for Gmsh to write (.geo)");
  subcommand->add_option("--inventor", arguments->inventor,
                         "Macro for Autodesk Inventor to write (.bas, a VBA module)");
  subcommand->add_option("--deck", arguments->deck,
                         "The voxels of the union, loaded as stiffness.* says, for CalculiX to write (.inp)");
  subcommand->add_option("--density-g-cm3", arguments->density_g_cm3, "Density of what is deposited")
      ->check(CLI::PositiveNumber)
      ->check(requireFinite)
      ->capture_default_str();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading and sweeping");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { sweep(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
