// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/decimals.hpp"
#include "control/run/cloud_order.hpp"
#include "control/run/layer_ground.hpp"
#include "control/run/layer_trim.hpp"
#include "geometry/boxes.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/metal_split.hpp"
#include "lamina/control/run/run_calibration.hpp"
#include "lamina/control/z_follow.hpp"

namespace lamina {
namespace {

constexpr double kSecond = 1e9;              // ns
constexpr double kShiftBack = 0.2;           // layers per layer, as the nozzle's height is followed
constexpr double kLeastOffsetSigma = 0.001;  // s, better than which no stamps are
constexpr double kSteady = 0.5;              // s between clouds, above which their sensor may have turned

double secondsFrom(std::int64_t begin_ns, std::int64_t end_ns) {
  return static_cast<double>(end_ns - begin_ns) / kSecond;
}

bool isAllZero(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

/// Asks once for all layers what `metalSplit` refuses.
void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings) {
  if (settings.loop.speed_exponent == 0.0) return;
  for (std::size_t layer = 0; layer < toolpath.layers.size(); ++layer) {
    const LayerCells cells = layerCells(toolpath.layers[layer], layer, settings.cell_mm);
    metalSplit(cells, std::vector<double>(cells.size(), 0.0), PowerSource::Fixed, settings.loop);
  }
}

std::string reasonOf(const MissedMap& missed) {
  return "layer " + std::to_string(missed.layer) + " is deposited as planned, not by its map: " +
         (missed.reason.empty() ? "none came within " + significantText(missed.waited_s, 3) + " s"
                                : missed.reason);
}

/// Height of the highest known cell above the planned ground of the layer [mm].
double highestCell(const std::vector<CellEstimate>& estimates) {
  double highest = -1e9;
  for (const CellEstimate& cell : estimates)
    if (cell.isKnown()) highest = std::max(highest, -cell.error());
  return highest;
}

}  // namespace

bool LoopRun::Earlier::operator()(const Event& a, const Event& b) const {
  if (a.stamp_ns != b.stamp_ns) return a.stamp_ns < b.stamp_ns;
  if (!a.cloud || !b.cloud) {
    if (a.cloud || b.cloud) return !a.cloud;
    return std::lexicographical_compare(a.tip.begin(), a.tip.end(), b.tip.begin(), b.tip.end());
  }
  return compared(*a.cloud, *b.cloud) < 0;
}

LoopRun::LoopRun(PlacedPart part, const LoopRunSettings& settings)
    : part_(std::move(part)),
      settings_(settings),
      part_from_bed_(part_.bed_from_part.inverse()),
      normal_(normalOfLayers(part_.toolpath)),
      progress_(part_.toolpath, settings.following),
      taught_(part_.toolpath, {part_.toolpath_id, part_.machine, settings.material}, settings),
      stability_(checkStart(part_.toolpath, part_.machine, settings)),
      atlas_(settings.sight.window_layers) {
  requireSpeeds(part_.toolpath, settings_);
  if (stability_.may_start) settings_.loop.low_pass_mm = stability_.low_pass_mm;
  loop_.emplace(settings_.loop, normal_);
  status_ = afterRequest(settings.request, stability_);
  beginLayer(0);
}

LoopRun::~LoopRun() = default;

void LoopRun::resume(const LoopMemory& memory) {
  const std::string difference = differenceOf(memory.identity, identity());
  if (!difference.empty()) throw InvalidInput("what was kept is of another print: " + difference);
  if (memory.layer >= part_.toolpath.layers.size())
    throw InvalidInput("what was kept is of layer " + std::to_string(memory.layer) +
                       "; expected one of the toolpath's " + std::to_string(part_.toolpath.layers.size()));
  LayerCells cells =
      layerCells(part_.toolpath.layers[memory.layer], memory.layer, settings_.cell_mm, normal_);
  HeightLoop loop(settings_.loop, normal_);
  loop.resume(cells, memory.heights, taught_.amountsOf(memory.layer));
  loop_ = std::move(loop);
  below_ = loop_->estimates();
  below_layer_ = memory.layer;
  status_ = stability_.may_start && memory.status.state != LoopState::Blocked
                ? memory.status
                : afterRequest(settings_.request, stability_);
  gain_at_check_ = memory.gain_at_check;
  last_amount_ = memory.last_amount;
  mean_shift_mm_ = memory.mean_shift_mm;
  news_ = {};
  progress_.resume(memory.layer + 1);
  atlas_.add(std::make_shared<const LayerCells>(std::move(cells)));
  beginLayer(memory.layer + 1);
  is_catching_up_ = true;
}

LoopMemory LoopRun::memory(std::size_t layer) const {
  return {identity(), layer, status_, gain_at_check_, last_amount_, mean_shift_mm_, loop_->stored()};
}

const LoopStatus& LoopRun::request(LoopRequest request) {
  if (status_.state == LoopState::Blocked) stability_ = checkNow();
  status_ = afterRequest(request, stability_);
  offset_left_ = {};
  return status_;
}

void LoopRun::recalibrate(const CellCalibration& known, LoopRequest request) {
  settings_.calibration = known;
  offset_left_ = {};
  stability_ = checkNow();
  if (stability_.may_start && stability_.low_pass_mm > settings_.loop.low_pass_mm) {
    stability_.may_start = false;
    stability_.reason += "; the low-pass of this print stays: it holds from the next one on";
  }
  const bool waits = status_.coasting_for == CoastingFor::TimeOffset || status_.state == LoopState::Blocked;
  const bool is_refused = !stability_.may_start && status_.state != LoopState::Off;
  if (waits || is_refused) status_ = afterRequest(request, stability_);
}

bool LoopRun::isCorrecting() const { return lamina::isCorrecting(status_.state); }

void LoopRun::observe(const StampedTip& pose) {
  ++counts_.poses;
  if (passed_ns_ && pose.stamp_ns < *passed_ns_) {
    ++counts_.poses_late;
    return;
  }
  latest_tip_ns_ = std::max(latest_tip_ns_.value_or(pose.stamp_ns), pose.stamp_ns);
  insert({pose.stamp_ns, pose.tip, nullptr});
}

void LoopRun::see(SensedCloud cloud) {
  ++counts_.clouds;
  if (passed_ns_ && cloud.stamp_ns < *passed_ns_) {
    ++counts_.clouds_late;
    return;
  }
  ++counts_.clouds_waiting;
  const std::int64_t stamp_ns = cloud.stamp_ns;
  insert({stamp_ns, Point3::Zero(), std::make_shared<const SensedCloud>(std::move(cloud))});
}

void LoopRun::insert(Event event) {
  latest_ns_ = std::max(latest_ns_.value_or(event.stamp_ns), event.stamp_ns);
  waiting_.insert(std::move(event));
  passUntil(*latest_ns_ - static_cast<std::int64_t>(settings_.reorder_s * kSecond));
}

void LoopRun::passUntil(std::int64_t stamp_ns) {
  while (!waiting_.empty() && waiting_.begin()->stamp_ns <= stamp_ns) {
    const Event event = std::move(waiting_.extract(waiting_.begin()).value());
    passed_ns_ = event.stamp_ns;
    if (event.cloud)
      onCloud(*event.cloud);
    else
      onTip(event.stamp_ns, event.tip);
  }
}

void LoopRun::passAll() {
  if (latest_ns_) passUntil(*latest_ns_);
}

void LoopRun::finish() {
  passAll();
  if (layer_ && loop_->cells().size() > 0 && cellsDeposited(0.0) == loop_->cells().size()) endLayer();
}

void LoopRun::hear(std::int64_t stamp_ns) {
  if (!latest_tip_ns_ || stamp_ns <= *latest_tip_ns_) return;
  const double blind_s = secondsFrom(*latest_tip_ns_, stamp_ns);
  // The last poses say whether the nozzle was scanning: nothing that comes brings them on any more.
  if (blind_s > settings_.loop.silence_s) passUntil(*latest_tip_ns_);
  watch(blind_s);
}

void LoopRun::missMap(const MissedMap& missed) {
  if (!layer_ || missed.layer < *layer_ || missed.layer >= part_.toolpath.layers.size()) return;
  if (missed.layer > *layer_) {
    missed_[missed.layer] = missed;
    return;
  }
  if (missed.held_from)
    return layMapFrom(cellsPassed(loop_->cells(), missed.held_from->path, missed.held_from->along_mm, 0.0));
  const bool is_otherwise = !isAllZero(laid_.amount) || !isAllZero(shift_mm_);
  if (is_otherwise || missed.waited_s > 0.0)
    take({status_, {{LoopAlarm::MapLate, LoopReaction::Coast, reasonOf(missed)}}});
  if (!is_otherwise) return;
  layMapFrom(loop_->cells().size());
}

void LoopRun::refuseTrim(std::size_t layer, const std::string& reason) {
  if (layer >= part_.toolpath.layers.size()) return;
  ++counts_.trims_refused;
  if (std::exchange(trim_refused_, layer) == layer) return;
  take({status_,
        {{LoopAlarm::MapLate, LoopReaction::Warn,
          "a further map of layer " + std::to_string(layer) + " is not used: " + reason}}});
}

/// Cells that went to the machine before their map were deposited as planned. The trim of the layer expected
/// otherwise, and would take the difference for an error.
void LoopRun::layMapFrom(std::size_t cell) {
  if (cell == 0 && !is_missed_) return;
  is_missed_ = cell > 0;
  trim_.reset();
  LayerCorrection laid = mapped_.correction;
  shift_mm_ = mapped_.shift_mm;
  deposited_in_ = mapped_.in;
  std::fill_n(laid.amount.begin(), cell, 0.0);
  std::fill_n(shift_mm_.begin(), cell, 0.0);
  if (cell == laid.amount.size()) {
    laid.limited_share = 0.0;
    deposited_in_ = LoopState::Coasting;
  }
  loop_->relay(laid);
  laid_ = std::move(laid);
  mean_shift_mm_ = meanOverCells(loop_->cells(), shift_mm_);
  last_amount_ = laid_.amount.back();
}

/// The nozzle where the plan has it: what the loop shifts it by is off.
Point3 LoopRun::correctedTip(const Point3& tip) const {
  if (!layer_ || progress_.place().layer != *layer_ || isAllZero(shift_mm_)) return tip;
  const PrintPlace& place = progress_.place();
  const auto& runs = loop_->cells().runs;
  const auto run = std::lower_bound(runs.begin(), runs.end(), place.path,
                                    [](const CellRun& each, std::size_t path) { return each.path < path; });
  if (run == runs.end() || run->path != place.path) return tip;
  const auto cell = static_cast<std::size_t>(std::max(0.0, place.along_mm / run->cellLength()));
  return tip - shift_mm_[run->first + std::min(cell, run->count - 1)] * normal_;
}

void LoopRun::onTip(std::int64_t stamp_ns, const Point3& tip) {
  is_moving_ = tip_ns_ && tip != tip_;
  const bool was_scanning = progress_.place().is_scanning;
  const PrintPlace& place = progress_.observe(correctedTip(part_from_bed_ * tip));
  if (!place.is_scanning || !was_scanning) silent_s_ = 0.0;
  if (place.is_scanning && was_scanning && is_moving_)
    silent_s_ += secondsFrom(std::max(*tip_ns_, cloud_ns_.value_or(*tip_ns_)), stamp_ns);
  tip_ns_ = stamp_ns;
  tip_ = tip;
  watch(0.0);
  while (layer_ && place.layer > *layer_) {
    const std::size_t done = *layer_;
    endLayer();
    beginLayer(done + 1);
  }
  if (progress_.isFound()) is_catching_up_ = false;
  leaveBehind(stamp_ns);
}

void LoopRun::onCloud(const SensedCloud& cloud) {
  --counts_.clouds_waiting;
  cloud_ns_ = cloud.stamp_ns;
  silent_s_ = 0.0;
  for (const auto& profile : cloud.profiles)
    if (is_moving_) stuck_.see(profile);
  watch(0.0);
  if (watched_.count(LoopAlarm::Stuck) > 0) {
    ++counts_.clouds_stuck;
    return;
  }
  ++counts_.clouds_read;
  senseMotion(cloud);
  if (layer_) readCloud(cloud);
}

void LoopRun::senseMotion(const SensedCloud& cloud) {
  const Point3 sensor = part_from_bed_ * cloud.bed_from_sensor.translation();
  const double span_s = sensor_ns_ ? secondsFrom(*sensor_ns_, cloud.stamp_ns) : 0.0;
  const bool is_steady = span_s > 0.0 && span_s <= kSteady;
  sensor_mm_s_ = is_steady ? Eigen::Vector3d((sensor - sensor_) / span_s) : Eigen::Vector3d::Zero();
  sensor_ = sensor;
  sensor_ns_ = cloud.stamp_ns;
}

/// What stands higher than cells are looked for. A layer that is not plane has no one height.
void LoopRun::watchLump(const std::vector<Point3>& points, const Eigen::Isometry3d& toolpath_from_sensor) {
  if (!atlas_.isPlane(*layer_)) return;
  const double top = loop_->cells().middle.front().dot(normal_);
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Point3& point : points) {
    const Point3 at = toolpath_from_sensor * point;
    const bool is_point = point.allFinite() && !point.isZero(0.0);
    const bool is_under_way = is_point && isInBox(ground_, Point3(at - at.dot(normal_) * normal_));
    heights.push_back(is_under_way ? at.dot(normal_) - top : LumpWatch::kNone);
  }
  lump_.see(heights);
}

