// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/trajectory_feeder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "laid_spans.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "motion_sample.hpp"
#include "straight_lift.hpp"
#include "timed_motion.hpp"

namespace lamina {
namespace {

/// A share of what is planned over time: 1 at first, steady between changes, straight from one value to the
/// next while it changes.
class RampedShare {
 public:
  /// Leads to a share from a time on; what comes before that time stays.
  /// @param ramp_s  in which it would change by 1; 0 for at once
  void lead(double share, double from_s, double ramp_s);

  double at(double time_s) const;

 private:
  struct Corner {
    double time_s = 0.0;
    double share = 1.0;
  };
  std::vector<Corner> corners_;  ///< in order of time; of two at one time the later one holds from then on
};

void RampedShare::lead(double share, double from_s, double ramp_s) {
  const double present = at(from_s);
  while (!corners_.empty() && corners_.back().time_s >= from_s) corners_.pop_back();
  corners_.push_back({from_s, present});
  corners_.push_back({from_s + ramp_s * std::abs(share - present), share});
}

double RampedShare::at(double time_s) const {
  const auto later = std::upper_bound(corners_.begin(), corners_.end(), time_s,
                                      [](double time, const Corner& corner) { return time < corner.time_s; });
  if (later == corners_.begin()) return 1.0;
  const Corner& before = *std::prev(later);
  if (later == corners_.end()) return before.share;
  const double passed = (time_s - before.time_s) / (later->time_s - before.time_s);
  return before.share + passed * (later->share - before.share);
}

/// The motion from rest to rest that takes the tip straight against its tool axis, the tool axis held.
/// Nothing is deposited.
/// @throws InvalidInput if height or speed is not positive
/// @throws Unreachable if a joint would leave its limits, or the way cannot be followed
std::shared_ptr<const TimedMotion> toolLift(const JointValues& from, const ToolLift& lift,
                                            const KinematicModel& model, const TimingSettings& settings) {
  if (!(lift.height_mm > 0.0 && lift.speed_mm_s > 0.0))
    throw InvalidInput("the tool is to be lifted by " + numberText(lift.height_mm) + " mm at " +
                       numberText(lift.speed_mm_s) + " mm/s; both must be positive");
  const StraightLift way = straightLift(from, lift.height_mm, model, settings.trajectory);
  if (!way.stopped_by.empty())
    throw Unreachable("the tool can be lifted by " +
                      numberText(way.step_mm * static_cast<double>(way.values.size() - 1)) + " mm of " +
                      numberText(lift.height_mm) + " mm only: " + way.stopped_by);
  JointStations stations;
  for (const JointValues& values : way.values) {
    JointStation station;
    station.values = values;
    station.pose = model.bedFromNozzle(values);
    if (!stations.each.empty()) {
      station.length_mm = way.step_mm;
      station.feed_mm_s = lift.speed_mm_s;
      station.acceleration_mm_s2 = settings.motion.travel_acceleration_mm_s2;
      station.is_smooth = true;
    }
    stations.each.push_back(station);
  }
  TimingSettings timing = settings;
  timing.process = {};
  return std::make_shared<const TimedMotion>(std::move(stations), model, timing);
}

double movingTime(const Timeline& timeline) {
  double sum_s = 0.0;
  for (std::size_t i = 0; i < timeline.phases().size(); ++i)
    if (timeline.phases()[i].kind == PhaseKind::Move)
      sum_s += timeline.endOf(i) - timeline.phases()[i].time_s;
  return sum_s;
}

void shareMaterial(ProcessSignals& signals, double share) {
  signals.flow_mm3_s *= share;
  for (const ProcessLevel level : {ProcessLevel::WireSpeed, ProcessLevel::ScrewSpeed, ProcessLevel::Powder})
    if (signals.levels.has(level)) signals.levels[level] *= share;
}

constexpr double kLeastSpeed = 0.01;    // of the planned speeds
constexpr double kLeastReaction = 0.5;  // of the reaction time, that is left to hand a change over
constexpr double kGridSlack = 1e-6;     // of a step: a time this near to a point is that point's

}  // namespace

class TrajectoryFeeder::State {
 public:
  State(std::shared_ptr<const TimedMotion> motion, const TrajectoryFeederSettings& settings)
      : motion_(std::move(motion)),
        settings_(settings),
        timeline_(motion_->plan().timeline()),
        schedule_(motion_->schedule()),
        planned_(motion_, &motion_->plan()),
        speeds_(planned_),
        fastest_(planned_),
        laid_(motion_->curve()) {}

