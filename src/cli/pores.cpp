// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/setting_options.hpp"
#include "arguments/voxel_input.hpp"
#include "lamina/base/error.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/geometry/voxel/isosurface.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/picture/pore_picture.hpp"
#include "lamina/pores/layer_pores.hpp"
#include "lamina/pores/pore_projection.hpp"
#include "lamina/pores/pore_report.hpp"
#include "lamina/pores/voxel_surface.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

using PoresClock = std::chrono::steady_clock;

/// The command line of `lamina pores` as it was typed.
struct PoreArguments {
  std::string input;
  std::string picture;
  std::vector<double> crop_mm;     ///< low and high corner, or nothing
  std::optional<double> voxel_mm;  ///< none for that of the settings
  SettingOptions settings;
};

/// All figures of an input.
struct Findings {
  VoxelFrame frame;  ///< of what is looked at
  double solid_mm3 = 0.0;
  PoreReport pores;
  PoreProjection projection;
  double surface_mm2 = 0.0;
  double isosurface_mm2 = 0.0;
  std::vector<LayerPores> layers;
  double wall_s = 0.0;
};

Findings examine(const PoreArguments& arguments, const JobSettings& settings, PoresClock::time_point start) {
  TerminalProgress progress;
  const std::optional<Box3> crop = cropFrom(arguments.crop_mm);
  const VoxelInput input = readVoxels(arguments.input, settings, progress);
  const VoxelRange range = crop ? voxelsIn(input.grid.frame(), *crop) : input.grid.solidRange();
  if (range.isEmpty()) throw InvalidInput("no voxel lies in the crop");
  const VoxelGrid looked_at = cropped(input.grid, range);
  Findings findings;
  findings.frame = looked_at.frame();
  findings.solid_mm3 = looked_at.solidVolume();
  findings.pores = reportPores(looked_at, progress);
  findings.projection = projectPores(looked_at);
  findings.surface_mm2 = voxelFaceArea(looked_at);
  findings.isosurface_mm2 = surfaceArea(isosurface(looked_at));
  // What meets the border of the frame is not enclosed.
  const int margin = crop ? 0 : 1;
  const VoxelRange wider{{range.low[0] - margin, range.low[1] - margin, range.low[2]},
                         {range.high[0] + margin, range.high[1] + margin, range.high[2]}};
  findings.layers = poresByLayer(cropped(input.grid, wider), input.layers, progress);
  findings.wall_s = std::chrono::duration<double>(PoresClock::now() - start).count();
  return findings;
}

nlohmann::ordered_json toJson(const Passages& passages) {
  nlohmann::ordered_json along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Passage& passage = passages.along[axis];
    along[std::string(1, "xyz"[axis])] = {{"epci_forward_percent", passage.epci_forward_percent},
                                          {"epci_backward_percent", passage.epci_backward_percent},
                                          {"mecsi_percent", passage.mecsi_percent}};
  }
  return along;
}

nlohmann::ordered_json toJson(const PoreSizes& sizes) {
  nlohmann::ordered_json axes = nlohmann::json::array();
  for (const Spread& axis : sizes.ellipsoid_mm)
    axes.push_back({{"mean_mm", axis.mean}, {"deviation_mm", axis.deviation}});
  return {{"groups", sizes.groups},
          {"voxels", sizes.voxels},
          {"volume_percent", sizes.volume_percent},
          {"mean_diameter_mm", sizes.mean_diameter_mm},
          {"ellipsoid_axes", axes}};
}

