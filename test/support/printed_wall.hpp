// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/replanning.hpp"
#include "lamina/control/supervision.hpp"
#include "lamina/control/z_follow.hpp"
#include "lamina/deposition/growth_plant.hpp"

namespace lamina::test {

/// A wall that is printed by a disturbed process and measured: one bead per layer, straight or round.
struct WallCase {
  PlantSettings plant;
  LoopSettings loop;
  LoopState state = LoopState::Active;
  bool is_supervised = false;  ///< from `Active`; replanned where supervision asks for it
  /// What the loop is in at a layer; `state` where empty.
  std::function<LoopState(std::size_t layer)> state_at = {};
  FeederDelay lead;                    ///< what the feeder is taken to be
  bool is_commanded_by_place = false;  ///< as by a program: nothing before the layer begins
  std::size_t layers = 40;
  std::size_t measured_every = 1;
  double length_mm = 200.0;
  double cell_mm = 0.5;
  double layer_mm = 1.5;
  double speed_mm_s = 10.0;
  bool is_closed = false;
  double noise_mm = 0.02;   ///< of a point
  int points = 6;           ///< of a reading
  std::size_t clouds = 20;  ///< by which a layer is seen
  std::uint64_t seed = 1;
};

/// The figures of a layer, by the true heights.
struct WallLayer {
  double mean_error_mm = 0.0;
  double rmse_mm = 0.0;
  double flatness_mm = 0.0;
  double limited_share = 0.0;
  LayerFigures estimated;
  std::vector<RaisedAlarm> alarms;

  bool raises(LoopAlarm alarm) const {
    return std::any_of(alarms.begin(), alarms.end(),
                       [&](const RaisedAlarm& each) { return each.alarm == alarm; });
  }
};

struct PrintedWall {
  std::vector<WallLayer> layers;
  std::vector<double> error_mm;  ///< of the last layer
  std::vector<double> amount;    ///< of the last layer

  /// Root of the mean square over layers, the first of them counted from 1.
  double rmse(std::size_t first, std::size_t last) const {
    return meanSquare(first, last, &WallLayer::rmse_mm);
  }
  double flatness(std::size_t first, std::size_t last) const {
    return meanSquare(first, last, &WallLayer::flatness_mm);
  }

 private:
  double meanSquare(std::size_t first, std::size_t last, double WallLayer::*figure) const {
    double sum = 0.0;
    for (std::size_t k = first; k <= last; ++k) sum += layers[k - 1].*figure * layers[k - 1].*figure;
    return std::sqrt(sum / static_cast<double>(last - first + 1));
  }
};

/// Mean and greatest value of a figure of all seeds from 1 to 5.
template <class Figure>
double meanOfSeeds(const WallCase& wall, Figure figure);
template <class Figure>
double worstOfSeeds(const WallCase& wall, Figure figure);

class WallPrinter {
 public:
  explicit WallPrinter(const WallCase& wall)
      : wall_(wall),
        plant_(wall.plant),
        loop_(wall.loop),
        random_(wall.seed),
        plan_(wall.layers, wall.layer_mm) {
    status_.state = LoopState::Active;
  }

  PrintedWall print() {
    PrintedWall printed;
    for (std::size_t k = 0; k < plan_.size(); ++k) printed.layers.push_back(printLayer(k));
    const double top_mm = wall_.layer_mm * static_cast<double>(wall_.layers);
    for (const double height : heights_) printed.error_mm.push_back(top_mm - height);
    printed.amount = amount_;
    return printed;
  }

 private:
  WallLayer printLayer(std::size_t k) {
    loop_.beginLayer(layerOf(k));
    const LayerCells& cells = loop_.cells();
    if (k == 0) heights_.assign(cells.size(), 0.0);
    const LoopState state =
        wall_.is_supervised ? status_.state : (wall_.state_at ? wall_.state_at(k) : wall_.state);
    const LayerCorrection correction = loop_.correction(state);
    amount_ = correction.amount;
    lay(k, correction);
    loop_.lay(correction);
    if ((k + 1) % wall_.measured_every == 0) measure(k);
    WallLayer layer = figuresOf(k);
    layer.limited_share = correction.limited_share;
    layer.estimated = loop_.endLayer();
    if (wall_.is_supervised) supervise(k, layer);
    return layer;
  }