  /// The waits and leads are those of a start: what lies before the place is not gone.
  void beginAt(double from_mm) {
    rest_ = laid_.placeOf(from_mm);
    timeline_ = Timeline();
    const ProcessSettings& process = motion_->settings().process;
    const bool is_on_bead =
        rest_.along > 0.0 || (rest_.span > 0 && motion_->curve().spanEnd(rest_.span - 1).area_mm2 > 0.0);
    double wait_s = process.settling_s;
    // At the start of a bead the plan has the other waits itself.
    if (is_on_bead) wait_s += motion_->averaging() + process.wait_before_s;
    wait_s = std::max({wait_s, process.laser_on_lead_s, process.wire_on_lead_s});
    appendRest(PhaseKind::Wait, wait_s);
    fastest_->appendFrom(timeline_, rest_, sharedSpeeds(), is_on_bead ? RestThere::Over : RestThere::Due);
    reschedule();
  }

  TrajectoryFeederState state() const {
    const bool is_over = state_ == TrajectoryFeederState::Running && !isHeld() && sent_ >= lastStep();
    return is_over ? TrajectoryFeederState::Finished : state_;
  }
  double restTime() const { return timeline_.end() + motion_->averaging(); }
  std::vector<ProcessEvent> events() const { return schedule_.events(); }

  LaidAmount laidAt(double time_s) const {
    const MotionPlace place = timeline_.placeAt(time_s - 0.5 * motion_->averaging());
    // A lift after an abort is on a curve of its own.
    return laid_.at(place.curve == &motion_->curve() ? place : rest_);
  }

  JointState at(double time_s) const {
    JointState state = motionSample(timeline_, motion_->averaging(), time_s);
    state.process = schedule_.signalsAt(time_s, state.process);
    shareMaterial(state.process, flow_.at(time_s));
    ProcessLevels& levels = state.process.levels;
    if (levels.has(ProcessLevel::LaserPower)) levels[ProcessLevel::LaserPower] *= power_.at(time_s);
    return state;
  }

  std::optional<TrajectoryChunk> next(double now_s) {
    const long last = lastStep();
    const double chunk_s = settings_.points / settings_.rate_hz;
    if (sent_ >= last || (sent_ >= 0 && timeOf(sent_) - now_s >= settings_.ahead_s + chunk_s))
      return std::nullopt;
    const long first = std::max(sent_, 0L);
    const long end = std::min(last, first + settings_.points);
    TrajectoryChunk chunk;
    chunk.points.reserve(static_cast<std::size_t>(end - first + 1));
    for (long step = first; step <= end; ++step) chunk.points.push_back(at(timeOf(step)));
    sent_ = end;
    return chunk;
  }

  void pause(double now_s) {
    if (state_ != TrajectoryFeederState::Running) return;
    if (held_layer_)
      pauseHeld(now_s);
    else if (!brakeFrom(reactionTo(now_s)))
      return;
    state_ = TrajectoryFeederState::Paused;
    reschedule();
  }

  bool isHeld() const { return held_layer_.has_value(); }

  bool hold(std::size_t layer, double now_s) {
    if (state_ != TrajectoryFeederState::Running || isHeld()) return false;
    const auto begins = layerBegin(layer);
    if (!begins || *begins < reactionTo(now_s)) return false;
    // Of layers that it cannot stop at there may be thousands: the way there is not taken for each.
    if (*begins >= timeline_.end() || restsOnBeadFrom(layer, stopFrom(*begins))) return false;
    brakeFrom(*begins);
    held_layer_ = layer;
    reschedule();
    return true;
  }

  void release(double now_s) {
    if (state_ != TrajectoryFeederState::Running || !isHeld()) return;
    held_layer_.reset();
    continueMotion(now_s);
  }

  void resume(double now_s) {
    if (state_ != TrajectoryFeederState::Paused) return;
    if (isHeld())
      state_ = TrajectoryFeederState::Running;
    else
      continueMotion(now_s);
  }

  void continueMotion(double now_s) {
    // Averages of the way to rest and of that from it must not meet.
    const double start_s = std::max(timeOf(stepAfter(now_s + settings_.reaction_s)), restTime());
    if (sent_ >= lastStep()) sent_ = std::max(sent_, stepAfter(start_s) - 1);
    appendRest(PhaseKind::Halt, start_s - timeline_.end());
    appendRest(PhaseKind::Wait, motion_->settings().process.settling_s);
    rest_.speed = 0.0;
    fastest_->appendFrom(timeline_, rest_, sharedSpeeds(), RestThere::Due);
    state_ = TrajectoryFeederState::Running;
    reschedule();
  }

