// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/profile_options.hpp"
#include "arguments/setting_options.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/resident_pages.hpp"
#include "lamina/job/annotations/program_annotations.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/plate/plate_job.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/picture/region_picture.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina slice` as it was typed.
struct SliceArguments {
  std::vector<std::string> parts;
  std::string plate;
  std::string output;
  ProfileOptions profiles;
  SettingOptions settings;
  std::string explained;  ///< key
  int threads = 0;
  bool is_strict = false;
  bool prints_config = false;
};

/// @param of_plate  settings that any given one by one override
JobSettings settingsFrom(const SliceArguments& arguments, const std::vector<SettingText>& of_plate) {
  SettingOptions options = arguments.settings;
  std::vector<std::string> first;
  first.reserve(of_plate.size());
  for (const SettingText& setting : of_plate) first.push_back(setting.key + "=" + setting.text);
  options.assignments.insert(options.assignments.begin(), first.begin(), first.end());
  if (arguments.is_strict) options.assignments.emplace_back("input.repair=strict");
  const LayeredSettings layered = layeredSettingsFrom(arguments.profiles, options);
  validate(layered, arguments.output);
  return layered.settings;
}

SliceJob jobFrom(const SliceArguments& arguments) {
  if (arguments.parts.empty())
    throw InvalidInput("no part is given; expected a mesh file or the name of a part");
  return {arguments.parts.front(), arguments.output, settingsFrom(arguments, {})};
}

bool isPlate(const SliceArguments& arguments) {
  return !arguments.plate.empty() || arguments.parts.size() > 1;
}

PlateJob plateJobFrom(const SliceArguments& arguments) {
  if (!arguments.plate.empty() && !arguments.parts.empty())
    throw InvalidInput("'" + arguments.parts.front() + "' is given besides --plate; expected one of them");
  Plate plate = arguments.plate.empty() ? plateOf(arguments.parts) : readPlateFile(arguments.plate);
  JobSettings settings = settingsFrom(arguments, plate.settings);
  return {std::move(plate), arguments.output, std::move(settings)};
}

/// Says what every source makes of a setting; the last one counts.
void explain(const SliceArguments& arguments, OutputFormat format) {
  const LayeredSettings layered = layeredSettingsFrom(arguments.profiles, arguments.settings);
  const std::vector<SettingOrigin> said = layered.explain(arguments.explained);
  nlohmann::ordered_json json = {
      {"key", arguments.explained}, {"value", said.back().text}, {"set_by", said.back().layer}};
  if (format == OutputFormat::Text)
    std::printf("%s = %s, set by %s\n", arguments.explained.c_str(), said.back().text.c_str(),
                said.back().layer.c_str());
  for (const SettingOrigin& origin : said) {
    json["layers"].push_back({{"layer", origin.layer}, {"place", origin.place}, {"value", origin.text}});
    if (format == OutputFormat::Text)
      std::printf("  %-24s%s%s%s\n", origin.layer.c_str(), origin.text.c_str(),
                  origin.place.empty() ? "" : "  ", origin.place.c_str());
  }
  if (format == OutputFormat::Json) std::printf("%s\n", json.dump(2).c_str());
}

double perLayer(std::size_t count, std::size_t layers) {
  return layers > 0 ? static_cast<double>(count) / static_cast<double>(layers) : 0.0;
}

void printFill(const SliceSummary& s) {
  const FillStarts& fill = s.starts;
  std::printf("fill        %.2f runs per layer, in %.2f separate areas\n", perLayer(fill.runs, s.layers),
              perLayer(fill.regions, s.layers));
  std::printf("fill travel %.2f m between runs, %.2f m in the best order found\n", fill.travel_mm / 1e3,
              fill.best_travel_mm / 1e3);
}

/// Walls that lean so far that a bead still lies on the one below need no word.
void printLean(const OverhangAngle& lean) {
  if (lean.beyond_bead_mm2 <= 0.0) return;
  std::printf("overhang    %.1f %% of the surface puts a layer out by more than a bead",
              100.0 * lean.shareBeyondBead());
  std::printf(", at most %.1f deg at (%.2f, %.2f, %.2f)\n", toDegrees(lean.greatest_rad),
              lean.greatest_at.x(), lean.greatest_at.y(), lean.greatest_at.z());
}

