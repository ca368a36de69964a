// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corrected_stream.hpp"

#include <cstdio>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Programs share one retraction among retracted paths that follow one another.
bool isPulledBack(const Toolpath& toolpath, std::size_t layer) {
  const auto& after = toolpath.layers[layer].paths;
  if (after.empty() || !after.front().process.is_retracted) return false;
  for (std::size_t below = layer; below-- > 0;)
    if (!toolpath.layers[below].paths.empty())
      return toolpath.layers[below].paths.back().process.is_retracted;
  return false;
}

void requireFirstTool(const Toolpath& toolpath) {
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k)
    for (const Path& path : toolpath.layers[k].paths)
      if (path.tool != 0)
        throw InvalidInput("layer " + std::to_string(k) + " is deposited by tool " +
                           std::to_string(path.tool) + "; expected one tool, to go over to a plan");
}

}  // namespace

std::shared_ptr<LayerCorrector> CorrectedStream::corrector() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return corrector_;
}

std::string CorrectedStream::hear(CorrectionMap map) {
  std::shared_ptr<LayerCorrector> hearing;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    hearing = next_ ? next_->corrector : corrector_;
  }
  return hearing->hear(std::move(map));
}

std::string CorrectedStream::goOverTo(const std::string& plan_id, const PlanWriter& write) {
  const std::shared_ptr<LayerCorrector> present = corrector();
  std::string refusal = present->awaitPlan(plan_id);
  const std::optional<std::size_t> layer = present->awaitedLayer();
  if (!refusal.empty() || !layer) return refusal;
  PlannedProgram plan = write(*present, *layer);
  const std::lock_guard<std::mutex> lock(mutex_);
  // The same plan may have come twice, and have been gone over to while it was written again.
  if (next_ || corrector_ != present) return "the machine goes over to another plan already";
  next_ = std::move(plan);
  return {};
}

bool CorrectedStream::isFollowing(const std::string& toolpath_id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return corrector_->plannedId() == toolpath_id || (next_ && next_->corrector->plannedId() == toolpath_id);
}

std::string CorrectedStream::takeRecordFailure() {
  std::string failure = recordFailure();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure == failure_taken_) return {};
  failure_taken_ = failure;
  return failure;
}

std::optional<StreamableProgram> CorrectedStream::successor(std::int32_t /*layer*/) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!next_) return std::nullopt;
  collectDecisions();
  collected_ = 0;
  PlannedProgram next = *std::move(next_);
  next_.reset();
  corrector_ = std::move(next.corrector);
  return std::move(next.program);
}

void CorrectedStream::collectDecisions() {
  const std::vector<LayerDecision> all = corrector_->decisions();
  for (; collected_ < all.size(); ++collected_)
    decisions_.push_back({corrector_->plannedId(), all[collected_]});
}

std::vector<StreamDecision> CorrectedStream::takeDecisions() {
  const std::lock_guard<std::mutex> lock(mutex_);
  collectDecisions();
  return std::exchange(decisions_, {});
}

ProgramSettings settingsToGoOn(ProgramSettings settings, const Toolpath& left, std::size_t layer) {
  requireFirstTool(left);
  settings.start_code.clear();
  if (!isPulledBack(left, layer) || !(settings.retraction_length_mm > 0.0)) return settings;
  constexpr double kSecondsPerMinute = 60.0;
  char push[96];
  std::snprintf(push, sizeof push, "M83\nG1 E%.5f F%.3f", settings.retraction_length_mm,
                kSecondsPerMinute * settings.retraction_feed_mm_s);
  settings.start_code = push;
  return settings;
}

}  // namespace lamina
