// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A print with a sensor that trails the nozzle, by a feeder that drifts within its layers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/control/run/loop_run.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

constexpr double kSpeed = 20.0;        // mm/s
constexpr double kTrimmedLayer = 1.5;  // mm
constexpr double kReportMm = 1.5;      // way between reports of pose and sensor
constexpr std::size_t kLayers = 3;     // the third is the first that is corrected
constexpr double kHandedMm = 10.0;     // way that the machine has ahead, and that a map takes to come

struct DriftCase {
  double trim = 0.0;
  bool is_confirmed = false;  ///< the machine tells of each layer that all of it is laid by its map
  double behind_mm = 25.0;
  double growth = 1.0;  ///< over commanded growth
  double length_mm = 6000.0;
  std::uint64_t seed = 1;
};

/// A wall along x, laid bead upon bead, which the sensor sees `behind_mm` behind the nozzle.
class TrailedWall {
 public:
  explicit TrailedWall(const DriftCase& drift) : drift_(drift), random_(drift.seed) {
    part_.toolpath.part_name = "long wall";
    for (std::size_t k = 0; k < kLayers; ++k) {
      const double z = kTrimmedLayer * static_cast<double>(k + 1);
      Path bead;
      bead.role = PathRole::OuterWall;
      bead.bead = Bead{3.0, kTrimmedLayer};
      bead.feed_mm_s = kSpeed;
      bead.points = {{0, 0, z}, {drift_.length_mm, 0, z}};
      Path back;
      back.role = PathRole::Travel;
      back.feed_mm_s = 200.0;
      back.points = {{drift_.length_mm, 0, z}, {0, 0, z + kTrimmedLayer}};
      part_.toolpath.layers.push_back({z, kTrimmedLayer, {bead, back}});
    }
    part_.toolpath.layers.back().paths.pop_back();
    part_.toolpath_id = toolpathId(part_.toolpath);
    heights_.assign(static_cast<std::size_t>(drift_.length_mm / kReportMm) + 1, 0.0);
  }

  /// Root mean square of what each corrected layer grew otherwise than planned, in layers.
  double print() {
    LoopRunSettings settings = test::calibratedLoop();
    settings.loop.trim = drift_.trim;
    settings.loop.sensor_behind_mm = drift_.behind_mm;
    settings.loop.trim_lead_mm = kHandedMm;
    settings.cell_mm = 1.5;
    settings.reorder_s = 0.0;
    settings.following.look_ahead_mm = 100.0;
    LoopRun run(part_, settings);
    double squares = 0.0;
    for (std::size_t k = 0; k < kLayers; ++k) {
      const double off = printLayer(run, k);
      if (k >= 2) squares += off * off / static_cast<double>(kLayers - 2);
    }
    return std::sqrt(squares);
  }
  std::size_t mapsOf(std::size_t layer) const {
    return static_cast<std::size_t>(std::count_if(
        maps_.begin(), maps_.end(), [layer](const CorrectionMap& m) { return m.layer == layer; }));
  }
  /// Of the last layer's growth over what it was planned, at each report.
  const std::vector<double>& growth() const { return growth_; }

 private:
  double printLayer(LoopRun& run, std::size_t k) {
    const double wave_mm = random_.uniform(3000.0, 5000.0);
    const double phase = random_.uniform(0.0, 2.0 * M_PI);
    const double z = kTrimmedLayer * static_cast<double>(k + 1);
    const auto handed = static_cast<std::size_t>(kHandedMm / kReportMm);
    std::vector<double> amounts(heights_.size(), 0.0);
    double squares = 0.0;
    growth_.clear();
    takeMaps(run);
    if (drift_.is_confirmed) run.missMap({k, 0.0, {}, PlaceOnLayer{}});
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      const double x = kReportMm * static_cast<double>(i);
      // What is handed over is by the map that was there then.
      if (i == 0)
        for (std::size_t ahead = 0; ahead < handed; ++ahead) amounts[ahead] = amountAt(k, ahead);
      if (i + handed < heights_.size()) amounts[i + handed] = amountAt(k, i + handed);
      const double drift = 0.05 * std::sin(2.0 * M_PI * x / wave_mm + phase);
      growth_.push_back(drift_.growth * (1.0 + amounts[i]) * (1.0 + drift) - 1.0);
      heights_[i] += kTrimmedLayer * (1.0 + growth_.back());
      squares += growth_.back() * growth_.back();
      now_ns_ += static_cast<std::int64_t>(1e9 * kReportMm / kSpeed);
      run.observe({now_ns_, {x, 0, z}});
      see(run, x, z);
      takeMaps(run);
    }
    return std::sqrt(squares / static_cast<double>(heights_.size()));
  }

  void see(LoopRun& run, double x, double z) {
    const double at = x - drift_.behind_mm;
    if (at < 0.0) return;
    SensedCloud cloud;
    cloud.stamp_ns = now_ns_;
    cloud.bed_from_sensor = test::sensorOver({at, 0, z});
    cloud.profiles.emplace_back();
    const double top = heights_[static_cast<std::size_t>(std::lround(at / kReportMm))];
    for (int p = -4; p <= 4; ++p)
      cloud.profiles[0].emplace_back(0.1 * p, 0.0, z + 60.0 - top + random_.normal(0.0, 0.01));
    run.see(std::move(cloud));
  }

  void takeMaps(LoopRun& run) {
    for (CorrectionMap& map : run.takeNews().maps) maps_.push_back(std::move(map));
  }
  double amountAt(std::size_t layer, std::size_t place) const {
    if (maps_.empty() || maps_.back().layer != layer || maps_.back().paths.empty()) return 0.0;
    return correctionAt(maps_.back().paths[0], kReportMm * static_cast<double>(place)).amount;
  }

  DriftCase drift_;
  Random random_;
  PlacedPart part_;
  std::vector<double> heights_, growth_;
  std::vector<CorrectionMap> maps_;
  std::int64_t now_ns_ = 1'000'000'000'000;
};

double meanOff(DriftCase drift) {
  double sum = 0.0;
  for (drift.seed = 1; drift.seed <= 2; ++drift.seed) sum += TrailedWall(drift).print() / 2.0;
  return sum;
}

/// A drift that differs from layer to layer, so that no layer below can tell it.
TEST(TrimmedRun, TakesASixthOffTheDriftWithinALayer) {
  for (const double behind_mm : {25.0, 60.0}) {
    DriftCase drift;
    drift.behind_mm = behind_mm;
    const double without = meanOff(drift);
    drift.trim = 0.18;
    const double with = meanOff(drift);
    RecordProperty("share_" + std::to_string(static_cast<int>(behind_mm)), std::to_string(with / without));
    EXPECT_LT(with, 0.85 * without) << behind_mm << ": " << without << " to " << with;
  }
}

TEST(TrimmedRun, WithoutATrimALayerHasOneMap) {
  DriftCase drift;
  drift.length_mm = 200.0;
  TrailedWall plain(drift);
  plain.print();
  drift.trim = 0.18;
  TrailedWall trimmed(drift);
  trimmed.print();
  for (std::size_t k = 0; k < kLayers; ++k) EXPECT_EQ(plain.mapsOf(k), 1U) << k;
  EXPECT_GT(trimmed.mapsOf(kLayers - 1), 1U);
  drift.is_confirmed = true;
  TrailedWall confirmed(drift);
  confirmed.print();
  EXPECT_EQ(confirmed.mapsOf(kLayers - 1), trimmed.mapsOf(kLayers - 1)) << "nothing was missed";
}

}  // namespace
}  // namespace lamina