void printJson(const Findings& findings) {
  const PoreReport& pores = findings.pores;
  const Box3 box = findings.frame.box();
  const auto& count = findings.frame.count;
  nlohmann::ordered_json json = {
      {"voxel_mm", findings.frame.voxel_mm},
      {"count", {count[0], count[1], count[2]}},
      {"box_mm", {{box.low.x(), box.low.y(), box.low.z()}, {box.high.x(), box.high.y(), box.high.z()}}},
      {"solid_mm3", findings.solid_mm3},
      {"porosity_percent", pores.porosity_percent},
      {"epci_percent", pores.passages.epciPercent()},
      {"mecsi_percent", pores.passages.mecsiPercent()},
      {"epci_h_percent", pores.joining_passages.epciPercent()},
      {"mecsi_h_percent", pores.joining_passages.mecsiPercent()},
      {"cvi_percent", pores.joining_opposite.volume_percent},
      {"cvi_2_percent", pores.joining_two.volume_percent},
      {"pore_um", findings.projection.meanDiameterUm()},
      {"pores_in_projection", findings.projection.innerCount()},
      {"surface_mm2", findings.surface_mm2},
      {"isosurface_mm2", findings.isosurface_mm2},
      {"passages", toJson(pores.passages)},
      {"passages_h", toJson(pores.joining_passages)},
      {"groups",
       {{"all", toJson(pores.all)},
        {"joining_opposite_faces", toJson(pores.joining_opposite)},
        {"joining_two_faces", toJson(pores.joining_two)}}}};
  nlohmann::ordered_json layers = nlohmann::json::array();
  for (const LayerPores& layer : findings.layers)
    layers.push_back(
        {{"z_mm", layer.band.high_mm}, {"void_ratio", layer.voidRatio()}, {"open_ratio", layer.openRatio()}});
  json["layers"] = layers;
  json["wall_s"] = findings.wall_s;
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const Findings& findings) {
  const PoreReport& pores = findings.pores;
  const Point3 size = findings.frame.box().size();
  std::printf("box              %.4g x %.4g x %.4g mm, voxels of %g mm\n", size.x(), size.y(), size.z(),
              findings.frame.voxel_mm);
  std::printf("porosity         %.3f %%\n", pores.porosity_percent);
  std::printf("interconnection  CVI %.3f %%, CVI_2 %.3f %%\n", pores.joining_opposite.volume_percent,
              pores.joining_two.volume_percent);
  std::printf("passage          EPCI %.3f %%, MECSI %.3f %%\n", pores.passages.epciPercent(),
              pores.passages.mecsiPercent());
  std::printf("  joining faces  EPCI %.3f %%, MECSI %.3f %%\n", pores.joining_passages.epciPercent(),
              pores.joining_passages.mecsiPercent());
  std::printf("pore groups      %lld, mean equivalent diameter %.4f mm\n",
              static_cast<long long>(pores.all.groups), pores.all.mean_diameter_mm);
  std::printf("pore size        %.1f um, mean of %lld openings along z\n",
              findings.projection.meanDiameterUm(), static_cast<long long>(findings.projection.innerCount()));
  std::printf("surface          %.2f mm2 of voxel faces, %.2f mm2 smooth\n", findings.surface_mm2,
              findings.isosurface_mm2);
  for (const LayerPores& layer : findings.layers)
    std::printf("  layer to %7.3f mm: void ratio %.4f\n", layer.band.high_mm, layer.voidRatio());
}

void pores(const PoreArguments& arguments, OutputFormat format) {
  const PoresClock::time_point start = PoresClock::now();
  JobSettings settings = jobSettingsFrom(arguments.settings);
  if (arguments.voxel_mm) settings.deposition.voxel_mm = *arguments.voxel_mm;
  validate(settings);
  requireSuffix(arguments.picture, {".png"});
  requireApart({arguments.picture}, {arguments.input, arguments.settings.config});
  const Findings findings = examine(arguments, settings, start);
  if (!arguments.picture.empty()) drawProjection(findings.projection, arguments.picture);
  format == OutputFormat::Json ? printJson(findings) : printText(findings);
}

}  // namespace

void addPores(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "pores", "Report what a print leaves open: porosity, interconnection, pore size, surface");
  const auto arguments = std::make_shared<PoreArguments>();
  subcommand
      ->add_option("input", arguments->input,
                   "Program (.gcode, .mod) or toolpath (.csv), deposited into voxels; mesh file or name of a "
                   "part, as drawn")
      ->required();
  subcommand->add_option("--voxel-mm", arguments->voxel_mm, "Side of a voxel; short for deposition.voxel_mm");
  subcommand
      ->add_option("--crop", arguments->crop_mm,
                   "Low and high corner [mm] of what is looked at; the box of all that is solid if left out")
      ->expected(6);
  subcommand->add_option("--picture", arguments->picture, "Picture to write (.png) of what is open along z");
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading and deposition");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { pores(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