void printBridging(const Bridging& bridging) {
  if (bridging.bridges > 0)
    std::printf("bridges     %zu, the longest free span is %.1f mm\n", bridging.bridges, bridging.longest_mm);
  if (bridging.too_long > 0)
    std::printf("too long    %zu of them span more than bridges.longest_mm\n", bridging.too_long);
}

void printUnheld(const Bridging& bridging, const SupportTotals& supports) {
  if (bridging.unheld == 0) return;
  const char* const below = supports.support_mm3 > 0.0 ? "supports at best" : "nothing";
  std::printf("unheld      %zu pieces, %.1f mm2, lie over %s and are held on one side at most\n",
              bridging.unheld, bridging.unheld_mm2, below);
}

void printSupports(const SupportTotals& supports) {
  if (supports.blocked_mm2 > 0.05)
    std::printf("blocked     %.1f mm2 of overhang, where modifiers want no support\n", supports.blocked_mm2);
  if (supports.overhang_mm2 == 0.0) return;
  std::printf("supports    %.2f cm3 and %.2f cm3 of interfaces below %.1f mm2 of overhang",
              supports.support_mm3 / 1e3, supports.interface_mm3 / 1e3, supports.overhang_mm2);
  if (supports.unsupported_mm2 > 0.05) std::printf(", %.1f mm2 of it unsupported", supports.unsupported_mm2);
  if (supports.dropped_branches > 0)
    std::printf(", %zu branches without a foot left out", supports.dropped_branches);
  std::printf("\n");
}

/// Nothing where no joints are led.
nlohmann::ordered_json slowShare(const SliceSummary& s) {
  if (s.slow_bead_share < 0.0) return {};
  return s.slow_bead_share;
}

/// What `auto` tried.
nlohmann::ordered_json jsonOf(const std::vector<ModeCandidate>& candidates) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ModeCandidate& each : candidates) {
    nlohmann::ordered_json& one = all.emplace_back();
    one["mode"] = each.mode;
    if (!each.refusal.empty()) one["refusal"] = each.refusal;
    if (each.layers == 0) continue;
    one["unsupported_percent"] = each.unsupported_percent;
    one["steps"] = each.steps;
    one["layers"] = each.layers;
    one["time_s"] = each.time_s;
  }
  return all;
}

nlohmann::ordered_json jsonOf(const SliceSummary& s, const std::string& output) {
  return {
      {"mode", s.mode},
      {"mode_reason", s.mode_reason},
      {"notes", s.notes},
      {"steepest_lean_deg", toDegrees(s.lean.greatest_rad)},
      {"steepest_lean_at_mm", {s.lean.greatest_at.x(), s.lean.greatest_at.y(), s.lean.greatest_at.z()}},
      {"overhang_per_layer_mm", std::isfinite(s.lean.overhang_mm) ? nlohmann::ordered_json(s.lean.overhang_mm)
                                                                  : nlohmann::ordered_json()},
      {"beyond_bead_mm2", s.lean.beyond_bead_mm2},
      {"triangles", s.triangles},
      {"layers", s.layers},
      {"contours", s.contours},
      {"open_contours", s.open_contours},
      {"mesh_volume_mm3", s.mesh_volume_mm3},
      {"sliced_volume_mm3", s.sliced_volume_mm3},
      {"deposition_mm", s.deposition_mm},
      {"travel_mm", s.travel_mm},
      {"deposition_runs", s.deposition_runs},
      {"repositions_a", s.repositions.to_fill},
      {"repositions_b", s.repositions.in_layer},
      {"repositions_c", s.repositions.to_layer},
      {"fill_runs", s.starts.runs},
      {"fill_runs_least", s.starts.regions},
      {"fill_runs_per_layer", perLayer(s.starts.runs, s.layers)},
      {"fill_runs_least_per_layer", perLayer(s.starts.regions, s.layers)},
      {"fill_travel_mm", s.starts.travel_mm},
      {"fill_travel_best_mm", s.starts.best_travel_mm},
      {"deposited_mm3", s.deposited_mm3},
      {"unprinted_mm3", s.unprinted_mm3},
      {"empty_layers", s.empty_layers},
      {"moved_starts", s.anchored.moved},
      {"starts_in_air", s.anchored.in_air},
      {"bridges", s.bridging.bridges},
      {"longest_bridge_mm", s.bridging.longest_mm},
      {"bridges_too_long", s.bridging.too_long},
      {"unheld_pieces", s.bridging.unheld},
      {"unheld_mm2", s.bridging.unheld_mm2},
      {"overhang_mm2", s.supports.overhang_mm2},
      {"unsupported_mm2", s.supports.unsupported_mm2},
      {"support_blocked_mm2", s.supports.blocked_mm2},
      {"support_area_mm2", s.supports.area_mm2},
      {"support_mm3", s.supports.support_mm3},
      {"support_interface_mm3", s.supports.interface_mm3},
      {"dropped_branches", s.supports.dropped_branches},
      {"raft_mm", s.raft_mm},
      {"refill_runs", s.refilling.runs},
      {"refilled_mm3", s.refilling.deposited_mm3},
      {"estimated_time_s", s.estimated_time_s},
      {"slow_bead_share", slowShare(s)},
      {"repairs", s.repairs},
      {"output", output},
      {"read_s", s.read_s},
      {"slice_s", s.slice_s},
      {"plan_s", s.plan_s},
      {"write_s", s.write_s},
      {"wall_s", s.wall_s},
      {"peak_memory_mb", s.peak_memory_mb},
  };
}

