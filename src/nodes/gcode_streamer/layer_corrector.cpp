// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layer_corrector.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/control/fading_map.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {
namespace {

AppliedRow laterRow(const CorrectionMap& map, std::uint64_t from_line) {
  return {map.layer, map.sequence, digestOf(map), from_line, true};
}

/// The folder of the record, of a program that can be corrected: of another one nothing is written.
std::string folderFor(const StreamableProgram& program, const ProgrammedToolpath& toolpath,
                      const StreamCorrectionSettings& settings) {
  requireLaysToolpath(program.name(), *program.openText(), toolpath.toolpath);
  return settings.folder;
}

}  // namespace

LayerCorrector::LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                               StreamCorrectionSettings settings, FirstMap first)
    : toolpath_(std::move(toolpath)),
      settings_(std::move(settings)),
      first_(first),
      programmed_id_(toolpathId(toolpath_.toolpath)),
      corrector_(toolpath_.toolpath, {}, {}),
      record_(folderFor(program, toolpath_, settings_), sha256Of(program), toolpath_.id) {}

std::string LayerCorrector::hear(CorrectionMap map) {
  const std::string defect = defectOf(map, toolpath_);
  if (!defect.empty()) return "the map " + defect;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (decisions_.empty() || map.layer > decisions_.back().layer) {
      (isCoasting(map) ? coasting_ : heard_)[map.layer] = std::move(map);
      return {};
    }
    if (isCoasting(map)) return {};  // nobody waits for it any more
    if (!trims(map))
      return "the map of layer " + std::to_string(map.layer) + " comes when that layer is on its way";
  }
  return hearTrim(std::move(map));
}

/// A layer deposited as planned, or by its coasting map, was reported as such to the loop: no later map trims
/// it.
bool LayerCorrector::trims(const CorrectionMap& map) const {
  const LayerDecision& last = decisions_.back();
  const bool is_by_map = !last.digest.empty() && !last.is_coasting;
  return map.layer == last.layer && is_by_map && map.sequence > last.sequence;
}

/// A map is written before the line that it holds from, which must not wait for a disk.
std::string LayerCorrector::hearTrim(CorrectionMap map) {
  try {
    CorrectionMap ready = led(map);
    record_.keep(laterRow(map, 0), map);
    const std::lock_guard<std::mutex> lock(mutex_);
    trim_ = Trim{std::move(map), std::move(ready)};
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

void LayerCorrector::takeTrim(std::uint64_t line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  next_line_ = line + 1;
  const std::optional<Trim> trim = std::exchange(trim_, std::nullopt);
  if (!trim || !trims(trim->map)) return;
  corrector_.trim(trim->led);
  last_amount_ = lastAmount(trim->map, toolpath_.toolpath.layers[trim->map.layer]);
  const AppliedRow row = laterRow(trim->map, line);
  record_.add(row);
  decisions_.push_back({row.layer, row.sequence, row.digest, {}, 0.0, line, true});
}

std::string LayerCorrector::awaitPlan(const std::string& plan_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string refusal = refusalOfPlan(plan_id, toolpath_.id, awaited_);
  is_planning_ = is_planning_ || refusal.empty();
  return refusal;
}

void LayerCorrector::dropPlan() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_planning_ = false;
}

std::optional<std::size_t> LayerCorrector::awaitedLayer() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return awaited_;
}

bool LayerCorrector::isKnown(std::int32_t layer) {
  if (layer < 0) return true;
  const auto number = static_cast<std::size_t>(layer);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!decisions_.empty() && number <= decisions_.back().layer) return true;
  if (is_planning_) return false;
  const auto found = heard_.find(number);
  const bool is_there = found != heard_.end();
  const bool is_awaited = !is_there && (number > 0 || first_ == FirstMap::Awaited);
  if (is_awaited)
    awaited_ = number;
  else
    apply({number, 0, {}, {}}, is_there ? &found->second : nullptr);
  return !is_awaited;
}

void LayerCorrector::decide(std::int32_t layer) {
  if (layer < 0 || isKnown(layer)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!is_planning_) apply({static_cast<std::size_t>(layer), 0, {}, {}, settings_.loop.wait_s}, nullptr);
}

