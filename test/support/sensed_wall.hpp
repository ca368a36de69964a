// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/control/run/loop_run.hpp"

namespace lamina::test {

/// What the sensor does in a layer.
enum class SensorDoes {
  Measure,
  KeepSilent,
  SayNothing,  ///< points that are no numbers
  SayTheSame,
  Scatter,        ///< each profile elsewhere within the window of a cell
  LoseTransform,  ///< clouds, but no poses
  LagBehind,      ///< stamps that are `lag_s` late
  SpoutGarbage    ///< clouds of anything, some of them of long ago
};

/// A straight wall, one bead a layer, deposited along x and scanned on the way back, by a process that lays
/// `growth` of what is commanded; the loop over it changes what is commanded.
struct SensedWallCase {
  LoopRunSettings settings;
  double growth = 0.9;
  std::size_t layers = 8;
  double length_mm = 60.0;
  double layer_mm = 1.5;
  double width_mm = 3.0;
  double speed_mm_s = 20.0;
  double scan_mm_s = 48.0;
  double noise_mm = 0.01;  ///< of a point; the loop's `sight.sigma_mm`
  std::int64_t start_ns = 1'000'000'000'000;
  std::uint64_t seed = 1;
  std::function<SensorDoes(std::size_t layer)> sensor = {};  ///< measures where empty
  int scans = 1;                                             ///< passes over the wall, odd
  double scan_margin_mm = 0.0;                               ///< beyond both of its ends
  double lag_s = 0.05;
  bool sees_bed = false;  ///< beside the wall and beyond its ends, 12 mm to either side
  /// How far off its place the sensor shows a layer: along, beside and up [mm].
  std::function<Point3(std::size_t layer)> shows_off = {};
  /// Growth over `growth`, by the number of the layer deposited; 1 where empty.
  std::function<double(std::size_t layer, double along_mm)> grows = {};
  /// What befalls the wall once a layer is deposited: heights 1 mm apart.
  std::function<void(std::size_t layer, std::vector<double>& heights_mm)> befalls = {};
  /// What the operator does with the loop while the bead of a layer is deposited.
  std::function<void(std::size_t layer, LoopRun& run)> operates = {};
  std::string machine = {};    ///< that it is printed on
  bool follows_plans = false;  ///< goes on with a plan as soon as it is offered
  /// Whether the machine lays a layer as planned, having waited for its map in vain.
  std::function<bool(std::size_t layer)> misses_map = {};
  /// Of such a layer the way that is deposited before the map holds after all; none where it never does.
  std::optional<double> missed_mm = {};
  bool is_miss_told_early = false;   ///< while the layer before is deposited
  bool takes_coasting_maps = false;  ///< for such layers, else they are laid as planned
};

/// What was sent and what came of it. Heights lie 1 mm apart along the wall.
struct SensedWall {
  PlacedPart part;
  std::vector<StampedTip> tips;
  std::vector<SensedCloud> clouds;
  std::vector<CorrectionMap> maps;
  std::vector<CorrectionMap> coasting_maps;
  std::vector<LayerOutcome> layers;
  std::vector<RaisedAlarm> alarms;
  std::vector<PrintPlan> plans;
  std::vector<std::vector<double>> heights_mm;  ///< of each layer's top
  LoopStatus status;
  LoopCounts counts;
  std::optional<PartMap> learnt;  ///< for the next part, this one being complete
};

/// The loop that the tests are about: calibrated, active from the first layer on.
inline LoopRunSettings calibratedLoop() {
  LoopRunSettings settings;
  settings.request = LoopRequest::Active;
  settings.calibration.is_time_offset_trusted = true;
  settings.calibration.is_place_trusted = true;
  settings.sight.sigma_mm = 0.01;
  settings.loop.reading_correlation = 0.0;
  return settings;
}

/// Sixty millimetres above the nozzle tip, looking down; its line lies along y.
inline Eigen::Isometry3d sensorOver(const Point3& tip) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().col(0) = Eigen::Vector3d::UnitY();
  pose.linear().col(1) = Eigen::Vector3d::UnitX();
  pose.linear().col(2) = -Eigen::Vector3d::UnitZ();
  pose.translation() = tip + Point3(0, 0, 60.0);
  return pose;
}