nlohmann::ordered_json jsonOf(const PlatedPart& part) {
  return {{"name", part.name},
          {"file", part.file},
          {"at_mm", {part.at_mm.x(), part.at_mm.y()}},
          {"arranged_turn_deg", part.arranged_turn_deg},
          {"size_mm", {part.size_mm.x(), part.size_mm.y(), part.size_mm.z()}},
          {"layers", part.summary.layers},
          {"mesh_volume_mm3", part.summary.mesh_volume_mm3},
          {"deposition_mm", part.summary.deposition_mm},
          {"deposited_mm3", part.summary.deposited_mm3},
          {"unprinted_mm3", part.summary.unprinted_mm3}};
}

void printParts(const std::vector<PlatedPart>& parts) {
  for (const PlatedPart& part : parts) {
    std::printf("part        %s at (%.2f, %.2f)", part.name.c_str(), part.at_mm.x(), part.at_mm.y());
    if (part.arranged_turn_deg != 0.0) std::printf(", turned by %.0f deg", part.arranged_turn_deg);
    std::printf(": %.4g x %.4g x %.4g mm, %zu layers, %.2f cm3\n", part.size_mm.x(), part.size_mm.y(),
                part.size_mm.z(), part.summary.layers, part.summary.deposited_mm3 / 1e3);
  }
}

void printText(const SliceSummary& s, const std::string& output) {
  for (const std::string& repair : s.repairs) std::printf("repaired: %s\n", repair.c_str());
  std::printf("mode        %s%s%s\n", s.mode.c_str(), s.mode_reason.empty() ? "" : ": ",
              s.mode_reason.c_str());
  for (const std::string& note : s.notes) std::printf("note        %s\n", note.c_str());
  std::printf("mesh        %zu triangles, %.2f cm3\n", s.triangles, s.mesh_volume_mm3 / 1e3);
  std::printf("layers      %zu, %zu contours", s.layers, s.contours);
  if (s.open_contours > 0) std::printf(", and %zu open", s.open_contours);
  std::printf("\ndeposition  %.2f m in %zu runs, %.2f cm3\n", s.deposition_mm / 1e3, s.deposition_runs,
              s.deposited_mm3 / 1e3);
  std::printf("repositions %zu to fills, %zu within layers, %zu between layers\n", s.repositions.to_fill,
              s.repositions.in_layer, s.repositions.to_layer);
  if (s.starts.runs > 0) printFill(s);
  std::printf("travel      %.2f m\n", s.travel_mm / 1e3);
  if (s.unprinted_mm3 > 0.0)
    std::printf("unprinted   %.3f mm3, too small or too thin for the fill\n", s.unprinted_mm3);
  if (s.empty_layers > 0) std::printf("in the air  %zu layers are empty below others\n", s.empty_layers);
  if (s.anchored.moved + s.anchored.in_air > 0)
    std::printf("anchored    %zu starts of runs moved onto bed or material, %zu remain in the air\n",
                s.anchored.moved, s.anchored.in_air);
  printLean(s.lean);
  printBridging(s.bridging);
  printUnheld(s.bridging, s.supports);
  printSupports(s.supports);
  if (s.refilling.runs > 0)
    std::printf("refilled    %.3f mm3 of voids by %zu runs\n", s.refilling.deposited_mm3, s.refilling.runs);
  std::printf("print time  %s%s\n", durationText(s.estimated_time_s).c_str(),
              s.slow_bead_share < 0.0 ? "" : ", within the limits of the joints");
  if (s.slow_bead_share >= 0.0)
    std::printf("below feed  %.1f %% of the bead, at less than 95 %% of its feed\n",
                100.0 * s.slow_bead_share);
  std::printf("computed in %.3f s (read %.3f, slice %.3f, plan %.3f, write %.3f), %.0f MiB\n", s.wall_s,
              s.read_s, s.slice_s, s.plan_s, s.write_s, s.peak_memory_mb);
  std::printf("written to  %s\n",
              output.empty() ? "no file: -o FILE.gcode would write the program" : output.c_str());
}