  void supervise(std::size_t k, WallLayer& layer) {
    const LoopStep step = afterLayer(status_, layer.estimated, wall_.loop);
    status_ = step.status;
    layer.alarms = step.alarms;
    for (const RaisedAlarm& alarm : step.alarms)
      if (alarm.reaction == LoopReaction::Replan) replan(k, layer.estimated);
  }

  void replan(std::size_t k, const LayerFigures& figures) {
    const PartUnderWay part{{plan_.begin() + static_cast<std::ptrdiff_t>(k) + 1, plan_.end()},
                            figures.mean_error_mm,
                            figures.gain_mean};
    const auto heights = scaledHeights(part, {});
    if (!heights) return;
    plan_.resize(k + 1);
    plan_.insert(plan_.end(), heights->heights_mm.begin(), heights->heights_mm.end());
    plan_[k] -= figures.mean_error_mm;  // heights count from what is deposited
    flow_ *= heights->flow;
    loop_.replan(-figures.mean_error_mm, heights->flow);
    status_ = afterReplan(status_, -figures.mean_error_mm);
  }

  /// Where the top of a layer should be.
  double topOf(std::size_t k) const {
    double top = 0.0;
    for (std::size_t i = 0; i <= k; ++i) top += plan_[i];
    return top;
  }