inline Toolpath scannedWall(const SensedWallCase& wall) {
  Toolpath toolpath;
  toolpath.part_name = "wall";
  for (std::size_t k = 0; k < wall.layers; ++k) {
    const double z = wall.layer_mm * static_cast<double>(k + 1);
    const double above = z + 5.0;
    const double margin = wall.scan_margin_mm;
    Path bead;
    bead.role = PathRole::OuterWall;
    bead.bead = Bead{wall.width_mm, wall.layer_mm};
    bead.feed_mm_s = wall.speed_mm_s;
    bead.points = {{0, 0, z}, {wall.length_mm, 0, z}};
    Path scan;
    scan.role = PathRole::Travel;
    scan.feed_mm_s = wall.scan_mm_s;
    scan.points = {{wall.length_mm, 0, z}, {wall.length_mm + margin, 0, above}};
    for (int pass = 0; pass < wall.scans; ++pass)
      scan.points.emplace_back(pass % 2 == 0 ? -margin : wall.length_mm + margin, 0, above);
    scan.points.emplace_back(0, 0, k + 1 < wall.layers ? z + wall.layer_mm : above + 1.0);
    toolpath.layers.push_back({z, wall.layer_mm, {bead, scan}});
  }
  return toolpath;
}

/// Prints the wall: poses every 20 ms, a profile every 10 ms of the scan with a point every 0.1 mm.
class SensedWallPrinter {
 public:
  explicit SensedWallPrinter(const SensedWallCase& wall)
      : wall_(wall), random_(wall.seed), now_ns_(wall.start_ns), surface_(places(), 0.0) {
    printed_.part.toolpath = scannedWall(wall);
    printed_.part.toolpath_id = toolpath_id_ = toolpathId(printed_.part.toolpath);
    printed_.part.machine = wall.machine;
    toolpath_ = printed_.part.toolpath;
  }

  SensedWall print() {
    LoopRun run(printed_.part, wall_.settings);
    run_ = &run;
    take();
    for (std::size_t k = 0; k < toolpath_.layers.size(); ++deposited_) {
      printLayer(k);
      k = goesOn() ? 0 : k + 1;
    }
    run.finish();
    take();
    printed_.status = run.status();
    printed_.counts = run.counts();
    printed_.learnt = run.learnt(PartEnd::Complete);
    return std::move(printed_);
  }

 private:
  std::size_t places() const { return static_cast<std::size_t>(wall_.length_mm) + 1; }

  void printLayer(std::size_t k) {
    run_->passAll();  // the machine waits for its map
    take();
    const double planned_mm = plannedHeight(toolpath_.layers[k].paths[0]);
    for (std::size_t i = 0; i < places(); ++i) {
      const double grows = wall_.grows ? wall_.grows(deposited_, static_cast<double>(i)) : 1.0;
      surface_[i] += wall_.growth * grows * planned_mm * (1.0 + amountAt(k, i));
    }
    if (wall_.befalls) wall_.befalls(deposited_, surface_);
    printed_.heights_mm.push_back(surface_);
    const auto& paths = toolpath_.layers[k].paths;
    go(paths[0].points[0], paths[0].points[1], wall_.speed_mm_s, SensorDoes::KeepSilent);
    const std::size_t reported = wall_.is_miss_told_early ? k + 1 : k;
    if (misses(reported)) run_->missMap(missed(reported));
    if (wall_.operates) wall_.operates(k, *run_);
    const SensorDoes does = wall_.sensor ? wall_.sensor(deposited_) : SensorDoes::Measure;
    const auto& scan = paths[1].points;
    for (std::size_t m = 0; m + 1 < scan.size(); ++m)
      go(scan[m], scan[m + 1], wall_.scan_mm_s, m > 0 && m + 2 < scan.size() ? does : SensorDoes::KeepSilent);
  }

  /// Whether the machine goes on with a plan that was offered when the layer was done.
  bool goesOn() {
    const std::size_t plans = printed_.plans.size();
    run_->passAll();
    take();
    if (!wall_.follows_plans || printed_.plans.size() == plans) return false;
    const PlacedPart& part = printed_.plans.back().part;
    if (!run_->follow(part.toolpath_id)) return false;
    toolpath_ = part.toolpath;
    toolpath_id_ = part.toolpath_id;
    return true;
  }