/// Draws the region of a part that cannot be sliced beside the file that is not written.
SliceSummary runShown(const SliceJob& job) {
  try {
    TerminalProgress progress;
    return runSliceJob(job, progress).summary;
  } catch (const Unsliceable& refusal) {
    if (job.output.empty() || refusal.region().triangles.empty()) throw;
    const std::string picture = std::filesystem::path(job.output).replace_extension(".refused.png").string();
    drawRegion(
        {std::filesystem::path(job.part).stem().string(), refusal.what(), refusal.part(), refusal.region()},
        picture);
    throw InvalidMesh(std::string(refusal.what()) + " (shown in " + picture + ")");
  }
}

void slicePlate(const SliceArguments& arguments, OutputFormat format) {
  const PlateJob job = plateJobFrom(arguments);
  requireApart({job.output}, {arguments.plate, arguments.settings.config});
  TerminalProgress progress;
  const SlicedPlate plate = runPlateJob(job, progress);
  if (format == OutputFormat::Text) {
    printParts(plate.parts);
    return printText(plate.sliced.summary, job.output);
  }
  nlohmann::ordered_json json = jsonOf(plate.sliced.summary, job.output);
  for (const PlatedPart& part : plate.parts) json["parts"].push_back(jsonOf(part));
  std::printf("%s\n", json.dump(2).c_str());
}

void slice(const SliceArguments& arguments, OutputFormat format) {
  if (arguments.prints_config) {
    JobSettings settings = layeredSettingsFrom(arguments.profiles, arguments.settings).settings;
    SettingsSchema schema;
    describe(schema, settings);
    return printConfig(schema, format);
  }
  if (!arguments.explained.empty()) return explain(arguments, format);
  std::optional<ThreadLimit> limit;
  if (arguments.threads > 0) limit.emplace(arguments.threads);
  if (isPlate(arguments)) return slicePlate(arguments, format);
  const SliceJob job = jobFrom(arguments);
  const ProfileOptions& profiles = arguments.profiles;
  requireApart({job.output}, {job.part, arguments.settings.config, profiles.like, profiles.machine,
                              profiles.material, profiles.process});
  releaseStartPages();
  const SliceSummary summary = runShown(job);
  if (format == OutputFormat::Text) return printText(summary, job.output);
  nlohmann::ordered_json json = jsonOf(summary, job.output);
  json["candidates"] = jsonOf(summary.candidates);
  std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

void addSlice(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("slice", "Slice a part and write its program");
  const auto arguments = std::make_shared<SliceArguments>();
  subcommand->add_option(
      "part", arguments->parts,
      "Mesh file (STL, OBJ, PLY, 3MF, STEP) or name of a parametric part; several share the bed");
  subcommand->add_option("--plate", arguments->plate,
                         "File of parts that share the bed, their places and settings (YAML)");
  subcommand
      ->add_option("-o,--output", arguments->output,
                   "File to write: .gcode, .csv, or a robot's .mod, .src, .script, .ls, .jbi; without "
                   "it nothing is written")
      ->check(
          [](const std::string& name) { return name.empty() ? "the name is empty; expected a file" : ""; });
  addProfileOptions(*subcommand, arguments->profiles);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML); those not given keep their defaults");
  subcommand->add_option("--threads", arguments->threads, "At most this many threads")
      ->check(CLI::Range(1, 1024));
  subcommand->add_flag("--strict", arguments->is_strict, "Refuse a broken mesh instead of repairing it");
  subcommand->add_flag("--print-config", arguments->prints_config,
                       "Print the settings, the defaults with all sources on top, as YAML and stop");
  subcommand->add_option("--explain", arguments->explained,
                         "Say which of these set a setting, and to what, and stop");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { slice(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