  SpeedChange speedChange(double share) const {
    const std::string refusal = speedRefusal(share, settings_);
    if (!refusal.empty()) throw InvalidInput(refusal);
    if (share <= 1.0) return {share, share, nullptr};
    std::shared_ptr<const SpeedPlan> plan = motion_->planAt(share);
    const double reached = movingTime(motion_->plan().timeline()) / movingTime(plan->timeline());
    return {share, reached, std::move(plan)};
  }

  bool setSpeed(const SpeedChange& change, double now_s, const std::function<double()>& clock) {
    const auto former = std::make_tuple(speed_share_, speeds_, fastest_share_, fastest_);
    if (change.share == std::exchange(speed_share_, change.share)) return true;
    speeds_ = change.plan ? change.plan : planned_;
    // A plan for greater feeds is nowhere slower than one for lesser ones.
    if (change.share > fastest_share_) {
      fastest_ = speeds_;
      fastest_share_ = change.share;
    }
    if (state_ != TrajectoryFeederState::Running) return true;
    const WayToRest before = wayToRest();
    if (!goOnAtSpeed(now_s)) return true;
    const std::optional<std::size_t> layer = std::exchange(held_layer_, std::nullopt);
    reschedule();
    const bool is_held_still = !layer || hold(*layer, now_s);
    const bool is_in_time =
        clock() <= now_s + kLeastReaction * settings_.reaction_s || (before.sent < 0 && now_s <= 0.0);
    if (is_held_still && is_in_time) return true;
    goBackTo(before);
    held_layer_ = layer;
    reschedule();
    if (!is_in_time) std::tie(speed_share_, speeds_, fastest_share_, fastest_) = former;
    return is_in_time;
  }

  void setShare(OverrideKind kind, double share, double now_s) {
    const std::string refusal = shareRefusal(kind, share);
    if (!refusal.empty()) throw InvalidInput(refusal);
    const double from_s = reactionTo(now_s);
    (kind == OverrideKind::Power ? power_ : flow_).lead(share, from_s, settings_.override_ramp_s);
    if (state_ != TrajectoryFeederState::Aborted) sent_ = std::min(sent_, stepBefore(from_s));
  }

  bool isOver(double now_s) const {
    return state_ == TrajectoryFeederState::Aborted ||
           (state_ == TrajectoryFeederState::Running && !isHeld() && now_s >= restTime());
  }

  void abort(double now_s) {
    if (isOver(now_s)) return;
    const bool was_running = state_ == TrajectoryFeederState::Running;
    const bool brakes = was_running && brakeFrom(reactionTo(now_s));
    if (was_running && !brakes) rest_ = timeline_.placeAt(timeline_.end());
    state_ = TrajectoryFeederState::Aborted;
    held_layer_.reset();
    reschedule();
    // What the controller has is replaced from now on: the motion is the same until the reaction.
    schedule_.makeSafeFrom(now_s);
    sent_ = std::min(sent_, std::max(0L, stepBefore(now_s)));
  }

  void lift(double now_s, const ToolLift& lift, const KinematicModel& model) {
    lift_ = toolLift(rest_.curve->at(rest_.span, rest_.along).position, lift, model, motion_->settings());
    const double start_s = std::max(restTime(), timeOf(stepAfter(now_s + settings_.reaction_s)));
    if (sent_ >= lastStep()) sent_ = std::max(sent_, stepAfter(start_s) - 1);
    appendRest(PhaseKind::Halt, start_s - timeline_.end());
    timeline_.append(lift_->plan().timeline(), 0, 1.0);
  }

 private:
  /// What braking changes.
  struct WayToRest {
    Timeline timeline;
    MotionPlace rest;
    long sent = -1;
  };
  WayToRest wayToRest() const { return {timeline_, rest_, sent_}; }
  void goBackTo(const WayToRest& way) {
    timeline_ = way.timeline;
    rest_ = way.rest;
    sent_ = way.sent;
  }

  SharedSpeeds sharedSpeeds() const { return {*speeds_, std::min(speed_share_, 1.0)}; }

