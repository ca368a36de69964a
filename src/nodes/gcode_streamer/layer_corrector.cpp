// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_corrector.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {
namespace {

/// @throws InvalidProgram if nothing of the program can be corrected
void requireCorrectable(const StreamableProgram& program, const Toolpath& toolpath) {
  CorrectionMap everything{toolpathId(toolpath), 0, 0, {}};
  std::vector<CorrectionMap> maps;
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k) {
    everything.layer = k;
    everything.paths.clear();
    for (std::size_t p = 0; p < toolpath.layers[k].paths.size(); ++p)
      everything.paths.push_back({p, 1e9, {{1.0, 0.0, 0.0}}});
    maps.push_back(everything);
  }
  ProgramCorrector trial(toolpath, maps, {});
  const auto text = program.openText();
  std::string line;
  std::string out;
  for (std::size_t number = 1; std::getline(*text, line); ++number) {
    out.clear();
    trial.read(line, number, out);
  }
  if (trial.report().corrected_lines > 0) return;
  throw InvalidProgram(program.name() + " deposits nothing on the toolpath " +
                       (toolpath.part_name.empty() ? "published last" : "of '" + toolpath.part_name + "'") +
                       "; expected its program, to correct it");
}

}  // namespace

LayerCorrector::LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                               StreamCorrectionSettings settings)
    : toolpath_(std::move(toolpath)),
      settings_(std::move(settings)),
      program_sha256_(sha256Of(program)),
      programmed_id_(toolpathId(toolpath_.toolpath)),
      corrector_(toolpath_.toolpath, {}, {}) {
  requireCorrectable(program, toolpath_.toolpath);
  if (!settings_.folder.empty()) std::filesystem::create_directories(settings_.folder);
}

std::string LayerCorrector::hear(CorrectionMap map) {
  if (map.toolpath_id != toolpath_.id)
    return "the map is of toolpath " + map.toolpath_id + "; streamed is " + toolpath_.id;
  if (map.layer >= toolpath_.toolpath.layers.size())
    return "the map is of layer " + std::to_string(map.layer) + "; the toolpath has " +
           std::to_string(toolpath_.toolpath.layers.size());
  const double most_mm = toolpath_.toolpath.layers[map.layer].height_mm;
  for (const PathCorrection& path : map.paths)
    for (const PlaceCorrection& place : path.stations)
      if (std::abs(place.dz_mm) > most_mm)
        return "the map of layer " + std::to_string(map.layer) + " moves the nozzle by " +
               std::to_string(place.dz_mm) + " mm; expected no more than the layer, " +
               std::to_string(most_mm) + " mm";
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!decisions_.empty() && map.layer <= decisions_.back().layer)
    return "the map of layer " + std::to_string(map.layer) + " comes when that layer is on its way";
  heard_[map.layer] = std::move(map);
  return {};
}

bool LayerCorrector::isKnown(std::int32_t layer) {
  if (layer < 0) return true;
  const auto number = static_cast<std::size_t>(layer);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!decisions_.empty() && number <= decisions_.back().layer) return true;
  const auto found = heard_.find(number);
  if (found == heard_.end() && number > 0) return false;
  apply(number, found == heard_.end() ? nullptr : &found->second);
  return true;
}

void LayerCorrector::decide(std::int32_t layer) {
  if (layer < 0 || isKnown(layer)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  apply(static_cast<std::size_t>(layer), nullptr);
}

/// A map that cannot be applied leaves its layer as planned: the print goes on.
void LayerCorrector::apply(std::size_t layer, const CorrectionMap* map) {
  LayerDecision decision;
  decision.layer = layer;
  try {
    if (map != nullptr) {
      const ToolpathLayer& of_map = toolpath_.toolpath.layers[layer];
      CorrectionMap led = ledMap(*map, of_map, feederOf(settings_.loop), settings_.loop);
      led.toolpath_id = programmed_id_;
      corrector_.add(led);
      decision.sequence = map->sequence;
      decision.digest = digestOf(*map);
    }
  } catch (const Error& error) {
    decision.refusal = error.what();
    map = nullptr;
  }
  decisions_.push_back(decision);
  keepRecord(map);
  heard_.erase(heard_.begin(), heard_.upper_bound(layer));
}

std::string LayerCorrector::revised(std::string_view line, std::uint64_t number) {
  std::string out;
  corrector_.read(line, number, out);
  return out;
}

/// What was laid can be laid again from the program and this. A disk that fails does not stop the machine.
void LayerCorrector::keepRecord(const CorrectionMap* map) {
  if (settings_.folder.empty() || !record_failure_.empty()) return;
  try {
    if (map != nullptr)
      writeFile(settings_.folder + "/layer_" + std::to_string(map->layer) + ".csv", correctionMapCsv(*map));
    std::string record =
        "# program_sha256 " + program_sha256_ + "\n# toolpath " + toolpath_.id + "\nlayer,sequence,digest\n";
    for (const LayerDecision& each : decisions_)
      record += std::to_string(each.layer) + "," + std::to_string(each.sequence) + "," +
                (each.digest.empty() ? "none" : each.digest) + "\n";
    writeFile(settings_.folder + "/record.csv", record);
  } catch (const Error& error) {
    record_failure_ = error.what();
  }
}

std::vector<LayerDecision> LayerCorrector::decisions() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return decisions_;
}

std::string LayerCorrector::recordFailure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return record_failure_;
}

}  // namespace lamina
