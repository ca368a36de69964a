// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/height_loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "control/run_stretches.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/path_low_pass.hpp"
#include "lamina/control/pressed_law.hpp"

namespace lamina {
namespace {

constexpr double kBedSigma = 0.05;       // mm
constexpr double kNearKnown = 2.0;       // standard deviations of the low-pass
constexpr double kPatchAgreement = 4.0;  // standard deviations of a point
constexpr double kLeastSpread = 0.01;
constexpr double kGreatestSpread = 0.5;

/// Mean gain by region of a layer.
std::array<double, 3> regionGains(const LayerCells& cells, const std::vector<CellEstimate>& estimates) {
  std::array<double, 3> sums{};
  std::array<double, 3> counts{};
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto region = static_cast<std::size_t>(cells.region[i]);
    sums[region] += estimates[i].gain();
    counts[region] += 1.0;
    sum += estimates[i].gain();
  }
  const double mean = cells.size() > 0 ? sum / static_cast<double>(cells.size()) : 1.0;
  for (std::size_t r = 0; r < sums.size(); ++r) sums[r] = counts[r] > 0.0 ? sums[r] / counts[r] : mean;
  return sums;
}

double meanKnownError(const std::vector<CellEstimate>& estimates) {
  double sum = 0.0;
  double count = 0.0;
  for (const CellEstimate& cell : estimates) {
    if (!cell.isKnown()) continue;
    sum += cell.error();
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// The nearest known cell of the same run for each cell, itself if it is known; its own number where none is
/// within reach.
std::vector<std::size_t> nearestKnown(const LayerCells& cells, const std::vector<CellEstimate>& estimates,
                                      double reach_mm) {
  std::vector<std::size_t> nearest(cells.size());
  for (const CellRun& run : cells.runs) {
    const std::size_t end = run.first + run.count;
    for (std::size_t i = run.first; i < end; ++i) nearest[i] = i;
    std::size_t last = end;
    const auto offer = [&](std::size_t i) {
      if (estimates[i].isKnown()) {
        last = i;
        nearest[i] = i;
        return;
      }
      if (last == end) return;
      const double way = std::abs(cells.along_mm[i] - cells.along_mm[last]);
      const double best =
          nearest[i] == i ? reach_mm : std::abs(cells.along_mm[i] - cells.along_mm[nearest[i]]);
      if (way < best || (nearest[i] == i && way <= reach_mm)) nearest[i] = last;
    };
    for (std::size_t i = run.first; i < end; ++i) offer(i);
    last = end;
    for (std::size_t i = end; i-- > run.first;) offer(i);
  }
  return nearest;
}

std::vector<double> errorsOf(const std::vector<CellEstimate>& estimates) {
  std::vector<double> errors;
  errors.reserve(estimates.size());
  for (const CellEstimate& cell : estimates) errors.push_back(cell.error());
  return errors;
}

std::vector<double> gainsOf(const std::vector<CellEstimate>& estimates) {
  std::vector<double> gains;
  gains.reserve(estimates.size());
  for (const CellEstimate& cell : estimates) gains.push_back(cell.gain());
  return gains;
}

std::vector<double> carried(const std::vector<std::uint32_t>& below, const std::vector<double>& values,
                            double otherwise) {
  std::vector<double> taken;
  taken.reserve(below.size());
  for (const std::uint32_t cell : below) taken.push_back(cell == kNoCellBelow ? otherwise : values[cell]);
  return taken;
}

std::vector<std::size_t> contestedCells(const std::vector<CellEstimate>& estimates) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < estimates.size(); ++i)
    if (estimates[i].contested()) cells.push_back(i);
  return cells;
}

}  // namespace

HeightLoop::HeightLoop(const LoopSettings& settings, const Eigen::Vector3d& normal)
    : settings_(settings), normal_(normal), spread_(settings.growth_spread) {}

void HeightLoop::beginLayer(LayerCells cells) { beginLayer(std::move(cells), {}); }

