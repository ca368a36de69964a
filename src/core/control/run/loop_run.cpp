// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "control/run/cell_corrections.hpp"
#include "control/run/coasting_maps.hpp"
#include "control/run/laid_layer.hpp"
#include "control/run/layer_ground.hpp"
#include "control/run/layer_trim.hpp"
#include "control/run/loop_plan.hpp"
#include "control/run/stamps.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/run/run_calibration.hpp"

namespace lamina {

LoopRun::LoopRun(PlacedPart part, const LoopRunSettings& settings)
    : part_(std::move(part)),
      settings_(settings),
      offset_sigmas_(timeOffsetSigmas(settings.calibration)),
      part_from_bed_(part_.bed_from_part.inverse()),
      normal_(normalOfLayers(part_.toolpath)),
      progress_(part_.toolpath, settings.following),
      taught_(part_.toolpath, {part_.toolpath_id, part_.machine, settings.material}, settings),
      stability_(checkStart(part_.toolpath, part_.machine, settings)),
      atlas_(settings.sight.window_layers),
      laid_(std::make_unique<LaidLayer>()),
      coasting_(std::make_unique<CoastingMaps>()),
      pose_watches_(settings.loop.silence_s),
      moved_watches_(normal_) {
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
  last_alarm_ = memory.last_alarm;
  if (isRunning(status_.state)) standing_.resume(memory.standing);
  laid_->carryOver(memory.last_amount, memory.mean_shift_mm);
  news_ = {};
  progress_.resume(memory.layer + 1);
  atlas_.add(std::make_shared<const LayerCells>(std::move(cells)));
  beginLayer(memory.layer + 1);
  is_catching_up_ = true;
}

LoopMemory LoopRun::memory(std::size_t layer) const {
  return {identity(),         layer,           status_,     gain_at_check_, laid_->lastAmount(),
          laid_->meanShift(), loop_->stored(), last_alarm_, standing_.all()};
}

const LoopStatus& LoopRun::request(LoopRequest request) {
  if (status_.state == LoopState::Blocked) stability_ = checkNow();
  status_ = afterRequest(request, stability_);
  forgetShifts();
  standing_.settle(status_, watched_);
  return status_;
}

void LoopRun::forgetShifts() {
  offset_left_ = {};
  moved_.clear();
  moved_watches_.reset();
  standing_.end(LoopAlarm::TimeOffset);
}

void LoopRun::recalibrate(const CellCalibration& known, LoopRequest request) {
  offset_sigmas_ = timeOffsetSigmas(known);
  settings_.calibration = known;
  forgetShifts();
  stability_ = checkNow();
  if (stability_.may_start && stability_.low_pass_mm > settings_.loop.low_pass_mm) {
    stability_.may_start = false;
    stability_.reason += "; the low-pass of this print stays: it holds from the next one on";
  }
  const bool waits = status_.coasting_for == CoastingFor::TimeOffset || status_.state == LoopState::Blocked;
  const bool is_refused = !stability_.may_start && status_.state != LoopState::Off;
  if (waits || is_refused) status_ = afterRequest(request, stability_);
}

void LoopRun::observe(const StampedTip& pose) {
  ++counts_.poses;
  if (events_.isLate(pose.stamp_ns)) {
    ++counts_.poses_late;
    return;
  }
  events_.add(pose);
  passDue();
}

void LoopRun::see(SensedCloud cloud) {
  ++counts_.clouds;
  if (events_.isLate(cloud.stamp_ns)) {
    ++counts_.clouds_late;
    return;
  }
  ++counts_.clouds_waiting;
  events_.add(std::move(cloud));
  passDue();
}

void LoopRun::passDue() {
  passUntil(*events_.latest() - static_cast<std::int64_t>(settings_.reorder_s * 1e9));
}

void LoopRun::passUntil(std::int64_t stamp_ns) {
  while (const auto event = events_.takeUntil(stamp_ns)) {
    if (event->cloud)
      onCloud(*event->cloud);
    else
      onTip(event->stamp_ns, event->tip);
  }
}

void LoopRun::passAll() {
  if (events_.latest()) passUntil(*events_.latest());
}

void LoopRun::finish() {
  passAll();
  if (layer_ && loop_->cells().size() > 0 && cellsDeposited(0.0) == loop_->cells().size()) endLayer();
  interrupt();
}

void LoopRun::interrupt() {
  is_interrupted_ = true;
  watched_ = {};
  standing_.endAll();
}

void LoopRun::hear(std::int64_t stamp_ns, const std::string& sensor) {
  pose_watches_.hear(sensor, stamp_ns, events_.latestTip());
  if (pose_watches_.blind(events_.latestTip()) <= settings_.loop.silence_s) return;
  // The last poses say whether the nozzle was scanning: nothing that comes brings them on any more.
  passUntil(events_.latestTip().value_or(stamp_ns));
  watch();
}

void LoopRun::restartClock() {
  passAll();
  events_ = StampedEvents();
  tip_ns_.reset();
  cloud_ns_.reset();
  pose_watches_.begin();
  silent_s_ = 0.0;
  motions_.clear();
  solid_.begin();  // what is left behind becomes solid by the new stamps
}

void LoopRun::missMap(const MissedMap& missed) {
  if (!layer_ || missed.layer < *layer_ || missed.layer >= part_.toolpath.layers.size()) return;
  if (missed.layer > *layer_) {
    MissedMap& told = missed_[missed.layer];
    const bool is_coasting = told.is_coasting || missed.is_coasting;
    told = missed;
    told.is_coasting = is_coasting;
    return;
  }
  if (missed.is_coasting) coasting_->use();
  if (missed.held_from)
    return layMapFrom(cellsPassed(loop_->cells(), missed.held_from->path, missed.held_from->along_mm, 0.0));
  const bool is_otherwise = !laid_->isWhollyMissed() && (missed.is_coasting || !laid_->isAsPlanned());
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

bool LoopRun::follow(const std::string& toolpath_id) {
  passAll();
  if (!plan_ || plan_->part.toolpath_id != toolpath_id) return false;
  events_.clear();
  missed_.clear();
  part_ = std::move(plan_->part);
  progress_ = LayerProgress(part_.toolpath, settings_.following);
  loop_ = std::move(plan_loop_);
  atlas_ = CellAtlas(settings_.sight.window_layers);
  below_.clear();
  below_layer_ = 0;
  if (isCorrecting(status_.state)) status_ = afterReplan(status_, plan_->raised_mm);
  laid_->carryOver(0.0, 0.0);
  short_mm_ = plan_->short_mm;
  layer_alarms_.clear();
  trim_refused_.reset();
  plan_.reset();
  plan_loop_.reset();
  *coasting_ = {};
  taught_.abandon();
  beginLayer(0);
  return true;
}

bool LoopRun::refusePlan(const std::string& toolpath_id, const std::string& reason) {
  if (!plan_ || plan_->part.toolpath_id != toolpath_id) return false;
  take({status_,
        {{LoopAlarm::Saturated, LoopReaction::Warn,
          "layer " + std::to_string(plan_->layer) + " is deposited as before, not by plan " + toolpath_id +
              ": " + reason}}});
  const bool is_next = layer_ == plan_->layer;
  plan_.reset();
  plan_loop_.reset();
  if (is_next) publishMap();
  return true;
}

/// Cells that went to the machine before their map were deposited as planned. The trim of the layer expected
/// otherwise, and would take the difference for an error.
void LoopRun::layMapFrom(std::size_t cell) {
  if (cell == 0 && !laid_->isMapMissed()) return;
  trim_.reset();
  laid_->layMapFrom(loop_->cells(), cell, settings_.loop,
                    coasting_->isUsed() ? LaidLayer::Without::OwnMap : LaidLayer::Without::Map);
  loop_->relay(laid_->correction());
}

/// The nozzle where the plan has it: what the loop shifts it by is off.
Point3 LoopRun::correctedTip(const Point3& tip) const {
  if (!layer_ || progress_.place().layer != *layer_ || isAllZero(laid_->shift())) return tip;
  const auto cell = cellAt(loop_->cells(), progress_.place());
  return cell ? Point3(tip - laid_->shift()[*cell] * normal_) : tip;
}

void LoopRun::onTip(std::int64_t stamp_ns, const Point3& tip) {
  is_moving_ = tip_ns_ && tip != tip_;
  const bool was_scanning = progress_.place().is_scanning;
  const PrintPosition& place = progress_.observe(correctedTip(part_from_bed_ * tip));
  if (!place.is_scanning || !was_scanning) silent_s_ = 0.0;
  if (place.is_scanning && was_scanning && is_moving_)
    silent_s_ += secondsFrom(std::max(*tip_ns_, cloud_ns_.value_or(*tip_ns_)), stamp_ns);
  tip_ns_ = stamp_ns;
  tip_ = tip;
  watch();
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
  const std::size_t layer = progress_.place().layer;
  if (is_moving_ && sensors_.see(cloud, layer)) is_distrusted_ = true;
  const bool is_stuck = sensors_.isStuck(cloud.sensor);
  // A stuck sensor does not hide that the live one beside it has gone silent.
  if (!is_stuck || !sensors_.isAnyLive(layer)) {
    cloud_ns_ = cloud.stamp_ns;
    silent_s_ = 0.0;
  }
  watch();
  if (is_stuck) {
    ++counts_.clouds_stuck;
    return;
  }
  ++counts_.clouds_read;
  standing_.settleSight(status_, watched_);
  SensorMotion& motion = motions_[cloud.sensor];
  motion.see(cloud.stamp_ns, part_from_bed_ * cloud.bed_from_sensor.translation());
  velocity_ = motion.velocity();
  if (layer_) readCloud(cloud);
}

/// What stands higher or lies lower than cells are looked for. A layer that is not plane has no one height.
void LoopRun::watchHeights(const std::string& sensor, const SensorProfile& profile) {
  if (!atlas_.isPlane(*layer_)) return;
  const std::vector<Point3>& points = profile.points;
  const Eigen::Isometry3d& toolpath_from_sensor = profile.toolpath_from_sensor;
  moved_watches_.see(sensor, points, toolpath_from_sensor);
  const double layer_mm = loop_->cells().height_mm.front();
  const double top_mm = loop_->cells().middle.front().dot(normal_);
  const std::vector<double> heights = heightsOver(top_mm, ground_, normal_, points, toolpath_from_sensor);
  lump_.see(heights);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(heights[i] < -settings_.sight.window_layers * layer_mm)) continue;
    const Point3 at = toolpath_from_sensor * points[i];
    if ((part_.bed_from_part * at).z() < -layer_mm) continue;  // below the bed there is nothing
    const auto over = atlas_.newestAt(Point3(at - heights[i] * normal_));
    if (over && over->layer == *layer_ && over->across_share <= 0.5 * settings_.sight.crown_share)
      fallen_.see(over->cell, -heights[i]);
  }
}

