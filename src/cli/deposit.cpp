// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "arguments/voxel_input.hpp"
#include "lamina/base/available_memory.hpp"
#include "lamina/base/error.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/voxel/isosurface.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/picture/voxel_picture.hpp"
#include "lamina/pores/voxel_surface.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

using DepositClock = std::chrono::steady_clock;

constexpr double kMegabyte = 1e6;

/// The command line of `lamina deposit` as it was typed.
struct DepositArguments {
  std::string input;
  std::string output;
  std::vector<double> crop_mm;       ///< low and high corner, or nothing
  std::optional<double> voxel_mm;    ///< none for that of the settings
  std::vector<std::string> layer;    ///< number and picture, or nothing
  std::vector<std::string> section;  ///< axis=coordinate and picture, or nothing
  SettingOptions settings;
};

/// A picture that was asked for.
struct SheetPicture {
  std::size_t axis = 2;
  double at_mm = 0.0;
  std::string path;
  std::string title;
};

/// What is looked at of the deposit, and its figures.
struct DepositFindings {
  DepositTotals totals;
  VoxelFrame frame;  ///< of the crop, or the box of what is solid
  std::int64_t voxels = 0;
  double highest_mm = 0.0;
  double surface_mm2 = 0.0;
  double deposit_s = 0.0;
  double grid_mb = 0.0;
  double bits_per_voxel = 0.0;  ///< of the box of what is solid
  std::optional<Mesh> mesh;
};

VoxelFrame frameOf(VoxelFrame frame, const VoxelRange& range) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    frame.corner[static_cast<Eigen::Index>(axis)] += range.low[axis] * frame.voxel_mm;
    frame.count[axis] = range.high[axis] - range.low[axis];
  }
  return frame;
}

double secondsSince(DepositClock::time_point start) {
  return std::chrono::duration<double>(DepositClock::now() - start).count();
}

double numberFrom(const std::string& text, const std::string& what) {
  std::size_t read = 0;
  double number = 0.0;
  try {
    number = std::stod(text, &read);
  } catch (const std::logic_error&) {
    read = 0;
  }
  if (read == 0 || read != text.size()) throw InvalidInput(what + " is '" + text + "'; expected a number");
  return number;
}

/// Half way up the layer.
SheetPicture layerPicture(const DepositArguments& arguments, const Toolpath& toolpath) {
  const double number = numberFrom(arguments.layer[0], "layer of the picture");
  if (!(number >= 0.0 && number < double(toolpath.layers.size())))
    throw InvalidInput("layer of the picture is " + arguments.layer[0] + "; the toolpath has " +
                       std::to_string(toolpath.layers.size()) + " layers, the first being 0");
  const ToolpathLayer& layer = toolpath.layers[static_cast<std::size_t>(number)];
  return {2, layer.z_mm - 0.5 * layer.height_mm, arguments.layer[1], "Layer " + arguments.layer[0]};
}

SheetPicture sectionPicture(const DepositArguments& arguments) {
  const std::string& at = arguments.section[0];
  const std::size_t axis = at.empty() ? std::string::npos : std::string("xyz").find(at[0]);
  if (axis == std::string::npos || at.size() < 3 || at[1] != '=')
    throw InvalidInput("section is '" + at + "'; expected x=, y= or z= and a coordinate in mm");
  return {axis, numberFrom(at.substr(2), "section"), arguments.section[1], "Section at " + at + " mm"};
}

std::vector<SheetPicture> picturesOf(const DepositArguments& arguments, const Toolpath& toolpath) {
  std::vector<SheetPicture> pictures;
  if (!arguments.layer.empty()) pictures.push_back(layerPicture(arguments, toolpath));
  if (!arguments.section.empty()) pictures.push_back(sectionPicture(arguments));
  return pictures;
}

void requireOutputs(const DepositArguments& arguments) {
  std::vector<std::string> pictures;
  if (!arguments.layer.empty()) pictures.push_back(arguments.layer[1]);
  if (!arguments.section.empty()) pictures.push_back(arguments.section[1]);
  for (const std::string& picture : pictures) requireSuffix(picture, {".png"});
  requireSuffix(arguments.output, {".stl"});
  pictures.push_back(arguments.output);
  requireApart(pictures, {arguments.input, arguments.settings.config});
}

void drawPictures(const std::vector<SheetPicture>& pictures, const VoxelGrid& grid) {
  for (const SheetPicture& picture : pictures) {
    std::ostringstream where;
    where << grid.frame().voxel_mm << " mm voxels, "
          << "xyz"[picture.axis] << " = " << picture.at_mm << " mm";
    drawVoxelSheet(picture.path, grid, sheetAt(grid.frame(), picture.axis, picture.at_mm),
                   {picture.title, where.str()});
  }
}

/// Measures, draws and writes what was deposited.
DepositFindings examineDeposit(ToolpathDeposit deposit, const DepositArguments& arguments,
                               const std::vector<SheetPicture>& pictures) {
  DepositFindings findings;
  findings.totals = deposit.totals;
  findings.highest_mm = deposit.highest_mm;
  findings.grid_mb = static_cast<double>(deposit.grid.bytes()) / kMegabyte;
  const VoxelFrame& frame = deposit.grid.frame();
  const VoxelRange solid = deposit.grid.solidRange();
  const std::optional<Box3> crop = cropFrom(arguments.crop_mm);
  const VoxelRange range = crop ? voxelsIn(frame, *crop) : solid;
  if (range.isEmpty()) throw InvalidInput("no voxel lies in the crop");
  findings.bits_per_voxel = 8.0 * double(deposit.grid.bytes()) / double(frameOf(frame, solid).voxelCount());
  findings.frame = frameOf(frame, range);
  const VoxelGrid shown = crop ? cropped(deposit.grid, range) : std::move(deposit.grid);
  findings.voxels = shown.solidCount();
  findings.surface_mm2 = voxelFaceArea(shown);
  drawPictures(pictures, shown);
  if (arguments.output.empty()) return findings;
  findings.mesh = isosurface(shown);
  writeStl(arguments.output, *findings.mesh);
  return findings;
}