void HeightLoop::beginLayer(LayerCells cells, std::vector<double> learnt) {
  if (!learnt.empty() && learnt.size() != cells.size())
    throw InvalidInput("there are " + std::to_string(learnt.size()) +
                       " amounts learnt; expected one for each of the layer's " +
                       std::to_string(cells.size()) + " cells");
  std::vector<double> learnt_below(cells.size(), 0.0);
  std::vector<CellEstimate> estimates;
  estimates.reserve(cells.size());
  if (layers_begun_ == 0) {
    estimates.assign(cells.size(), CellEstimate(0.0, kBedSigma, 1.0));
    before_clouds_ = {errorsOf(estimates), gainsOf(estimates)};
  } else {
    const std::vector<std::uint32_t> below = cellsBelow(cells, cells_, normal_);
    const std::array<double, 3> gains = regionGains(cells_, estimates_);
    CellEstimate guess;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      guess.setGain(gains[static_cast<std::size_t>(cells.region[i])]);
      estimates.push_back(below[i] == kNoCellBelow ? guess : estimates_[below[i]]);
    }
    before_clouds_.error_mm = carried(below, before_clouds_.error_mm, 0.0);
    before_clouds_.gain = carried(below, before_clouds_.gain, gains[0]);
    if (!learnt_.empty()) learnt_below = carried(below, learnt_, meanOverCells(cells_, learnt_));
    deficit_ = carried(below, deficit_, 0.0);
    before_deficit_ = carried(below, before_deficit_, 0.0);
  }
  deficit_.resize(cells.size(), 0.0);
  before_deficit_.resize(cells.size(), 0.0);
  is_section_seen_.assign(cells.size(), false);
  applied_.assign(cells.size(), 0.0);
  cells_ = std::move(cells);
  estimates_ = std::move(estimates);
  contested_ = contestedCells(estimates_);
  learnt_ = std::move(learnt);
  if (!learnt_.empty()) takeGainsOver(learnt_below);
  clouds_below_ = clouds_;
  ++layers_begun_;
  clouds_ = surprises_ = repeats_ = 0;
  gain_ratio_ = 1.0;
  surprise_ = repeat_surprise_ = excess_ = limited_share_ = 0.0;
}

/// From a layer below whose gains stand for other amounts learnt.
void HeightLoop::takeGainsOver(const std::vector<double>& learnt_below) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double ratio = (1.0 + learnt_below[i]) / (1.0 + learnt_[i]);
    estimates_[i].setGain(estimates_[i].gain() * ratio);
    before_clouds_.gain[i] =
        std::clamp(before_clouds_.gain[i] * ratio, CellEstimate::kLeastGain, CellEstimate::kGreatestGain);
  }
}

LayerKnowledge HeightLoop::filled(std::vector<double> error_mm, std::vector<double> gain) const {
  const double mean = meanKnownError(estimates_);
  const std::vector<std::size_t> nearest =
      nearestKnown(cells_, estimates_, kNearKnown * settings_.low_pass_mm);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (estimates_[i].isKnown()) continue;
    error_mm[i] = nearest[i] == i ? mean : error_mm[nearest[i]];
    if (nearest[i] != i) gain[i] = gain[nearest[i]];
  }
  return {std::move(error_mm), std::move(gain)};
}

LayerKnowledge HeightLoop::knowledge() const { return filled(errorsOf(estimates_), gainsOf(estimates_)); }

std::optional<double> HeightLoop::seenError() const {
  std::vector<double> seen;
  std::vector<double> error;
  seen.reserve(cells_.size());
  error.reserve(cells_.size());
  for (const CellEstimate& cell : estimates_) {
    seen.push_back(cell.isSeen() ? 1.0 : 0.0);
    error.push_back(cell.isSeen() ? cell.error() : 0.0);
  }
  const double coverage = meanOverCells(cells_, seen);
  if (!(coverage > 0.0) || coverage < settings_.min_coverage) return std::nullopt;
  return meanOverCells(cells_, error) / coverage;
}

LayerCorrection HeightLoop::asked(LoopState state, const LayerKnowledge& known,
                                  const std::vector<double>& deficit) const {
  if (settings_.process == LoopProcess::Pressed)
    return pressedCorrection(cells_, {deficit, known.gain}, settings_);
  return state == LoopState::Coasting ? learntCorrection(cells_, known.gain, settings_)
                                      : freeCorrection(cells_, known, settings_);
}

LayerCorrection HeightLoop::correction(LoopState state) const {
  const bool is_learnt_only = layers_begun_ <= static_cast<std::size_t>(settings_.first_layers);
  const bool corrects =
      state == LoopState::Active || (state == LoopState::Coasting && settings_.process == LoopProcess::Free);
  if (is_learnt_only && corrects && !learnt_.empty()) {
    LayerCorrection learnt = asked(LoopState::Coasting, knowledge(), deficit_);
    boundByClouds(learnt, LoopState::Coasting);
    return learnt;
  }
  if (is_learnt_only || !corrects) {
    LayerCorrection none;
    none.amount.assign(cells_.size(), 0.0);
    return none;
  }
  LayerCorrection correction = asked(state, knowledge(), deficit_);
  boundByClouds(correction, state);
  return correction;
}

