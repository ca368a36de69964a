// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_corrector.hpp"

#include <filesystem>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {
LayerCorrector::LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                               StreamCorrectionSettings settings)
    : toolpath_(std::move(toolpath)),
      settings_(std::move(settings)),
      program_sha256_(sha256Of(program)),
      programmed_id_(toolpathId(toolpath_.toolpath)),
      corrector_(toolpath_.toolpath, {}, {}) {
  requireLaysToolpath(program.name(), *program.openText(), toolpath_.toolpath);
  if (settings_.folder.empty()) return;
  std::filesystem::create_directories(settings_.folder);
  writeFile(settings_.folder + "/" + kProgrammedToolpathFile, programmedToolpathCsv(toolpath_));
}

std::string LayerCorrector::hear(CorrectionMap map) {
  const std::string defect = defectOf(map, toolpath_);
  if (!defect.empty()) return "the map " + defect;
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
  apply({number, 0, {}, {}, 0.0}, found == heard_.end() ? nullptr : &found->second);
  return true;
}

void LayerCorrector::decide(std::int32_t layer) {
  if (layer < 0 || isKnown(layer)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  apply({static_cast<std::size_t>(layer), 0, {}, {}, settings_.loop.wait_s}, nullptr);
}

/// A map that cannot be applied leaves its layer as planned: the print goes on.
void LayerCorrector::apply(LayerDecision decision, const CorrectionMap* map) {
  const std::size_t layer = decision.layer;
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
  decisions_.push_back(std::move(decision));
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
    writeFile(settings_.folder + "/" + kAppliedMapsFile, record);
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