void LoopRun::watchOffset() {
  const auto offset = offset_.offset(loop_->cells(), offset_sigmas_);
  offset_left_ = offset.value_or(offset_left_);
  watch();
}

/// By what was expected before the scan: what a moved sensor shows is not to explain it, nor came off.
void LoopRun::watchPlace() {
  if (moved_.empty() && atlas_.isPlane(*layer_))
    moved_ = moved_watches_.moved(atlas_, scannedLayer(loop_->cells(), loop_->errorsBeforeClouds(), normal_));
  if (moved_.empty()) return;
  is_distrusted_ = true;
  fallen_.reset();
  lump_.reset();
  watch();
}

std::size_t LoopRun::cellsDeposited(double settle_mm) const {
  const PrintPosition& place = progress_.place();
  if (place.layer < *layer_) return 0;
  const bool is_whole = place.layer > *layer_ || place.is_scanning;
  return is_whole ? loop_->cells().size()
                  : cellsPassed(loop_->cells(), place.path, place.along_mm, settle_mm);
}

void LoopRun::leaveBehind(std::int64_t stamp_ns) {
  if (!layer_) return;
  solid_.leaveBehind(stamp_ns, cellsDeposited(settle_mm_));
}

void LoopRun::readCloud(const SensedCloud& cloud) {
  atlas_.setDeposited(*layer_, solid_.leftBehindBy(cloud.stamp_ns - nanoseconds(settings_.settle_s)));
  // In a scan pass all that lies open is of the layer.
  if (progress_.place().is_scanning) atlas_.forgetBelow(*layer_);
  const std::vector<LayerPrediction> predictions = {{*layer_, &loop_->estimates()}, {below_layer_, &below_}};
  SensorProfile profile;
  profile.toolpath_from_sensor = part_from_bed_ * cloud.bed_from_sensor;
  profile.stamp_sigma_mm = offset_sigmas_.of(cloud.sensor) * velocity_;
  for (const auto& points : cloud.profiles) {
    profile.points = points;
    const ProfileReadings read = readProfile(profile, atlas_, predictions, settings_.sight);
    counts_.points += read.counts;
    if (loop_->readsSections()) sections_.see(profile, atlas_, settings_.sight);
    if (progress_.place().is_scanning) watchHeights(cloud.sensor, profile);
    for (const LayerReading& reading : read.readings) use(cloud.sensor, reading);
  }
  for (const SectionReading& section : sections_.take()) loop_->seeDeficit(section.cell, section.deficit);
  loop_->endCloud();
  if (trim_ && !progress_.place().is_scanning) trimLayer();
}