/// Bounded is the difference to what the law had asked for had nothing been seen: that a layer is corrected
/// more than the one before for being predicted too low needs no cloud.
void HeightLoop::boundByClouds(LayerCorrection& correction, LoopState state) const {
  const double range =
      settings_.process == LoopProcess::Pressed ? 2.0 * kPressedAmount : amountRange(settings_);
  const double bound = kCloudShare * range * static_cast<double>(clouds_below_);
  if (bound >= range) return;
  const LayerCorrection before =
      asked(state, filled(before_clouds_.error_mm, before_clouds_.gain), before_deficit_);
  for (std::size_t i = 0; i < correction.amount.size(); ++i)
    correction.amount[i] =
        std::clamp(correction.amount[i], before.amount[i] - bound, before.amount[i] + bound);
}

void HeightLoop::lay(const LayerCorrection& correction) {
  lay(correction, std::vector<double>(cells_.size(), 0.0));
}

void HeightLoop::lay(const LayerCorrection& correction, const std::vector<double>& nozzle_error_mm) {
  requireOnePerCell("amounts", correction.amount.size());
  requireOnePerCell("errors of the nozzle", nozzle_error_mm.size());
  limited_share_ = correction.limited_share;
  applied_ = correction.amount;
  is_section_seen_.assign(cells_.size(), false);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const DepositedGrowth growth{cells_.height_mm[i], correction.amount[i], nozzle_error_mm[i]};
    if (settings_.process == LoopProcess::Free)
      estimates_[i].lay(growth, spread_);
    else
      estimates_[i].press(growth, spread_);
  }
  before_clouds_ = {errorsOf(estimates_), gainsOf(estimates_)};
  before_deficit_ = deficit_;
}

void HeightLoop::relay(const LayerCorrection& correction) {
  requireOnePerCell("amounts", correction.amount.size());
  for (std::size_t i = 0; i < cells_.size() && settings_.process == LoopProcess::Free; ++i) {
    estimates_[i].relay(cells_.height_mm[i], applied_[i], correction.amount[i]);
    before_clouds_.error_mm[i] -=
        before_clouds_.gain[i] * cells_.height_mm[i] * (correction.amount[i] - applied_[i]);
  }
  limited_share_ = correction.limited_share;
  applied_ = correction.amount;
}

ReadingOutcome HeightLoop::see(std::size_t cell, const CellReading& reading) {
  requireCell(cell);
  CellEstimate& estimate = estimates_[cell];
  const bool was_seen = estimate.isSeen();
  const bool was_known = estimate.isKnown();
  const double prior = estimate.variance();
  const double expected = estimate.gain() * cells_.height_mm[cell];
  const bool was_contested = estimate.contested().has_value();
  const ReadingOutcome outcome = estimate.see(reading, settings_.reading_correlation);
  if (!was_contested && estimate.contested()) contested_.push_back(cell);
  cloud_sigma_mm_ = std::max(cloud_sigma_mm_, reading.sigma_mm);
  if (outcome.use != ReadingUse::Used) return outcome;
  if (was_seen) {
    repeat_surprise_ += outcome.surprise;
    ++repeats_;
    return outcome;
  }
  if (!was_known) return outcome;  // of a guess
  // The first reading of a cell shows its growth, those that follow show the sensor alone.
  const double noise = readingVariance(reading, settings_.reading_correlation);
  const double growth = spread_ * expected;
  surprise_ += outcome.surprise;
  excess_ += (outcome.surprise * (prior + noise) - (prior + noise) + growth * growth) / (expected * expected);
  ++surprises_;
  return outcome;
}

void HeightLoop::seeDeficit(std::size_t cell, double share) {
  requireCell(cell);
  if (!std::isfinite(share)) return;
  deficit_[cell] = share;
  is_section_seen_[cell] = true;
}

void HeightLoop::requireCell(std::size_t cell) const {
  if (cell >= cells_.size())
    throw InvalidInput("a reading is of cell " + std::to_string(cell) + "; expected one of the layer's " +
                       std::to_string(cells_.size()));
}

