// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/laid_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/run/cell_corrections.hpp"
#include "control/run/layer_ground.hpp"
#include "lamina/control/layer_law.hpp"
#include "lamina/control/z_follow.hpp"

namespace lamina {
namespace {

constexpr double kShiftBack = 0.2;  // layers per layer, as the nozzle's height is followed

/// What is deposited without cells is as planned.
double lastOf(const LayerCells& cells, const std::vector<double>& amount) {
  return cells.ends_with_other ? 0.0 : amount.back();
}

}  // namespace

void LaidLayer::carryOver(double last_amount, double mean_shift_mm) {
  last_amount_ = last_amount;
  mean_shift_mm_ = mean_shift_mm;
}

void LaidLayer::decide(const HeightLoop& loop, LoopState state, const LoopRunSettings& settings) {
  state_ = state;
  coasting_.reset();
  is_map_missed_ = is_wholly_missed_ = false;
  first_amount_ = last_amount_;
  laid_ = wanted(loop, state, settings.loop);
  shiftNozzle(loop, state, settings);
  realise(loop.cells(), settings.loop);
}

void LaidLayer::layAsPlanned(const LayerCells& cells, const LoopSettings& settings) {
  state_ = LoopState::Coasting;
  laid_.amount.assign(cells.size(), 0.0);
  laid_.limited_share = 0.0;
  shift_mm_.assign(cells.size(), 0.0);
  mean_shift_mm_ = 0.0;
  realise(cells, settings);
}

void LaidLayer::trim(const LayerCells& cells, std::vector<double> amount, const LoopSettings& settings) {
  laid_.amount = std::move(amount);
  realise(cells, settings);
}

void LaidLayer::layMapFrom(const LayerCells& cells, std::size_t cell, const LoopSettings& settings,
                           Without without) {
  is_map_missed_ = cell > 0;
  is_wholly_missed_ = cell == cells.size();
  laid_ = mapped_.correction;
  shift_mm_ = mapped_.shift_mm;
  state_ = mapped_.state;
  const Mapped planned = {{std::vector<double>(cells.size(), 0.0), 0.0},
                          std::vector<double>(cells.size(), 0.0),
                          LoopState::Coasting};
  const Mapped& other = without == Without::OwnMap && coasting_ ? *coasting_ : planned;
  if (is_map_missed_) {
    const std::vector<double> before(cells.size(), first_amount_);
    const std::vector<double> faded = fadedCorrection(cells, before, other.correction.amount, 0, settings);
    laid_.amount = fadedCorrection(cells, faded, mapped_.correction.amount, cell, settings);
  }
  std::copy_n(other.shift_mm.begin(), cell, shift_mm_.begin());
  if (is_wholly_missed_) {
    laid_.limited_share = other.correction.limited_share;
    state_ = LoopState::Coasting;
  }
  mean_shift_mm_ = meanOverCells(cells, shift_mm_);
  last_amount_ = lastOf(cells, laid_.amount);
}

bool LaidLayer::isAsPlanned() const { return isAllZero(laid_.amount) && isAllZero(shift_mm_); }

CorrectionMap LaidLayer::map(const LayerCells& cells, const std::string& toolpath_id,
                             std::uint64_t sequence) const {
  if (told_.amount.empty() && told_.dz_mm.empty()) return {toolpath_id, cells.layer, sequence, {}};
  return correctionMap(cells, told_, toolpath_id, sequence);
}

/// Of a loop that no longer corrects: what the layer before ended with fades.
LayerCorrection LaidLayer::wanted(const HeightLoop& loop, LoopState state,
                                  const LoopSettings& settings) const {
  LayerCorrection correction = loop.correction(state);
  if (isCorrecting(state) || last_amount_ == 0.0) return correction;
  const std::vector<double> from(correction.amount.size(), last_amount_);
  correction.amount = fadedCorrection(loop.cells(), from, correction.amount, 0, settings);
  return correction;
}

/// Back to the plan, a little in each layer, unless the loop is active.
void LaidLayer::shiftNozzle(const HeightLoop& loop, LoopState state, const LoopRunSettings& settings) {
  const LayerCells& cells = loop.cells();
  const double height = meanOverCells(cells, cells.height_mm);
  if (state == LoopState::Active) {
    const NozzleRoom room{height, highestCell(loop.estimates()), settings.head_clearance_mm};
    LayerKnowledge known = loop.knowledge();
    // Of a pressed layer that nobody saw the estimate is the nozzle's plane: it would take back the shift.
    if (settings.loop.process == LoopProcess::Pressed)
      known.error_mm.assign(cells.size(), loop.seenError().value_or(0.0));
    shift_mm_ = nozzleShift(cells, known, mean_shift_mm_, room, settings.loop);
  } else {
    const double step = kShiftBack * height;
    shift_mm_.assign(cells.size(), mean_shift_mm_ - std::clamp(mean_shift_mm_, -step, step));
  }
  mean_shift_mm_ = meanOverCells(cells, shift_mm_);
}

/// What the speeds that the machine may go leave of the correction is what is laid.
void LaidLayer::realise(const LayerCells& cells, const LoopSettings& settings) {
  RealisedCorrection result = realised(cells, laid_, shift_mm_, settings);
  laid_ = std::move(result.laid);
  told_ = std::move(result.told);
  mapped_ = {laid_, shift_mm_, state_};
  last_amount_ = lastOf(cells, laid_.amount);
}

std::vector<CellOutcome> LaidLayer::outcomes(const LayerCells& cells,
                                             const std::vector<CellEstimate>& estimates) const {
  std::vector<CellOutcome> outcomes;
  outcomes.reserve(cells.size());
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const CellEstimate& cell = estimates[i];
      outcomes.push_back({cells.middle[i], cell.error(), std::sqrt(cell.variance()), correction().amount[i],
                          cell.isSeen(), run.cellLength() * cells.tangent[i], cells.width_mm[i],
                          cell.gain()});
    }
  }
  return outcomes;
}

}  // namespace lamina