void LoopRun::watchOffset() {
  const auto left = offset_.offset(loop_->cells());
  if (!left) return;
  offset_left_ = *left;
  offset_left_.sigma_s =
      std::hypot(left->sigma_s, settings_.calibration.time_offset_sigma_s, kLeastOffsetSigma);
  watch(0.0);
}

std::size_t LoopRun::cellsDeposited(double settle_mm) const {
  const PrintPlace& place = progress_.place();
  if (place.layer < *layer_) return 0;
  const bool is_whole = place.layer > *layer_ || place.is_scanning;
  return is_whole ? loop_->cells().size()
                  : cellsPassed(loop_->cells(), place.path, place.along_mm, settle_mm);
}

void LoopRun::leaveBehind(std::int64_t stamp_ns) {
  if (!layer_) return;
  const std::size_t cells = cellsDeposited(settle_mm_);
  if (left_behind_.empty() || left_behind_.back().second != cells) left_behind_.emplace_back(stamp_ns, cells);
}

/// Of what the nozzle had left behind, what had the time to become solid.
std::size_t LoopRun::cellsSolid(std::int64_t stamp_ns) {
  const std::int64_t since_ns = stamp_ns - std::llround(kSecond * settings_.settle_s);
  while (left_behind_.size() > 1 && left_behind_[1].first <= since_ns) left_behind_.pop_front();
  return !left_behind_.empty() && left_behind_.front().first <= since_ns ? left_behind_.front().second : 0;
}