/// What is deposited stays: the maps differ in what is to come.
void LoopRun::trimLayer() {
  if (!trim_->advance(cellsDeposited(0.0), loop_->estimates())) return;
  laid_->trim(loop_->cells(), trim_->amount(), settings_.loop);
  loop_->relay(laid_->correction());
  ++map_sequence_;
  publishMap();
}

void LoopRun::use(const std::string& sensor, const LayerReading& reading) {
  if (reading.layer != *layer_) {
    ++counts_.readings_below;
    return;
  }
  if (progress_.place().is_scanning)
    offset_.see(sensor, reading.cell, velocity_.dot(loop_->cells().tangent[reading.cell]), reading.reading);
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

void LoopRun::watch() {
  if (is_interrupted_) return;
  SensorWatch seen;
  // After the last layer nothing is to be seen any more.
  const bool is_blind = layer_ && pose_watches_.isWithoutPose(events_.latestTip());
  seen.is_scanning = progress_.place().is_scanning || is_blind;
  sensors_.judge(progress_.place().layer, seen);
  // Of clouds that come, and that tf does not place, the sensor is not the cause.
  const bool hears = !isLeftOut(seen) && tip_ns_ && pose_watches_.isHeard(*tip_ns_);
  seen.silent_s = hears ? 0.0 : silent_s_;
  seen.unplaced_s = hears ? silent_s_ : 0.0;
  seen.blind_s = pose_watches_.blind(events_.latestTip());
  judge(offset_left_, seen);
  seen.moved = moved_;
  LoopStep step = afterWatch(status_, seen, settings_.loop);
  step.alarms = watched_.risen(std::move(step.alarms));
  take(std::move(step));
  standing_.settle(status_, watched_);
}

void LoopRun::take(LoopStep step) {
  status_ = std::move(step.status);
  for (RaisedAlarm& alarm : step.alarms) {
    last_alarm_ = alarm;
    standing_.raise(alarm);
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
    news_.maps.push_back({part_.toolpath_id, layer, 1, {}});
  }
  if (cells.size() == 0) return;
  layer_ = layer;
  silent_s_ = 0.0;
  solid_.begin();
  sections_.begin();
  settle_mm_ = settings_.settle_mm > 0.0 ? settings_.settle_mm : widestBead(cells);
  const auto shared = std::make_shared<const LayerCells>(cells);
  loop_->beginLayer(std::move(cells), taught_.amountsOf(layer));
  taught_.begin(*loop_);
  blockIfLump();
  offset_.begin(loop_->cells().size());
  moved_watches_.begin();
  pose_watches_.begin();
  is_distrusted_ = false;
  lump_.reset();
  fallen_.reset();
  ground_ = groundOf(loop_->cells(), normal_);
  laid_->decide(*loop_, status_.state, settings_);
  coasting_->begin(layer, *laid_);
  if (is_catching_up_) layAsPlanned();
  std::vector<double> nozzle_error = laid_->shift();
  for (double& error : nozzle_error) error = -error;
  loop_->lay(laid_->correction(), nozzle_error);
  map_sequence_ = 1;
  trim_.reset();
  if (status_.state == LoopState::Active && !is_catching_up_)
    if (auto trim = layerTrim(loop_->cells(), loop_->estimates(), laid_->correction().amount, settings_.loop))
      trim_ = std::make_unique<LayerTrim>(*std::move(trim));
  atlas_.add(shared);
  atlas_.setDeposited(layer, 0);
  atlas_.forgetBelow(below_.empty() ? layer : below_layer_);
  giveCoastingMap();
  publishMap();
  takeMissed();
}

void LoopRun::giveCoastingMap() {
  const bool gives = isCorrecting(status_.state) && settings_.loop.process == LoopProcess::Free;
  std::size_t next = *layer_ + 1;
  LayerCells cells;
  for (; gives && next < part_.toolpath.layers.size() && cells.size() == 0; ++next)
    cells = layerCells(part_.toolpath.layers[next], next, settings_.cell_mm, normal_);
  if (cells.size() == 0) return;
  HeightLoop loop = *loop_;
  loop.beginLayer(std::move(cells), taught_.amountsOf(next - 1));
  news_.coasting_maps.push_back(coasting_->give(loop, *laid_, part_.toolpath_id, settings_));
}

const CorrectionMap* LoopRun::coastingMap(std::size_t layer) const { return coasting_->of(layer); }

/// What the machine reported of this layer before the loop came to it.
void LoopRun::takeMissed() {
  const auto told = missed_.find(*layer_);
  if (told != missed_.end()) missMap(told->second);
  missed_.erase(missed_.begin(), missed_.upper_bound(*layer_));
}

/// Its map comes too late for the machine.
void LoopRun::layAsPlanned() {
  laid_->layAsPlanned(loop_->cells(), settings_.loop);
  take(
      {status_,
       {{LoopAlarm::MapLate, LoopReaction::Coast,
         "layer " + std::to_string(*layer_) +
             " was begun while nobody followed the print; expected its map before: it counts as deposited as "
             "planned"}}});
}

void LoopRun::blockIfLump() {
  const double height = meanOverCells(loop_->cells(), loop_->cells().height_mm);
  const double lump = std::max(highestCell(loop_->estimates()), lump_.height()) - height;
  take(beforeLayer(status_, lump, settings_.head_clearance_mm));
}

void LoopRun::publishMap() {
  news_.maps.push_back(coasting_->withAhead(laid_->map(loop_->cells(), part_.toolpath_id, map_sequence_)));
}

/// Layers without a scan pass are not judged where others have one, unless they were seen.
bool LoopRun::isDue(std::size_t layer, const LayerFigures& figures) const {
  return progress_.hasScan(layer) || !progress_.hasScans() || figures.coverage > 0.0;
}

void LoopRun::endLayer() {
  watchOffset();
  watchPlace();
  // The profiles by which a sensor was found to be stuck, or to have moved, were read.
  if (is_distrusted_) loop_->forgetClouds();
  LayerFigures figures = loop_->endLayer();
  figures.fallen = fallen_.fallen(loop_->cells(), loop_->estimates());
  taught_.end(*loop_, laid_->correction().amount);
  below_ = loop_->estimates();
  below_layer_ = *layer_;
  if (isDue(*layer_, figures)) take(afterLayer(status_, figures, settings_.loop));
  if (figures.is_measured) {
    standing_.endResumption();
    standing_.settleSight(status_, watched_);
  }
  checkAgain(figures);
  planAnew(figures);
  news_.layers.push_back(outcomeOf(figures));
  if (settings_.keeps_memory) news_.memory = memory(*layer_);
  layer_alarms_.clear();
  layer_.reset();
}

LayerOutcome LoopRun::outcomeOf(const LayerFigures& figures) {
  return {figures, laid_->state(), layer_alarms_, laid_->outcomes(loop_->cells(), loop_->estimates())};
}

/// A plan holds for the layer that comes next alone.
void LoopRun::planAnew(const LayerFigures& figures) {
  plan_.reset();
  plan_loop_.reset();
  const bool plans = settings_.loop.replan == Replanning::Scale || settings_.loop.replan == Replanning::Add;
  const bool is_free = settings_.loop.process == LoopProcess::Free;
  if (!plans || !is_free || status_.state != LoopState::Active || !figures.is_measured) return;
  const std::string reason = reasonToPlan(part_.toolpath, figures, layer_alarms_, settings_.loop);
  if (reason.empty()) return;
  try {
    offerPlan(figures, reason);
  } catch (const InvalidInput& error) {
    take({status_, {{LoopAlarm::Saturated, LoopReaction::Hold, reason + "; no plan: " + error.what()}}});
  }
}

void LoopRun::offerPlan(const LayerFigures& figures, const std::string& reason) {
  PrintPlan plan = planOfLayersLeft(part_, figures, short_mm_, settings_.loop);
  plan.reason = reason;
  plan_loop_ = *loop_;
  plan_loop_->replan(plan.raised_mm, plan.flow);
  if (!isAmong(layer_alarms_, LoopAlarm::Saturated))
    take({status_, {{LoopAlarm::Saturated, LoopReaction::Replan, reason}}});
  plan_ = plan;
  news_.plans.push_back(std::move(plan));
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
