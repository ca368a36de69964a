// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/growth_plant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kDetachedLength = 30.0;  // mm
constexpr double kReach = 4.0;            // standard deviations

std::uint64_t mixed(std::uint64_t seed, std::uint64_t with) {
  return Random(seed ^ (with * 0x9E3779B97F4A7C15ULL)).bits();
}

/// Continued by reflection at the ends, or round a closed bead.
std::size_t foldedIndex(long index, long count, bool is_closed) {
  if (is_closed) return static_cast<std::size_t>(((index % count) + count) % count);
  const long period = 2 * count;
  const long within = ((index % period) + period) % period;
  return static_cast<std::size_t>(within < count ? within : period - 1 - within);
}

std::vector<double> levelled(const std::vector<double>& heights, const PlantBead& bead, double sigma_mm) {
  const auto count = static_cast<long>(heights.size());
  const double cell = bead.length_mm / static_cast<double>(count);
  const auto reach = static_cast<long>(std::ceil(kReach * sigma_mm / cell));
  std::vector<double> weights;
  double total = 0.0;
  for (long k = -reach; k <= reach; ++k) {
    const double apart = static_cast<double>(k) * cell / sigma_mm;
    weights.push_back(std::exp(-0.5 * apart * apart));
    total += weights.back();
  }
  std::vector<double> level(heights.size());
  for (long i = 0; i < count; ++i) {
    double sum = 0.0;
    for (long k = -reach; k <= reach; ++k)
      sum +=
          weights[static_cast<std::size_t>(k + reach)] * heights[foldedIndex(i + k, count, bead.is_closed)];
    level[static_cast<std::size_t>(i)] = sum / total;
  }
  return level;
}

}  // namespace

void describe(SettingsSchema& schema, PlantSettings& settings) {
  schema.flag("plant.pressed", settings.pressed,
              "Whether the nozzle makes the top of beads, of which what lacks is missing at the sides.");
  schema.number("plant.gain", settings.gain, {0.05, 5.0}, "Growth over commanded growth at the start.");
  schema.number("plant.dead_time_s", settings.dead_time_s, {0.0, 60.0}, "Dead time of the feeder.");
  schema.number("plant.lag_s", settings.lag_s, {0.0, 60.0}, "Time constant of the feeder.");
  schema.number("plant.wear", settings.wear, {0.0, 1.0}, "Share of the gain that is lost over the job.");
  schema.number("plant.end_loss", settings.end_loss, {-1.0, 1.0},
                "Share of the growth lost at ends of beads.");
  schema.number("plant.end_mm", settings.end_mm, {0.01, 1e4}, "Length over which ends are lower.");
  schema.number("plant.wave", settings.wave, {0.0, 1.0}, "Amplitude of a slow wave of growth along a bead.");
  schema.number("plant.wave_mm", settings.wave_mm, {0.1, 1e6}, "Length of that wave.");
  schema.number("plant.random", settings.random, {0.0, 1.0},
                "Standard deviation of what is random in each layer, in layer heights.");
  schema.number("plant.random_mm", settings.random_mm, {0.01, 1e4}, "Length over which that is alike.");
  schema.number("plant.standoff", settings.standoff, {-2.0, 2.0},
                "Loss of growth per nozzle too far away, in layer heights.");
  schema.number("plant.levelling_mm", settings.levelling_mm, {0.0, 100.0},
                "Standard deviation of the Gaussian by which the surface levels itself.");
  schema.number("plant.thermal", settings.thermal, {0.0, 1.0}, "Share of a layer that settles per 100 K.");
  schema.number("plant.cooling_s", settings.cooling_s, {0.1, 1e5}, "Time in which the wall cools.");
  schema.number("plant.slump_s", settings.slump_s, {0.1, 1e5}, "Time in which a layer settles.");
  schema.numbers("plant.nozzle_offset_mm", settings.nozzle_offset_mm, 3,
                 "Where the nozzle lays, off where it is thought to be: along the bead, across, up.");
  schema.number("plant.z_error_mm", settings.z_error_mm, {-100.0, 100.0}, "Error of the axis of height.");
  schema.number("plant.clog", settings.clog, {0.0, 1.0}, "Share of the gain that a clog takes.");
  schema.integer("plant.clog_at_layer", settings.clog_at_layer, {0.0, 1e6}, "Layer of the clog; 0 for none.");
  schema.integer("plant.detach_at_layer", settings.detach_at_layer, {0.0, 1e6},
                 "Layer before which a piece of 30 mm breaks off; 0 for none.");
  schema.integer("plant.seed", settings.seed, {0.0, 1e9}, "Seed of what is random.");
}

bool isDisturbed(const PlantSettings& settings) {
  const bool has_offset = std::any_of(settings.nozzle_offset_mm.begin(), settings.nozzle_offset_mm.end(),
                                      [](double offset) { return offset != 0.0; });
  const bool is_clogged = settings.clog_at_layer > 0 && settings.clog != 0.0;
  const bool is_too_high = settings.pressed && settings.z_error_mm != 0.0;
  return has_offset || is_clogged || is_too_high || settings.gain != 1.0 || settings.wear != 0.0 ||
         settings.end_loss != 0.0 || settings.wave != 0.0 || settings.random != 0.0 ||
         settings.standoff != 0.0 || settings.levelling_mm != 0.0 || settings.dead_time_s != 0.0 ||
         settings.lag_s != 0.0 || settings.thermal != 0.0 || settings.detach_at_layer > 0;
}