void LoopRun::readCloud(const SensedCloud& cloud) {
  atlas_.setDeposited(*layer_, cellsSolid(cloud.stamp_ns));
  // In a scan pass all that lies open is of the layer.
  if (progress_.place().is_scanning) atlas_.forgetBelow(*layer_);
  const std::vector<LayerPrediction> predictions = {{*layer_, &loop_->estimates()}, {below_layer_, &below_}};
  SensorProfile profile;
  profile.toolpath_from_sensor = part_from_bed_ * cloud.bed_from_sensor;
  profile.stamp_sigma_mm = settings_.calibration.time_offset_sigma_s * sensor_mm_s_;
  for (const auto& points : cloud.profiles) {
    profile.points = points;
    const ProfileReadings read = readProfile(profile, atlas_, predictions, settings_.sight);
    counts_.points += read.counts;
    if (progress_.place().is_scanning) watchLump(points, profile.toolpath_from_sensor);
    for (const LayerReading& reading : read.readings) use(reading);
  }
  loop_->endCloud();
  if (trim_ && !progress_.place().is_scanning) trimLayer();
}

/// What is deposited stays: the maps differ in what is to come.
void LoopRun::trimLayer() {
  if (!trim_->advance(cellsDeposited(0.0), loop_->estimates())) return;
  laid_.amount = trim_->amount();
  loop_->relay(laid_);
  last_amount_ = laid_.amount.back();
  ++map_sequence_;
  publishMap();
}

