// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/setting_options.hpp"
#include "lamina/base/available_memory.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/stiffness_job.hpp"
#include "output/point_json.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

using SteadyStart = std::chrono::steady_clock;

constexpr double kSolverMegabyte = 1e6;
constexpr std::size_t kDroppedShown = 5;  // to people; --json has all

/// The command line of `lamina stiffness` as it was typed.
struct StiffnessArguments {
  std::string input;
  std::string output;
  std::string deck;
  std::string load;
  std::string axis;
  std::optional<double> voxel_mm;  ///< none for that of the settings
  bool is_printed = false;         ///< a part is sliced and deposited rather than taken as drawn
  SettingOptions settings;
};

JobSettings settingsFrom(const StiffnessArguments& arguments) {
  SettingOptions options = arguments.settings;
  if (!arguments.load.empty()) options.assignments.push_back("stiffness.load=" + arguments.load);
  if (!arguments.axis.empty()) options.assignments.push_back("stiffness.axis=" + arguments.axis);
  JobSettings settings = jobSettingsFrom(options);
  if (arguments.voxel_mm) settings.deposition.voxel_mm = *arguments.voxel_mm;
  validate(settings);
  return settings;
}

nlohmann::ordered_json toJson(const LoadCase& load, Load kind) {
  if (kind == Load::Compression)
    return {{"kind", "compression"},
            {"axis", std::string(1, "xyz"[load.axis])},
            {"compression_mm", load.displacement_mm},
            {"length_mm", load.length_mm},
            {"area_mm2", load.area_mm2}};
  return {{"kind", "bending"},
          {"axis", std::string(1, "xyz"[load.axis])},
          {"deflection_mm", load.displacement_mm},
          {"span_mm", load.length_mm},
          {"width_mm", load.width_mm},
          {"height_mm", load.height_mm}};
}

/// Voxels by which strands are as thick as they should be; 0 if they are already.
double finerVoxel(const LoadedPart& part) {
  if (part.thickness.voxels >= kStrandVoxels) return 0.0;
  return part.result.model.element_mm * part.thickness.voxels / kStrandVoxels;
}

void printJson(const LoadedPart& part, const StiffnessSettings& settings, double wall_s) {
  const StiffnessResult& result = part.result;
  const ElementLattice& lattice = result.model.lattice;
  nlohmann::ordered_json dropped = nlohmann::ordered_json::array();
  for (const DroppedPart& piece : result.dropped)
    dropped.push_back({{"elements", piece.elements},
                       {"low_mm", pointToJson(piece.box.low)},
                       {"high_mm", pointToJson(piece.box.high)},
                       {"misses", piece.misses}});
  const nlohmann::ordered_json json = {{"load", toJson(result.model.load, settings.load)},
                                       {"force_n", result.force_n},
                                       {"modulus_mpa", result.modulus_mpa},
                                       {"imbalance_n", result.imbalance_n},
                                       {"greatest_stress_mpa", result.greatest_stress_mpa},
                                       {"greatest_stress_at_mm", pointToJson(result.greatest_stress_at)},
                                       {"voxel_mm", result.model.element_mm},
                                       {"strand_voxels", part.thickness.voxels},
                                       {"thin_percent", 100.0 * part.thickness.thin_share},
                                       {"elements", lattice.elementCount()},
                                       {"nodes", lattice.nodeCount()},
                                       {"dropped", dropped},
                                       {"iterations", result.iterations},
                                       {"residual", result.residual},
                                       {"solve_s", part.solve_s},
                                       {"wall_s", wall_s},
                                       {"peak_memory_mb", peakMemory() / kSolverMegabyte}};
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const LoadedPart& part, const StiffnessSettings& settings) {
  const StiffnessResult& result = part.result;
  const ElementLattice& lattice = result.model.lattice;
  const LoadCase& load = result.model.load;
  const Point3& at = result.greatest_stress_at;
  if (settings.load == Load::Compression)
    std::printf("compression  %.4g mm along %c of %.4g mm, section %.6g mm2\n", load.displacement_mm,
                "xyz"[load.axis], load.length_mm, load.area_mm2);
  else
    std::printf("bending      %.4g mm along %c over %.4g mm, section %.4g x %.4g mm\n", load.displacement_mm,
                "xyz"[load.axis], load.length_mm, load.width_mm, load.height_mm);
  std::printf("force        %.6g N\n", result.force_n);
  std::printf("modulus      %.6g MPa\n", result.modulus_mpa);
  std::printf("stress       %.4g MPa at most (von Mises), at (%.3f, %.3f, %.3f)\n",
              static_cast<double>(result.greatest_stress_mpa), at.x(), at.y(), at.z());
  std::printf("elements     %lld of %g mm, %d nodes\n", static_cast<long long>(lattice.elementCount()),
              result.model.element_mm, lattice.nodeCount());
  if (finerVoxel(part) > 0.0)
    std::printf(
        "thin         %.1f %% of what is solid is thinner than %d voxels and bends too stiffly; expected "
        "voxels "
        "of at most %.3g mm\n",
        100.0 * part.thickness.thin_share, kStrandVoxels, finerVoxel(part));
  for (std::size_t i = 0; i < std::min(kDroppedShown, result.dropped.size()); ++i)
    std::printf("left out     %lld elements that do not reach: %s\n",
                static_cast<long long>(result.dropped[i].elements), result.dropped[i].misses.c_str());
  if (result.dropped.size() > kDroppedShown)
    std::printf("left out     %zu more\n", result.dropped.size() - kDroppedShown);
  std::printf("solved       %d iterations to %.2g in %.2f s, %.0f MB at most\n", result.iterations,
              result.residual, part.solve_s, peakMemory() / kSolverMegabyte);
}