  LayerCells layerOf(std::size_t k) const {
    const double z = topOf(k);
    Path path;
    path.role = PathRole::OuterWall;
    path.is_closed = wall_.is_closed;
    path.bead = Bead{3.0, plan_[k]};
    path.feed_mm_s = wall_.speed_mm_s;
    path.points = {{0, 0, z}, {wall_.length_mm, 0, z}};
    constexpr int kCorners = 400;
    if (wall_.is_closed) path.points.clear();
    for (int i = 0; i < kCorners && wall_.is_closed; ++i) {
      const double angle = 2.0 * M_PI * i / kCorners;
      const double radius = wall_.length_mm / (2.0 * M_PI);
      path.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return layerCells({z, plan_[k], {path}}, k, wall_.cell_mm);
  }

  void lay(std::size_t k, const LayerCorrection& correction) {
    const LayerCells& cells = loop_.cells();
    PlantBead bead;
    bead.layer = k;
    bead.layers = wall_.layers;
    bead.length_mm = cells.runs[0].length_mm;
    bead.is_closed = wall_.is_closed;
    bead.layer_s = bead.length_mm / wall_.speed_mm_s;
    bead.along_mm = cells.along_mm;
    bead.planned_mm = cells.height_mm;
    for (double& planned : bead.planned_mm) planned *= flow_;
    bead.correction = delayed(commanded(correction), timesOf(cells), wall_.plant);
    const NozzleRoom room{plan_[k], -1e9, 0.0};
    const auto shift = nozzleShift(cells, loop_.knowledge(), shift_mm_, room, wall_.loop);
    shift_mm_ = meanOverCells(cells, shift);
    for (std::size_t i = 0; i < heights_.size(); ++i)
      bead.nozzle_far_mm.push_back(topOf(k) - plan_[k] - heights_[i] + shift[i]);
    heights_ = plant_.afterBead(bead, heights_);
  }

  /// What the feeder is commanded by time; of a program it knows the end of the layer below.
  TimedValues commanded(const LayerCorrection& correction) {
    const LayerCells& cells = loop_.cells();
    if (!wall_.is_commanded_by_place) {
      FeederCommands commands = feederCommands(cells, correction.amount, wall_.lead, wall_.loop);
      return {std::move(commands.time_s), std::move(commands.amount)};
    }
    const std::vector<double> times = timesOf(cells);
    const std::vector<double> led =
        ledCorrection(cells, correction.amount, expectedNext(correction), wall_.lead, wall_.loop);
    TimedValues joined = commanded_before_;
    for (double& time_s : joined.time_s) time_s -= wall_.length_mm / wall_.speed_mm_s;
    joined.time_s.insert(joined.time_s.end(), times.begin(), times.end());
    joined.value.insert(joined.value.end(), led.begin(), led.end());
    commanded_before_ = {times, led};
    return joined;
  }

  /// As `LoopRun` states it in its maps.
  ExpectedBeginning expectedNext(const LayerCorrection& correction) const {
    HeightLoop next = loop_;
    next.lay(correction);
    next.beginLayer(loop_.cells());
    return expectedBeginning(next.cells(), next.correction(wall_.state).amount, wall_.lead.dead_time_s);
  }

  void measure(std::size_t k) {
    const double reference = topOf(k);
    const double rho = wall_.loop.reading_correlation;
    for (std::size_t cloud = 0; cloud < wall_.clouds; ++cloud) {
      for (std::size_t i = cloud; i < heights_.size(); i += wall_.clouds) {
        const double common = random_.normal(0.0, wall_.noise_mm * std::sqrt(rho));
        double mean = 0.0;
        for (int p = 0; p < wall_.points; ++p)
          mean += random_.normal(0.0, wall_.noise_mm * std::sqrt(1.0 - rho)) / wall_.points;
        loop_.see(i, {reference - heights_[i] + common + mean, wall_.points, wall_.noise_mm});
      }
      loop_.endCloud();
    }
  }

  WallLayer figuresOf(std::size_t k) const {
    WallLayer layer;
    const double reference = topOf(k);
    double squares = 0.0;
    const auto count = static_cast<double>(heights_.size());
    for (const double height : heights_) {
      layer.mean_error_mm += (reference - height) / count;
      squares += (reference - height) * (reference - height) / count;
    }
    layer.rmse_mm = std::sqrt(squares);
    layer.flatness_mm = std::sqrt(std::max(0.0, squares - layer.mean_error_mm * layer.mean_error_mm));
    return layer;
  }

  WallCase wall_;
  GrowthPlant plant_;
  HeightLoop loop_;
  Random random_;
  std::vector<double> plan_;  ///< heights of the layers
  double flow_ = 1.0;         ///< of the plan, over that of the first one
  LoopStatus status_;
  std::vector<double> heights_;
  std::vector<double> amount_;
  double shift_mm_ = 0.0;
  TimedValues commanded_before_;  ///< to the feeder in the layer below
};

inline PrintedWall printedWall(const WallCase& wall) { return WallPrinter(wall).print(); }

/// A figure of each seed from 1 to 5.
template <class Figure>
std::vector<double> figuresOfSeeds(WallCase wall, Figure figure) {
  constexpr int kSeeds = 5;
  std::vector<double> figures;
  figures.reserve(kSeeds);
  for (int seed = 1; seed <= kSeeds; ++seed) {
    wall.seed = static_cast<std::uint64_t>(seed);
    wall.plant.seed = seed;
    figures.push_back(figure(printedWall(wall)));
  }
  return figures;
}

template <class Figure>
double meanOfSeeds(const WallCase& wall, Figure figure) {
  double sum = 0.0;
  const std::vector<double> figures = figuresOfSeeds(wall, figure);
  for (const double each : figures) sum += each / static_cast<double>(figures.size());
  return sum;
}

template <class Figure>
double worstOfSeeds(const WallCase& wall, Figure figure) {
  const std::vector<double> figures = figuresOfSeeds(wall, figure);
  return *std::max_element(figures.begin(), figures.end());
}

/// A feeder that gives a tenth too little, soft ends, a slow wave, randomness, and levelling.
inline PlantSettings disturbedPlant() {
  PlantSettings plant;
  plant.gain = 0.9;
  plant.end_loss = 0.15;
  plant.end_mm = 10.0;
  plant.wave = 0.05;
  plant.wave_mm = 80.0;
  plant.random = 0.03;
  plant.random_mm = 5.0;
  plant.levelling_mm = 1.0;
  return plant;
}

}  // namespace lamina::test