void LoopRun::use(const LayerReading& reading) {
  if (reading.layer != *layer_) {
    ++counts_.readings_below;
    return;
  }
  if (progress_.place().is_scanning)
    offset_.see(reading.cell, sensor_mm_s_.dot(loop_->cells().tangent[reading.cell]), reading.reading);
  switch (loop_->see(reading.cell, reading.reading).use) {
    case ReadingUse::Used:
      ++counts_.readings_used;
      break;
    case ReadingUse::Contested:
      ++counts_.readings_contested;
      break;
    case ReadingUse::Believed:
      ++counts_.readings_believed;
      break;
  }
}

/// An alarm that stays up is raised once.
void LoopRun::watch(double blind_s) {
  SensorWatch seen;
  seen.is_scanning = progress_.place().is_scanning;
  seen.silent_s = silent_s_;
  seen.blind_s = blind_s;
  seen.profiles = stuck_.profiles();
  seen.variance_mm2 = stuck_.variance();
  seen.time_offset_s = offset_left_.offset_s;
  if (offset_left_.sigma_s > 0.0)
    seen.time_offset_sigmas = std::abs(offset_left_.offset_s) / offset_left_.sigma_s;
  LoopStep step = afterWatch(status_, seen, settings_.loop);
  std::set<LoopAlarm> up;
  std::vector<RaisedAlarm> risen;
  for (RaisedAlarm& alarm : step.alarms) {
    up.insert(alarm.alarm);
    if (watched_.count(alarm.alarm) == 0) risen.push_back(std::move(alarm));
  }
  step.alarms = std::move(risen);
  watched_ = std::move(up);
  take(std::move(step));
}