  /// What a bead grows by where the process lays what is commanded: its volume over the width of the wall.
  double plannedHeight(const Path& bead) const {
    const Bead& deposited = bead.bead.at(1);
    const double as_wide = crossSection({wall_.width_mm, deposited.height_mm});
    return deposited.height_mm * crossSection(deposited) / as_wide;
  }

  bool misses(std::size_t layer) const { return wall_.misses_map && wall_.misses_map(layer); }

  MissedMap missed(std::size_t layer) const {
    MissedMap missed{layer, 2.5, {}, {}};
    if (wall_.missed_mm) missed.held_from = PlaceOnLayer{0, *wall_.missed_mm};
    missed.is_coasting = wall_.takes_coasting_maps;
    return missed;
  }

  double amountAt(std::size_t layer, std::size_t place) const {
    if (!misses(layer)) return amountIn(printed_.maps, layer, static_cast<double>(place));
    // From what the layer before ended with to nothing or to the coasting map, and from there to the map, as
    // fast as the feeder is.
    const double along = static_cast<double>(place);
    const double missed = std::min(along, wall_.missed_mm.value_or(1e9));
    const double before = layer > 0 ? amountAt(layer - 1, places() - 1) : 0.0;
    const double steepest = wall_.settings.loop.feeder_rate_s / wall_.speed_mm_s;
    const std::vector<CorrectionMap> none;
    const double other =
        amountIn(wall_.takes_coasting_maps ? printed_.coasting_maps : none, layer, along) - before;
    const double faded = before + std::clamp(other, -steepest * missed, steepest * missed);
    if (missed == along) return faded;
    const double most = steepest * (along - missed);
    return faded + std::clamp(amountIn(printed_.maps, layer, along) - faded, -most, most);
  }

  double amountIn(const std::vector<CorrectionMap>& maps, std::size_t layer, double along_mm) const {
    const CorrectionMap* latest = nullptr;
    for (const CorrectionMap& map : maps)
      if (map.layer == layer && map.toolpath_id == toolpath_id_) latest = &map;
    if (latest == nullptr || latest->paths.empty()) return 0.0;
    return correctionAt(latest->paths[0], along_mm).amount;
  }