void HeightLoop::requireOnePerCell(const std::string& what, std::size_t count) const {
  if (count != cells_.size())
    throw InvalidInput("a layer is deposited with " + std::to_string(count) + " " + what +
                       "; expected one for each of its " + std::to_string(cells_.size()) + " cells");
}

void HeightLoop::endCloud() {
  ++clouds_;
  believePatches();
  cloud_sigma_mm_ = 0.0;
}

/// What they had said of the layers below is in the prediction still: that was before.
void HeightLoop::forgetClouds() {
  const bool is_pressed = settings_.process == LoopProcess::Pressed;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    CellEstimate& cell = estimates_[i];
    // A cell of a free process that became known by these clouds has had no growth commanded since.
    cell.forget({before_clouds_.error_mm[i], spread_ * cell.gain() * cells_.height_mm[i],
                 is_pressed || cell.commanded() > 0.0});
  }
  deficit_ = before_deficit_;
  is_section_seen_.assign(cells_.size(), false);
  contested_.clear();
  clouds_ = surprises_ = repeats_ = 0;
  surprise_ = repeat_surprise_ = excess_ = cloud_sigma_mm_ = 0.0;
}

void HeightLoop::believePatches() {
  const auto agrees = [&](std::size_t a, std::size_t b) {
    const auto here = estimates_[a].claimed();
    const auto there = estimates_[b].claimed();
    return here && there && std::abs(*here - *there) <= kPatchAgreement * cloud_sigma_mm_;
  };
  for (const std::size_t cell : contested_) {
    if (!estimates_[cell].contested()) continue;
    const CellRun& run = cells_.runs[runOf(cells_, cell)];
    const CellStretch stretch = stretchAround(run, cell, agrees);
    const double length = static_cast<double>(stretch.count) * run.cellLength();
    if (stretch.count < 2 || length < cells_.width_mm[stretch.first]) continue;
    for (std::size_t i = 0; i < stretch.count; ++i) estimates_[cellOf(run, stretch, i)].believe();
  }
  contested_.erase(std::remove_if(contested_.begin(), contested_.end(),
                                  [&](std::size_t cell) { return !estimates_[cell].contested(); }),
                   contested_.end());
}

void HeightLoop::replan(double raised_mm, double flow) {
  for (CellEstimate& cell : estimates_) cell.replan(raised_mm, flow);
  for (double& error : before_clouds_.error_mm) error += raised_mm;
  for (double& gain : before_clouds_.gain)
    gain = std::clamp(gain * flow, CellEstimate::kLeastGain, CellEstimate::kGreatestGain);
}

StoredHeights HeightLoop::stored() const {
  StoredHeights stored{{}, deficit_, before_clouds_, before_deficit_, spread_, layers_begun_, clouds_};
  stored.estimates.reserve(estimates_.size());
  for (const CellEstimate& cell : estimates_) stored.estimates.push_back(cell.stored());
  return stored;
}

void HeightLoop::resume(LayerCells cells, const StoredHeights& stored, std::vector<double> learnt) {
  for (const std::size_t count :
       {stored.estimates.size(), stored.deficit.size(), stored.before_deficit.size(),
        stored.before_clouds.error_mm.size(), stored.before_clouds.gain.size()})
    if (count != cells.size())
      throw InvalidInput("what was kept of layer " + std::to_string(cells.layer) + " is of " +
                         std::to_string(count) + " cells; expected " + std::to_string(cells.size()));
  cells_ = std::move(cells);
  learnt_ = std::move(learnt);
  estimates_.clear();
  for (const StoredEstimate& cell : stored.estimates) estimates_.emplace_back(cell);
  contested_ = contestedCells(estimates_);
  deficit_ = stored.deficit;
  before_clouds_ = stored.before_clouds;
  before_deficit_ = stored.before_deficit;
  spread_ = stored.spread;
  layers_begun_ = stored.layers_begun;
  clouds_ = stored.clouds;
}

LayerFigures HeightLoop::endLayer() {
  const LayerFigures before = figures();
  if (settings_.process == LoopProcess::Pressed)
    learn(sectionGains());
  else if (before.is_measured)
    learn(heightGains());
  return figures();
}

std::vector<MeasuredGain> HeightLoop::heightGains() {
  std::vector<MeasuredGain> gains(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i)
    gains[i] = estimates_[i].takeMeasuredGain().value_or(MeasuredGain());
  return gains;
}