void LoopRun::take(LoopStep step) {
  status_ = std::move(step.status);
  for (RaisedAlarm& alarm : step.alarms) {
    last_alarm_ = alarm;
    layer_alarms_.push_back(alarm);
    news_.alarms.push_back(std::move(alarm));
  }
}

void LoopRun::beginLayer(std::size_t layer) {
  layer_.reset();
  LayerCells cells;
  for (; layer < part_.toolpath.layers.size(); ++layer) {
    cells = layerCells(part_.toolpath.layers[layer], layer, settings_.cell_mm, normal_);
    if (cells.size() > 0) break;
    news_.maps.push_back({part_.toolpath_id, layer, 0, {}});
  }
  if (cells.size() == 0) return;
  layer_ = layer;
  silent_s_ = 0.0;
  left_behind_.clear();
  settle_mm_ = settings_.settle_mm > 0.0 ? settings_.settle_mm : widestBead(cells);
  const auto shared = std::make_shared<const LayerCells>(cells);
  loop_->beginLayer(std::move(cells), taught_.amountsOf(layer));
  taught_.begin(*loop_);
  blockIfLump();
  offset_.begin(loop_->cells().size());
  lump_.reset();
  ground_ = groundOf(loop_->cells(), normal_);
  deposited_in_ = status_.state;
  laid_ = wanted();
  shiftNozzle();
  if (is_catching_up_)
    layAsPlanned(
        "layer " + std::to_string(*layer_) +
        " was begun while nobody followed the print; expected its map before: it counts as deposited as "
        "planned");
  std::vector<double> nozzle_error = shift_mm_;
  for (double& error : nozzle_error) error = -error;
  loop_->lay(laid_, nozzle_error);
  last_amount_ = laid_.amount.back();
  map_sequence_ = 0;
  is_missed_ = false;
  trim_.reset();
  if (status_.state == LoopState::Active && !is_catching_up_)
    if (auto trim = layerTrim(loop_->cells(), loop_->estimates(), laid_.amount, settings_.loop))
      trim_ = std::make_unique<LayerTrim>(*std::move(trim));
  atlas_.add(shared);
  atlas_.setDeposited(layer, 0);
  atlas_.forgetBelow(below_.empty() ? layer : below_layer_);
  publishMap();
  takeMissed();
}

/// What the machine reported of this layer before the loop came to it.
void LoopRun::takeMissed() {
  const auto told = missed_.find(*layer_);
  if (told != missed_.end()) missMap(told->second);
  missed_.erase(missed_.begin(), missed_.upper_bound(*layer_));
}

/// Its map comes too late for the machine.
void LoopRun::layAsPlanned(const std::string& reason) {
  laid_.amount.assign(loop_->cells().size(), 0.0);
  laid_.limited_share = 0.0;
  shift_mm_.assign(loop_->cells().size(), 0.0);
  mean_shift_mm_ = 0.0;
  deposited_in_ = LoopState::Coasting;
  take({status_, {{LoopAlarm::MapLate, LoopReaction::Coast, reason}}});
}

void LoopRun::blockIfLump() {
  const double height = meanOverCells(loop_->cells(), loop_->cells().height_mm);
  const double lump = std::max(highestCell(loop_->estimates()), lump_.height()) - height;
  take(beforeLayer(status_, lump, settings_.head_clearance_mm));
}

/// Of a loop that no longer corrects: what the layer before ended with fades.
LayerCorrection LoopRun::wanted() const {
  LayerCorrection correction = loop_->correction(status_.state);
  if (isCorrecting() || last_amount_ == 0.0) return correction;
  const std::vector<double> from(correction.amount.size(), last_amount_);
  correction.amount = fadedCorrection(loop_->cells(), from, correction.amount, 0, settings_.loop);
  return correction;
}