/// As the program has it.
CorrectionMap LayerCorrector::led(const CorrectionMap& map) const {
  const ToolpathLayer& of_map = toolpath_.toolpath.layers[map.layer];
  CorrectionMap ready = ledMap(map, of_map, feederOf(settings_.loop), settings_.loop);
  ready.toolpath_id = programmed_id_;
  return ready;
}

void LayerCorrector::use(const CorrectionMap& map, const CorrectionMap& ready) {
  corrector_.add(ready);
  last_amount_ = lastAmount(map, toolpath_.toolpath.layers[map.layer]);
  // A path shorter than a cell has a station distance of its own.
  double greatest_mm = 0.0;
  for (const PathCorrection& path : map.paths) greatest_mm = std::max(greatest_mm, path.spacing_mm);
  if (greatest_mm > 0.0) station_mm_ = greatest_mm;
}

/// A step would ask of the feeder what it cannot follow. For one with a delay, what it gets at the end of the
/// layer before was commanded for a beginning that this layer does not have: nothing is known to fade from.
/// @return the digest of the map by which the amount fades; empty if there is nothing to fade
std::string LayerCorrector::fade(std::size_t layer) {
  if (last_amount_ == 0.0 || settings_.loop.dead_time_s > 0.0 || settings_.loop.lag_s > 0.0) return {};
  try {
    CorrectionMap map =
        fadingMap(toolpath_.toolpath.layers[layer], layer, last_amount_, station_mm_, settings_.loop);
    map.toolpath_id = toolpath_.id;
    use(map, led(map));
    std::string digest = digestOf(map);
    record_.keep({layer, 0, digest}, map);
    return digest;
  } catch (const Error&) {
    return {};  // it begins as planned
  }
}

/// A feeder with a delay was commanded for another beginning: nothing is known to go over from.
/// @return the digest of the map as it is applied; empty if there is no coasting map that can be
std::string LayerCorrector::coast(LayerDecision& decision) {
  const auto coasting = coasting_.find(decision.layer);
  if (coasting == coasting_.end() || coasting->second.paths.empty()) return {};
  try {
    const bool is_delayed = settings_.loop.dead_time_s > 0.0 || settings_.loop.lag_s > 0.0;
    const ToolpathLayer& layer = toolpath_.toolpath.layers[decision.layer];
    const CorrectionMap map =
        is_delayed ? coasting->second : fadedMap(coasting->second, layer, last_amount_, settings_.loop);
    use(map, led(map));
    std::string digest = digestOf(map);
    record_.keep({decision.layer, 0, digest}, map);
    decision.digest = digestOf(coasting->second);
    decision.is_coasting = true;
    return digest;
  } catch (const Error&) {
    return {};  // it fades
  }
}

/// A map that cannot be applied leaves its layer as planned: the print goes on.
void LayerCorrector::apply(LayerDecision decision, const CorrectionMap* map) {
  const std::size_t layer = decision.layer;
  decision.from_line = next_line_;
  try {
    if (map != nullptr) {
      use(*map, led(*map));
      decision.sequence = map->sequence;
      decision.digest = digestOf(*map);
      record_.keep({layer, map->sequence, decision.digest}, *map);
    }
  } catch (const Error& error) {
    decision.refusal = error.what();
  }
  std::string digest = decision.digest;
  if (digest.empty()) digest = coast(decision);
  if (digest.empty()) digest = fade(layer);
  record_.add({layer, decision.sequence, digest, decision.from_line});
  decisions_.push_back(std::move(decision));
  awaited_.reset();
  trim_.reset();
  heard_.erase(heard_.begin(), heard_.upper_bound(layer));
  coasting_.erase(coasting_.begin(), coasting_.upper_bound(layer));
}

/// A job that fails before its first line leaves the record of the one before.
std::string LayerCorrector::revised(std::string_view line, std::uint64_t number) {
  beginRecord();
  takeTrim(number);
  std::string out;
  corrector_.read(line, number, out);
  return out;
}

std::optional<RevisionRecord> LayerCorrector::record() const {
  const std::optional<RecordedJob> of = record_.of();
  if (!of) return std::nullopt;
  return RevisionRecord{std::filesystem::absolute(record_.folder()).string(), of->job,
                        feedingText(settings_.loop)};
}

std::vector<LayerDecision> LayerCorrector::decisions() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return decisions_;
}

}  // namespace lamina