std::vector<MeasuredGain> HeightLoop::sectionGains() const {
  std::vector<MeasuredGain> gains(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (is_section_seen_[i]) gains[i] = {(1.0 - deficit_[i]) / (1.0 + applied_[i]), cells_.height_mm[i]};
  return gains;
}

/// What several layers show together is learnt as if each had shown it.
void HeightLoop::learn(const std::vector<MeasuredGain>& measured) {
  std::vector<double> gains = gainsOf(estimates_);
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (measured[i].commanded_mm > 0.0) gains[i] = measured[i].gain;
  const std::vector<double> smooth = lowPassed(gains, cells_, settings_.low_pass_mm);
  double grown_mm = 0.0;
  double learnt_mm = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (measured[i].commanded_mm <= 0.0) continue;
    const double layers = std::max(1.0, measured[i].commanded_mm / cells_.height_mm[i]);
    const double gain = estimates_[i].gain();
    const double share = 1.0 - std::pow(1.0 - settings_.learning, layers);
    estimates_[i].setGain(gain + share * (smooth[i] - gain));
    grown_mm += measured[i].gain * measured[i].commanded_mm;
    learnt_mm += estimates_[i].gain() * measured[i].commanded_mm;
  }
  if (learnt_mm > 0.0 && grown_mm > 0.0) gain_ratio_ = grown_mm / learnt_mm;
  learnSpread();
}

void HeightLoop::learnSpread() {
  if (surprises_ == 0) return;
  const double squared = std::max(0.0, excess_ / static_cast<double>(surprises_));
  const double learnt = spread_ * spread_ + settings_.learning * (squared - spread_ * spread_);
  spread_ = std::clamp(std::sqrt(std::max(0.0, learnt)), kLeastSpread, kGreatestSpread);
}

/// Of a measured layer by the cells seen: what is predicted of the others shows nothing.
void HeightLoop::judgeErrors(LayerFigures& figures, const std::vector<double>& seen) const {
  const std::vector<double> all(cells_.size(), 1.0);
  const std::vector<double>& weights = figures.is_measured ? seen : all;
  std::vector<double> errors(cells_.size());
  std::vector<double> squares(cells_.size());
  std::vector<double> deviates(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double error = estimates_[i].error();
    errors[i] = weights[i] * error;
    squares[i] = weights[i] * error * error;
    deviates[i] = std::abs(error) > settings_.alarm_layers * cells_.height_mm[i] ? weights[i] : 0.0;
  }
  const double whole = meanOverCells(cells_, weights);
  if (!(whole > 0.0)) return;
  figures.mean_error_mm = meanOverCells(cells_, errors) / whole;
  const double mean_square = meanOverCells(cells_, squares) / whole;
  figures.rmse_mm = std::sqrt(mean_square);
  figures.flatness_mm = std::sqrt(std::max(0.0, mean_square - figures.mean_error_mm * figures.mean_error_mm));
  figures.deviating_share = meanOverCells(cells_, deviates) / whole;
}

LayerFigures HeightLoop::figures() const {
  LayerFigures result;
  result.layer = cells_.layer;
  result.limited_share = limited_share_;
  result.spread = spread_;
  if (cells_.size() == 0) return result;
  std::vector<double> seen(cells_.size());
  std::vector<double> is_read(cells_.size());
  double contested = 0.0;
  result.height_mm = meanOverCells(cells_, cells_.height_mm);
  result.gain_ratio = gain_ratio_;
  result.gain_mean = meanOverCells(cells_, gainsOf(estimates_));
  result.gain_least = result.gain_greatest = estimates_.front().gain();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const CellEstimate& cell = estimates_[i];
    seen[i] = cell.isSeen() ? 1.0 : 0.0;
    is_read[i] = cell.isSeen() || cell.contested() ? 1.0 : 0.0;
    contested += cell.contested() && !cell.isSeen() ? 1.0 : 0.0;
    result.gain_least = std::min(result.gain_least, cell.gain());
    result.gain_greatest = std::max(result.gain_greatest, cell.gain());
  }
  result.coverage = meanOverCells(cells_, seen);
  result.is_measured = result.coverage > 0.0 && result.coverage >= settings_.min_coverage;
  judgeErrors(result, seen);
  const double read = std::accumulate(is_read.begin(), is_read.end(), 0.0);
  if (read > 0.0) result.contested_share = contested / read;
  if (surprises_ > 0) result.consistency = surprise_ / static_cast<double>(surprises_);
  if (repeats_ > 0) result.repeatability = repeat_surprise_ / static_cast<double>(repeats_);
  return result;
}

}  // namespace lamina