  std::string shareRefusal(OverrideKind kind, double share) const {
    if (kind == OverrideKind::Feed) return "a feed is no share of the process; expected flow or power";
    if (kind == OverrideKind::Power && !statesPower())
      return "the toolpath states no laser power; expected the process value laser_power_w in its paths";
    return overrideRefusal(kind, share, boundsOf(kind));
  }
  bool statesPower() const {
    const JointCurve& curve = motion_->curve();
    for (std::size_t span = 0; span < curve.spanCount(); ++span)
      if (curve.spanEnd(span).levels.has(ProcessLevel::LaserPower)) return true;
    return false;
  }

  std::size_t layerOf(const MotionPlace& place) const {
    return place.curve->spanEnd(place.span).heading_for.layer;
  }

  /// Whether a rest is where a layer, or one above it, is being deposited.
  bool restsOnBeadFrom(std::size_t layer, const MotionPlace& rest) const {
    return layerOf(rest) >= layer && rest.along > 0.0 && rest.curve->spanEnd(rest.span).area_mm2 > 0.0;
  }

  /// Where braking from a time before the end would lead to.
  MotionPlace stopFrom(double cut_s) const {
    Timeline way = restAt(timeline_.placeAt(cut_s));
    fastest_->appendStop(way, timeline_.placeAt(cut_s));
    return way.placeAt(way.end());
  }

  /// A timeline of nothing but a rest, of one point.
  Timeline restAt(const MotionPlace& place) const {
    Timeline rest;
    rest.append({0.0, place.curve, place.along, 0.0, 0.0, place.span, PhaseKind::Halt}, timeOf(1));
    return rest;
  }

  /// A way to rest that would end beyond where the layer begins is no shorter than the one that it is on.
  void pauseHeld(double now_s) {
    const WayToRest held = wayToRest();
    if (brakeFrom(reactionTo(now_s)) && layerOf(rest_) < *held_layer_)
      held_layer_.reset();
    else
      goBackTo(held);
  }

  double timeOf(long step) const { return static_cast<double>(step) / settings_.rate_hz; }
  long stepAfter(double time_s) const {
    return static_cast<long>(std::ceil(time_s * settings_.rate_hz - kGridSlack));
  }
  long stepBefore(double time_s) const {
    return static_cast<long>(std::floor(time_s * settings_.rate_hz + kGridSlack));
  }
  long lastStep() const { return stepAfter(restTime()); }

  /// When the first motion of a layer begins; nothing if it is not planned.
  std::optional<double> layerBegin(std::size_t layer) const {
    const std::vector<Phase>& phases = timeline_.phases();
    const auto begins = std::partition_point(phases.begin(), phases.end(), [layer](const Phase& phase) {
      return phase.curve->spanEnd(phase.span).heading_for.layer < layer;
    });
    if (begins == phases.end()) return std::nullopt;
    return begins->time_s;
  }

  /// Time of the first point that a request made now can still change. Before the start nothing has moved.
  double reactionTo(double now_s) const {
    if (sent_ < 0 && now_s <= 0.0) return 0.0;
    return timeOf(std::max(0L, stepAfter(now_s + settings_.reaction_s)));
  }

  /// Plans the motion anew from the first point that can still change, or from the end of a rest that it
  /// falls in; false if there is no motion left.
  bool goOnAtSpeed(double now_s) {
    double cut_s = reactionTo(now_s);
    while (cut_s < timeline_.end() && timeline_.placeAt(cut_s).kind != PhaseKind::Move)
      cut_s = timeline_.endOf(timeline_.phaseAt(cut_s));
    if (cut_s >= timeline_.end()) return false;
    const MotionPlace place = timeline_.placeAt(cut_s);
    timeline_.cut(cut_s);
    fastest_->appendFrom(timeline_, place, sharedSpeeds(), RestThere::Over);
    sent_ = std::min(sent_, stepBefore(cut_s));
    return true;
  }

  /// Plans the way to rest from a time on; false if the motion ends before that.
  bool brakeFrom(double cut_s) {
    if (cut_s >= timeline_.end()) return false;
    const MotionPlace place = timeline_.placeAt(cut_s);
    if (cut_s > 0.0) {
      timeline_.cut(cut_s);
    } else {
      timeline_ = restAt(place);
    }
    fastest_->appendStop(timeline_, place);
    rest_ = timeline_.placeAt(timeline_.end());
    sent_ = std::min(sent_, stepBefore(cut_s));
    return true;
  }

