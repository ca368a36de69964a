// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/finite_number.hpp"
#include "arguments/setting_options.hpp"
#include "lamina/job/part/part_mesh.hpp"
#include "lamina/job/plate/laying.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina lay` as it was typed.
struct LayArguments {
  std::string part;
  SettingOptions settings;
  LayingSettings laying;
  std::size_t shown = 5;
};

nlohmann::ordered_json jsonOf(const Laying& laying) {
  const Point3& turn = laying.turn_deg;
  return {{"turn_deg", {turn.x(), turn.y(), turn.z()}},
          {"cost", laying.cost()},
          {"overhang_mm2", laying.overhang_mm2},
          {"height_mm", laying.height_mm},
          {"face_mm2", laying.face_mm2}};
}

void lay(const LayArguments& arguments, OutputFormat format) {
  const InputSettings input = jobSettingsFrom(arguments.settings).input;
  std::vector<Laying> found = layings(partMesh(arguments.part, input), arguments.laying);
  found.resize(std::min(found.size(), arguments.shown));
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json;
    for (const Laying& laying : found) json["layings"].push_back(jsonOf(laying));
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%-28s %12s %10s %12s\n", "turn_deg", "overhang mm2", "height mm", "on bed mm2");
  for (const Laying& laying : found) {
    char turn[64];
    std::snprintf(turn, sizeof turn, "[%.6g, %.6g, %.6g]", laying.turn_deg.x(), laying.turn_deg.y(),
                  laying.turn_deg.z());
    std::printf("%-28s %12.2f %10.2f %12.2f\n", turn, laying.overhang_mm2, laying.height_mm, laying.face_mm2);
  }
}

}  // namespace

void addLay(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("lay", "Propose turns by which a part lies on the bed with little overhang");
  const auto arguments = std::make_shared<LayArguments>();
  subcommand
      ->add_option("part", arguments->part,
                   "Mesh file (STL, OBJ, PLY, 3MF, STEP) or name of a parametric part")
      ->required();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML), of which input.* is used");
  subcommand
      ->add_option("--overhang-deg", arguments->laying.overhang_deg,
                   "Faces that lean farther from the vertical hang (45)")
      ->check(CLI::Range(0.0, 90.0))
      ->check(requireFinite);
  subcommand->add_option("--best", arguments->shown, "Show so many turns (5)")->check(CLI::Range(1, 500));
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { lay(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