  /// Straight from pose to pose; profiles halfway between them and at them.
  void go(const Point3& from, const Point3& to, double speed, SensorDoes does) {
    constexpr std::int64_t kHalf = 10'000'000;
    speed_mm_s_ = (to - from).normalized().x() * speed;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / speed / 0.02)));
    for (int i = 1; i <= steps; ++i) {
      const Point3 half = from + (to - from) * ((i - 0.5) / steps);
      const Point3 tip = from + (to - from) * (static_cast<double>(i) / steps);
      if (does != SensorDoes::KeepSilent && does != SensorDoes::LoseTransform)
        sense(now_ns_ + kHalf, half, does);
      now_ns_ += 2 * kHalf;
      if (does == SensorDoes::LoseTransform) {
        run_->hear(now_ns_);
        continue;
      }
      printed_.tips.push_back({now_ns_, tip});
      run_->observe(printed_.tips.back());
      if (does != SensorDoes::KeepSilent) sense(now_ns_, tip, does);
    }
    take();
  }

  /// Height of the wall's top, straight from place to place; not finite beyond its ends.
  double topAt(double along_mm) const {
    if (!(along_mm >= 0.0) || along_mm > wall_.length_mm) return std::numeric_limits<double>::quiet_NaN();
    const auto place = std::min(static_cast<std::size_t>(along_mm), surface_.size() - 2);
    const double part = along_mm - static_cast<double>(place);
    return surface_[place] + part * (surface_[place + 1] - surface_[place]);
  }

  void sense(std::int64_t stamp_ns, const Point3& tip, SensorDoes does) {
    SensedCloud cloud;
    cloud.stamp_ns = stamp_ns;
    cloud.bed_from_sensor = sensorOver(tip);
    cloud.profiles.emplace_back();
    const double lag_mm = does == SensorDoes::LagBehind ? wall_.lag_s * speed_mm_s_ : 0.0;
    const Point3 off = wall_.shows_off ? wall_.shows_off(deposited_) : Point3::Zero();
    double top = topAt(tip.x() - lag_mm - off.x());
    if (does == SensorDoes::Scatter) top += random_.uniform(-1.0, 1.0) * wall_.layer_mm;
    const int side = wall_.sees_bed ? 120 : 20;
    for (int i = -side; i <= side; ++i) {
      const double y = 0.1 * i;
      double depth = std::numeric_limits<double>::quiet_NaN();
      const bool is_on_wall = std::abs(y - off.y()) < 0.5 * wall_.width_mm;
      const double seen = wall_.sees_bed && !(is_on_wall && std::isfinite(top)) ? 0.0 : top;
      if (is_on_wall || wall_.sees_bed)
        depth = tip.z() + 60.0 - (seen + off.z()) + random_.normal(0.0, wall_.noise_mm);
      if (does == SensorDoes::SayNothing) depth = std::numeric_limits<double>::quiet_NaN();
      if (does == SensorDoes::SayTheSame) depth = 65.0;
      cloud.profiles[0].emplace_back(y, 0.0, depth);
    }
    if (does == SensorDoes::SpoutGarbage) spoil(cloud);
    printed_.clouds.push_back(cloud);
    run_->see(std::move(cloud));
  }

  void spoil(SensedCloud& cloud) {
    constexpr double kAny[] = {0.0, 1e300, -1e300, 60.0, 64.0, 65.0};
    if (random_.uniform(0.0, 1.0) < 0.1) cloud.stamp_ns -= 50'000'000'000;
    if (random_.uniform(0.0, 1.0) < 0.2) cloud.profiles.clear();
    if (random_.uniform(0.0, 1.0) < 0.2) cloud.profiles.resize(cloud.profiles.size() + 2);
    for (auto& profile : cloud.profiles)
      for (Point3& point : profile) {
        const double kind = random_.uniform(0.0, 10.0);
        double& value = point[static_cast<Eigen::Index>(random_.uniform(0.0, 2.999))];
        if (kind < 6.0) value = kAny[static_cast<std::size_t>(kind)];
        if (kind > 9.0) value = std::numeric_limits<double>::infinity();
      }
  }

  void take() {
    LoopNews news = run_->takeNews();
    for (auto& map : news.coasting_maps) printed_.coasting_maps.push_back(std::move(map));
    for (auto& map : news.maps) printed_.maps.push_back(std::move(map));
    for (auto& layer : news.layers) printed_.layers.push_back(std::move(layer));
    for (auto& plan : news.plans) printed_.plans.push_back(std::move(plan));
    for (auto& alarm : news.alarms) printed_.alarms.push_back(std::move(alarm));
  }

  SensedWallCase wall_;
  Random random_;
  Toolpath toolpath_;  ///< under way
  std::string toolpath_id_;
  std::size_t deposited_ = 0;  ///< layers, of all plans
  std::int64_t now_ns_;
  double speed_mm_s_ = 0.0;  ///< of the sensor along the wall
  std::vector<double> surface_;
  SensedWall printed_;
  LoopRun* run_ = nullptr;
};

inline SensedWall sensedWall(const SensedWallCase& wall) { return SensedWallPrinter(wall).print(); }

/// What the loop has to come to where every cell is like every other and the sensor is exact: the mean error
/// below each layer, what is learnt of the growth, and the correction.
struct WallTruth {
  std::vector<double> error_mm;  ///< of each layer's top
  std::vector<double> gain;      ///< learnt with it
  std::vector<double> amount;    ///< that it is deposited with
};

inline WallTruth wallTruth(const SensedWallCase& wall) {
  WallTruth truth;
  const LoopSettings& loop = wall.settings.loop;
  double error = 0.0;
  double gain = 1.0;
  for (std::size_t k = 0; k < wall.layers; ++k) {
    const bool corrects = k >= static_cast<std::size_t>(loop.first_layers);
    const double amount = corrects ? (1.0 + loop.gain * error / wall.layer_mm) / gain - 1.0 : 0.0;
    error += wall.layer_mm * (1.0 - wall.growth * (1.0 + amount));
    gain += loop.learning * (wall.growth - gain);
    truth.amount.push_back(amount);
    truth.error_mm.push_back(error);
    truth.gain.push_back(gain);
  }
  return truth;
}

}  // namespace lamina::test