  void appendRest(PhaseKind kind, double duration_s) {
    timeline_.append({0.0, rest_.curve, rest_.along, 0.0, 0.0, rest_.span, kind}, duration_s);
  }

  void reschedule() {
    schedule_ = ProcessSchedule(timeline_, motion_->averaging(), motion_->settings().process,
                                ProcessSchedule::Beads::Cut);
  }

  std::shared_ptr<const TimedMotion> motion_;
  std::shared_ptr<const TimedMotion> lift_;
  TrajectoryFeederSettings settings_;
  Timeline timeline_;
  ProcessSchedule schedule_;
  TrajectoryFeederState state_ = TrajectoryFeederState::Running;
  std::optional<std::size_t> held_layer_;  ///< in front of which it stops, or is paused
  MotionPlace rest_;                       ///< where it is paused, held or aborted, or begins
  std::shared_ptr<const SpeedPlan> planned_;
  std::shared_ptr<const SpeedPlan> speeds_;   ///< gone on at, or at a share of
  std::shared_ptr<const SpeedPlan> fastest_;  ///< than which nothing that is under way is faster
  double speed_share_ = 1.0;                  ///< of the planned speeds
  double fastest_share_ = 1.0;
  LaidSpans laid_;
  RampedShare flow_;   ///< of the planned material
  RampedShare power_;  ///< of the planned power
  long sent_ = -1;     ///< step of the last point handed over
};

std::string speedRefusal(double share, const TrajectoryFeederSettings& settings) {
  const std::string refusal = overrideRefusal(OverrideKind::Feed, share, {kLeastSpeed, settings.feed_most});
  const bool is_too_fast = share > settings.feed_most;
  return refusal + (is_too_fast ? "; feeder.feed_most allows more, up to 3" : "");
}

TrajectoryFeeder::TrajectoryFeeder(const TimedPath& path, const TrajectoryFeederSettings& settings,
                                   double from_mm) {
  TrajectoryFeederSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  state_ = std::make_unique<State>(path.motion(), settings);
  if (from_mm > 0.0) state_->beginAt(from_mm);
}
TrajectoryFeeder::~TrajectoryFeeder() = default;
TrajectoryFeeder::TrajectoryFeeder(TrajectoryFeeder&&) noexcept = default;
TrajectoryFeeder& TrajectoryFeeder::operator=(TrajectoryFeeder&&) noexcept = default;

std::optional<TrajectoryChunk> TrajectoryFeeder::next(double now_s) { return state_->next(now_s); }
void TrajectoryFeeder::pause(double now_s) { state_->pause(now_s); }
SpeedChange TrajectoryFeeder::speedChange(double share) const { return state_->speedChange(share); }
bool TrajectoryFeeder::setSpeed(const SpeedChange& change, double now_s,
                                const std::function<double()>& clock) {
  return state_->setSpeed(change, now_s, clock);
}
void TrajectoryFeeder::setSpeed(const SpeedChange& change, double now_s) {
  state_->setSpeed(change, now_s, [now_s] { return now_s; });
}
void TrajectoryFeeder::setSpeed(double share, double now_s) { setSpeed(speedChange(share), now_s); }
void TrajectoryFeeder::setShare(OverrideKind kind, double share, double now_s) {
  state_->setShare(kind, share, now_s);
}
void TrajectoryFeeder::resume(double now_s) { state_->resume(now_s); }
bool TrajectoryFeeder::holdAtLayer(std::size_t layer, double now_s) { return state_->hold(layer, now_s); }
void TrajectoryFeeder::release(double now_s) { state_->release(now_s); }
bool TrajectoryFeeder::isHeld() const { return state_->isHeld(); }
void TrajectoryFeeder::abort(double now_s) { state_->abort(now_s); }

void TrajectoryFeeder::abort(double now_s, const ToolLift& lift, const KinematicModel& model) {
  if (state_->isOver(now_s)) return;
  state_->abort(now_s);
  state_->lift(now_s, lift, model);
}

TrajectoryFeederState TrajectoryFeeder::state() const { return state_->state(); }
double TrajectoryFeeder::restTime() const { return state_->restTime(); }
JointState TrajectoryFeeder::at(double time_s) const { return state_->at(time_s); }
LaidAmount TrajectoryFeeder::laidAt(double time_s) const { return state_->laidAt(time_s); }
std::vector<ProcessEvent> TrajectoryFeeder::events() const { return state_->events(); }

}  // namespace lamina