double solverSecondsSince(SteadyStart::time_point start) {
  return std::chrono::duration<double>(SteadyStart::now() - start).count();
}

void stiffness(const StiffnessArguments& arguments, OutputFormat format) {
  const SteadyStart::time_point start = SteadyStart::now();
  requireApart({arguments.output, arguments.deck}, {arguments.settings.config});
  const JobSettings settings = settingsFrom(arguments);
  StiffnessJob job;
  job.input = arguments.input;
  job.solid = arguments.is_printed ? PartSolid::AsDeposited : PartSolid::AsDrawn;
  job.output = arguments.output;
  job.deck = arguments.deck;
  job.settings = settings;
  TerminalProgress progress;
  const LoadedPart part = runStiffnessJob(job, progress);
  format == OutputFormat::Json ? printJson(part, settings.stiffness, solverSecondsSince(start))
                               : printText(part, settings.stiffness);
}

}  // namespace

void addStiffness(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "stiffness",
      "Compress or bend a part as voxels: force, equivalent modulus, displacements and stresses");
  const auto arguments = std::make_shared<StiffnessArguments>();
  subcommand
      ->add_option(
          "input", arguments->input,
          "Mesh file or name of a part, solid as drawn; or program (.gcode, .mod) or toolpath (.csv), "
          "as it is deposited")
      ->required();
  subcommand->add_flag("--printed", arguments->is_printed, "Slice a part and take it as it is deposited");
  subcommand->add_option("-o,--output", arguments->output,
                         "Elements with displacement and stress to write (.vtk, for ParaView)");
  subcommand->add_option("--deck", arguments->deck, "The same problem for CalculiX to write (.inp)");
  subcommand->add_option("--load", arguments->load, "compression or bending; short for stiffness.load");
  subcommand->add_option("--axis", arguments->axis, "x, y or z; short for stiffness.axis");
  subcommand->add_option("--voxel-mm", arguments->voxel_mm, "Side of a voxel; short for deposition.voxel_mm");
  addSettingOptions(*subcommand, arguments->settings,
                    "Settings (YAML) for reading, deposition and stiffness");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { stiffness(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