double porosityPercent(const DepositFindings& findings) {
  return 100.0 *
         (1.0 - static_cast<double>(findings.voxels) / static_cast<double>(findings.frame.voxelCount()));
}

void printJson(const DepositFindings& findings, DepositClock::time_point start) {
  const DepositTotals& totals = findings.totals;
  const Box3 box = findings.frame.box();
  nlohmann::ordered_json json = {
      {"path_mm", totals.path_mm},
      {"extruded_mm3", totals.extruded_mm3},
      {"model_mm3", totals.deposited_mm3},
      {"excess_mm3", totals.excess_mm3},
      {"outside_mm3", totals.outside_mm3},
      {"voxel_mm", findings.frame.voxel_mm},
      {"voxels", findings.voxels},
      {"box_mm", {{box.low.x(), box.low.y(), box.low.z()}, {box.high.x(), box.high.y(), box.high.z()}}},
      {"highest_mm", findings.highest_mm},
      {"porosity_percent", porosityPercent(findings)},
      {"surface_mm2", findings.surface_mm2}};
  if (findings.mesh) {
    json["stl_surface_mm2"] = surfaceArea(*findings.mesh);
    json["stl_triangles"] = findings.mesh->triangles.size();
  }
  json["deposit_s"] = findings.deposit_s;
  json["path_m_per_s"] = totals.path_mm / 1e3 / findings.deposit_s;
  json["grid_mb"] = findings.grid_mb;
  json["bits_per_voxel"] = findings.bits_per_voxel;
  json["wall_s"] = secondsSince(start);
  json["peak_memory_mb"] = peakMemory() / kMegabyte;
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const DepositFindings& findings, DepositClock::time_point start) {
  const DepositTotals& totals = findings.totals;
  const Point3 size = findings.frame.box().size();
  std::printf("path        %14.3f m, deposited in %.3f s (%.1f m/s)\n", totals.path_mm / 1e3,
              findings.deposit_s, totals.path_mm / 1e3 / findings.deposit_s);
  std::printf("extruded    %14.4f mm3\n", totals.extruded_mm3);
  std::printf("model       %14.4f mm3\n", totals.deposited_mm3);
  if (totals.excess_mm3 > 0.0)
    std::printf("excess      %14.4f mm3 found no room within deposition.reach_mm\n", totals.excess_mm3);
  std::printf("voxels      %14lld of %g mm\n", static_cast<long long>(findings.voxels),
              findings.frame.voxel_mm);
  std::printf("box         %.4g x %.4g x %.4g mm, highest %.4f mm\n", size.x(), size.y(), size.z(),
              findings.highest_mm);
  std::printf("porosity    %14.2f %% of the box\n", porosityPercent(findings));
  std::printf("surface     %14.2f mm2 of voxel faces\n", findings.surface_mm2);
  if (findings.mesh)
    std::printf("STL         %14.2f mm2, %zu triangles\n", surfaceArea(*findings.mesh),
                findings.mesh->triangles.size());
  std::printf("memory      %14.1f MB of voxels, %.1f MB at most\n", findings.grid_mb,
              peakMemory() / kMegabyte);
  std::printf("wall        %14.3f s\n", secondsSince(start));
}

void deposit(const DepositArguments& arguments, OutputFormat format) {
  const DepositClock::time_point start = DepositClock::now();
  JobSettings settings = jobSettingsFrom(arguments.settings);
  if (arguments.voxel_mm) settings.deposition.voxel_mm = *arguments.voxel_mm;
  validate(settings);
  requireOutputs(arguments);
  cropFrom(arguments.crop_mm);
  const Toolpath toolpath = onBed(readToolpath(arguments.input, settings));
  const std::vector<SheetPicture> pictures = picturesOf(arguments, toolpath);
  const DepositClock::time_point laying = DepositClock::now();
  TerminalProgress progress;
  ToolpathDeposit deposited = depositedVoxels(toolpath, settings.deposition, progress);
  const double deposit_s = secondsSince(laying);
  DepositFindings findings = examineDeposit(std::move(deposited), arguments, pictures);
  findings.deposit_s = deposit_s;
  format == OutputFormat::Json ? printJson(findings, start) : printText(findings, start);
}

}  // namespace

void addDeposit(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("deposit", "Lay a toolpath into voxels: what it leaves behind, volume for volume");
  const auto arguments = std::make_shared<DepositArguments>();
  subcommand
      ->add_option("input", arguments->input,
                   "Program (.gcode, .mod), toolpath (.csv), mesh file or name of a part")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Surface to write (.stl)");
  subcommand->add_option("--voxel-mm", arguments->voxel_mm, "Side of a voxel; short for deposition.voxel_mm");
  subcommand
      ->add_option("--crop", arguments->crop_mm,
                   "Low and high corner [mm] of what voxels, porosity, surface, pictures and STL are of")
      ->expected(6);
  subcommand
      ->add_option("--layer-picture", arguments->layer,
                   "Number of a layer (from 0) and picture to write (.png): the voxels half way up the layer")
      ->expected(2);
  subcommand
      ->add_option("--section-picture", arguments->section,
                   "Where (x=12.5, y=, z= [mm]) and picture to write (.png): the voxels in that plane")
      ->expected(2);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing, reading and deposition");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { deposit(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