/// Back to the plan, a little in each layer, unless the loop is active.
void LoopRun::shiftNozzle() {
  const LayerCells& cells = loop_->cells();
  const double height = meanOverCells(cells, cells.height_mm);
  if (status_.state == LoopState::Active) {
    const NozzleRoom room{height, highestCell(loop_->estimates()), settings_.head_clearance_mm};
    shift_mm_ = nozzleShift(cells, loop_->knowledge(), mean_shift_mm_, room, settings_.loop);
  } else {
    const double step = kShiftBack * height;
    shift_mm_.assign(cells.size(), mean_shift_mm_ - std::clamp(mean_shift_mm_, -step, step));
  }
  mean_shift_mm_ = meanOverCells(cells, shift_mm_);
}

/// What the machine is given so that the layer grows as corrected.
CellCorrections LoopRun::asDeposited() const {
  CellCorrections told;
  if (!isAllZero(shift_mm_)) told.dz_mm = shift_mm_;
  if (isAllZero(laid_.amount)) return told;
  told.amount = laid_.amount;
  if (settings_.loop.speed_exponent == 0.0) return told;
  const LayerCells& cells = loop_->cells();
  const MetalCorrection split = metalSplit(cells, laid_.amount, PowerSource::Fixed, settings_.loop);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    told.speed.push_back(split.speed_mm_s[i] / cells.speed_mm_s[i] - 1.0);
    // What the wire brings per time is the same all over the layer.
    told.amount[i] = (1.0 + split.wire) / (1.0 + told.speed[i]) - 1.0;
  }
  return told;
}

void LoopRun::publishMap() {
  mapped_ = {laid_, shift_mm_, deposited_in_};
  const CellCorrections told = asDeposited();
  CorrectionMap map{part_.toolpath_id, *layer_, map_sequence_, {}};
  if (!told.amount.empty() || !told.dz_mm.empty())
    map = correctionMap(loop_->cells(), told, part_.toolpath_id, map_sequence_);
  news_.maps.push_back(std::move(map));
}

/// Layers without a scan pass are not judged where others have one, unless they were seen.
bool LoopRun::isDue(std::size_t layer, const LayerFigures& figures) const {
  return progress_.hasScan(layer) || !progress_.hasScans() || figures.coverage > 0.0;
}

void LoopRun::endLayer() {
  watchOffset();
  const LayerFigures figures = loop_->endLayer();
  taught_.end(*loop_, laid_.amount);
  below_ = loop_->estimates();
  below_layer_ = *layer_;
  if (isDue(*layer_, figures)) take(afterLayer(status_, figures, settings_.loop));
  checkAgain(figures);
  planAnew(figures);
  news_.layers.push_back(outcomeOf(figures));
  if (settings_.keeps_memory) news_.memory = memory(*layer_);
  layer_alarms_.clear();
  layer_.reset();
}

LayerOutcome LoopRun::outcomeOf(const LayerFigures& figures) {
  LayerOutcome outcome{figures, deposited_in_, layer_alarms_, {}};
  const LayerCells& cells = loop_->cells();
  outcome.cells.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellEstimate& cell = loop_->estimates()[i];
    outcome.cells.push_back(
        {cells.middle[i], cell.error(), std::sqrt(cell.variance()), laid_.amount[i], cell.isSeen()});
  }
  return outcome;
}

/// By what was stated, and by what the last layer showed: how far its growth was off what is learnt of it.
StabilityReport LoopRun::checkNow() const {
  StabilityReport stated = checkStart(part_.toolpath, part_.machine, settings_);
  if (!stated.may_start || gain_ratio_ == 1.0) return stated;
  LoopRunSettings as_told = settings_;
  as_told.calibration.gain_ratio *= gain_ratio_;
  StabilityReport told = checkStart(part_.toolpath, part_.machine, as_told);
  if (!told.may_start)
    told.reason += "; the last layer grew " + numberText(gain_ratio_) + " times what is learnt by now";
  return told;
}

/// The bounds once more when the gain has changed by a fifth.
void LoopRun::checkAgain(const LayerFigures& figures) {
  gain_ratio_ = figures.gain_ratio;
  if (!needsNewCheck(gain_at_check_, figures.gain_mean)) return;
  gain_at_check_ = figures.gain_mean;
  stability_ = checkNow();
  if (!stability_.may_start && status_.state != LoopState::Off)
    status_ = afterRequest(LoopRequest::Active, stability_);
}

LoopNews LoopRun::takeNews() { return std::exchange(news_, {}); }

}  // namespace lamina