GrowthPlant::GrowthPlant(PlantSettings settings) : settings_(std::move(settings)) {}

double correlatedNoise(std::uint64_t seed, double along_mm, double length_mm) {
  const double spacing = 0.5 * length_mm;
  const auto middle = static_cast<long>(std::floor(along_mm / spacing));
  constexpr long kNodes = 8;  // four standard deviations
  double sum = 0.0;
  double squares = 0.0;
  for (long node = middle - kNodes; node <= middle + kNodes + 1; ++node) {
    const double apart = (along_mm - static_cast<double>(node) * spacing) / length_mm;
    const double weight = std::exp(-0.5 * apart * apart);
    sum += weight * Random(mixed(seed, static_cast<std::uint64_t>(node))).normal(0.0, 1.0);
    squares += weight * weight;
  }
  return sum / std::sqrt(squares);
}

double GrowthPlant::nozzleAbove() const {
  const std::vector<double>& offset = settings_.nozzle_offset_mm;
  return settings_.z_error_mm + (offset.size() == 3 ? offset[2] : 0.0);
}

double GrowthPlant::randomAt(const PlantBead& bead, double along_mm) const {
  if (settings_.random == 0.0) return 0.0;
  const std::uint64_t seed =
      mixed(mixed(static_cast<std::uint64_t>(settings_.seed), bead.layer + 1), bead.path + 1);
  return settings_.random * correlatedNoise(seed, along_mm, settings_.random_mm);
}

double GrowthPlant::gainAt(const PlantBead& bead, double along_mm) const {
  double gain = settings_.gain;
  if (settings_.wear != 0.0)
    gain *= 1.0 - settings_.wear * static_cast<double>(bead.layer) / static_cast<double>(bead.layers);
  const bool is_clogged =
      settings_.clog_at_layer > 0 && bead.layer + 1 >= static_cast<std::size_t>(settings_.clog_at_layer);
  if (is_clogged) gain *= 1.0 - settings_.clog;
  const double to_end = std::min(along_mm, bead.length_mm - along_mm);
  if (settings_.end_loss != 0.0 && !bead.is_closed && to_end < settings_.end_mm)
    gain *= 1.0 - settings_.end_loss * (1.0 - to_end / settings_.end_mm);
  if (settings_.wave != 0.0)
    gain *= 1.0 + settings_.wave * std::sin(2.0 * M_PI * along_mm / settings_.wave_mm);
  return gain;
}

/// Each layer below has left heat of 100 K, of which cooling leaves its share.
double GrowthPlant::settling(const PlantBead& bead) const {
  if (settings_.thermal == 0.0 || bead.layer_s <= 0.0) return 0.0;
  const double left = std::exp(-bead.layer_s / settings_.cooling_s);
  const double layers_below = static_cast<double>(bead.layer);
  const double heat = left * (1.0 - std::pow(left, layers_below)) / (1.0 - left);
  return settings_.thermal * heat * (1.0 - std::exp(-bead.layer_s / settings_.slump_s));
}

std::vector<double> GrowthPlant::afterBead(const PlantBead& bead, std::vector<double> heights) const {
  const bool has_offset = settings_.nozzle_offset_mm.size() == 3;
  const double beside = has_offset ? settings_.nozzle_offset_mm[0] : 0.0;
  const double above = nozzleAbove();
  const bool is_detached =
      settings_.detach_at_layer > 0 && bead.layer + 1 == static_cast<std::size_t>(settings_.detach_at_layer);
  const double settled = settling(bead);
  const auto count = static_cast<long>(heights.size());
  const long shift = beside == 0.0 ? 0 : std::lround(beside * static_cast<double>(count) / bead.length_mm);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double along = bead.along_mm[i];
    if (is_detached && std::abs(along - 0.5 * bead.length_mm) < 0.5 * kDetachedLength) heights[i] = 0.0;
    const double planned = bead.planned_mm[i];
    const std::size_t commanded = foldedIndex(static_cast<long>(i) - shift, count, bead.is_closed);
    double growth = planned * (1.0 + bead.correction[commanded]) * gainAt(bead, along);
    const double far = bead.nozzle_far_mm[i] + above;
    if (settings_.standoff != 0.0) growth *= std::max(0.0, 1.0 - settings_.standoff * far / planned);
    if (settings_.random != 0.0) growth += planned * randomAt(bead, along);
    heights[i] += settled == 0.0 ? growth : growth - settled * planned;
  }
  return settings_.levelling_mm > 0.0 ? levelled(heights, bead, settings_.levelling_mm) : heights;
}

std::vector<double> delayed(const TimedValues& commanded, const std::vector<double>& time_s,
                            const PlantSettings& settings) {
  std::vector<double> arrived(time_s.size());
  std::size_t k = 0;
  double follows = 0.0;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double asked_s = time_s[i] - settings.dead_time_s;
    while (k + 1 < commanded.value.size() && commanded.time_s[k + 1] <= asked_s) ++k;
    double value = commanded.value[k];
    if (asked_s > commanded.time_s[k] && k + 1 < commanded.value.size())
      value += (commanded.value[k + 1] - value) * (asked_s - commanded.time_s[k]) /
               (commanded.time_s[k + 1] - commanded.time_s[k]);
    const bool lags = settings.lag_s > 0.0 && i > 0;
    follows =
        lags ? follows + (1.0 - std::exp((time_s[i - 1] - time_s[i]) / settings.lag_s)) * (value - follows)
             : value;
    arrived[i] = follows;
  }
  return arrived;
}

}  // namespace lamina
