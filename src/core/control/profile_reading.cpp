// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/profile_reading.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "control/profile_points.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kSureSquared = 1.0;     // one standard deviation: nothing else is asked
constexpr double kGateSquared = 16.0;    // four standard deviations
constexpr double kUnitsPerMm = 1 << 30;  // sums of whole units do not depend on the order of points

/// Points in a row on the crown of one cell.
struct CrownRun {
  std::size_t layer = 0;
  std::size_t cell = 0;
  std::int64_t units = 0;
  int points = 0;
};

bool isBefore(const CrownRun& a, const CrownRun& b) {
  return std::tie(a.layer, a.cell) < std::tie(b.layer, b.cell);
}

/// A cell that a point is taken to lie on.
struct TakenSight {
  CellSight sight;
  double surprise = 0.0;  ///< squared deviation over what is expected of it
};

class ProfileReader {
 public:
  ProfileReader(const SensorProfile& profile, const CellAtlas& atlas,
                const std::vector<LayerPrediction>& predictions, const SightSettings& settings)
      : atlas_(atlas),
        settings_(settings),
        pose_(profile.toolpath_from_sensor),
        to_sensor_(-pose_.linear().col(2)),
        stamp_sigma_(profile.stamp_sigma_mm) {
    for (const std::size_t layer : atlas.layers()) {
      sheets_.push_back({atlas.cellsOf(layer), atlas.isPlane(layer), nullptr});
      Sheet& sheet = sheets_.back();
      if (sheet.is_plane && sheet.cells->size() > 0) sheet.cosine = sheet.cells->growth[0].dot(to_sensor_);
      for (const LayerPrediction& prediction : predictions)
        if (prediction.layer == layer && prediction.estimates &&
            prediction.estimates->size() == sheets_.back().cells->size())
          sheets_.back().estimates = prediction.estimates;
    }
    least_cosine_ = std::cos(std::min(settings.greatest_angle_deg, 89.9) * kDegree);
  }

  double layerHeight() const {
    if (sheets_.empty() || sheets_.back().cells->size() == 0) return 0.0;
    return sheets_.back().cells->height_mm.front();
  }

  void read(const SoundPoints& sound) {
    std::vector<Point3> points;
    points.reserve(sound.points.size());
    for (const Point3& point : sound.points) points.push_back(pose_ * point);
    const std::vector<std::optional<CellSight>> newest = atlas_.newestAt(points);
    for (const auto& sight : newest)
      if (sight) fetchEstimate(*sight);
    for (std::size_t i = 0; i + 1 < sound.columns.size(); ++i)
      readColumn(points, newest, sound.columns[i], sound.columns[i + 1]);
  }

  std::vector<LayerReading> readings() {
    if (!std::is_sorted(runs_.begin(), runs_.end(), isBefore))
      std::stable_sort(runs_.begin(), runs_.end(), isBefore);
    std::vector<LayerReading> readings;
    readings.reserve(runs_.size());
    for (std::size_t i = 0; i < runs_.size();) {
      CrownRun sum = runs_[i];
      for (++i; i < runs_.size() && !isBefore(sum, runs_[i]); ++i) {
        sum.units += runs_[i].units;
        sum.points += runs_[i].points;
      }
      const double error = static_cast<double>(sum.units) / (kUnitsPerMm * static_cast<double>(sum.points));
      readings.push_back({sum.layer, sum.cell, {error, sum.points, sigmaOf(sum)}});
    }
    return readings;
  }

  PointCounts counts;

 private:
  /// The returns along one ray: at most one of them counts.
  void readColumn(const std::vector<Point3>& points, const std::vector<std::optional<CellSight>>& newest,
                  std::size_t first, std::size_t last) {
    if (last - first == 1) {
      if (const auto taken = take(points[first], newest[first])) add(taken->sight);
      return;
    }
    std::optional<TakenSight> best;
    for (std::size_t i = first; i != last; ++i) {
      const auto taken = take(points[i], newest[i]);
      if (!taken) continue;
      if (best) ++counts.mirrored;
      if (!best || isBetter(*taken, *best)) best = taken;
    }
    if (best) add(best->sight);
  }

  struct Sheet {
    std::shared_ptr<const LayerCells> cells;
    bool is_plane;
    const std::vector<CellEstimate>* estimates;
    double cosine = 0.0;    ///< of beam and growth, of a plane layer
    double sigma_mm = 0.0;  ///< of its points; 0 until it is asked for
  };

  const Sheet& sheetOf(std::size_t layer) const {
    auto sheet = sheets_.rbegin();
    while (sheet->cells->layer != layer) ++sheet;
    return *sheet;
  }

  double sigmaOf(const Eigen::Vector3d& growth) const {
    Eigen::Vector3d seen = pose_.linear().transpose() * growth;
    seen.z() = std::min(-least_cosine_, seen.z());
    const double sigma = pointSigma(seen, settings_);
    return stamp_sigma_.isZero(0.0) ? sigma : std::hypot(sigma, growth.dot(stamp_sigma_));
  }

  double sigmaOf(const CrownRun& run) {
    Sheet& sheet = sheets_[static_cast<std::size_t>(&sheetOf(run.layer) - sheets_.data())];
    if (!sheet.is_plane) return sigmaOf(sheet.cells->growth[run.cell]);
    if (sheet.sigma_mm == 0.0) sheet.sigma_mm = sigmaOf(sheet.cells->growth[0]);
    return sheet.sigma_mm;
  }

  /// Of cells that lie far apart in memory, ahead of when it is asked for.
  void fetchEstimate(const CellSight& sight) const {
    if (sight.across_share > 0.5 * settings_.crown_share) return;
    const Sheet& sheet = sheetOf(sight.layer);
    if (sheet.estimates) __builtin_prefetch(sheet.estimates->data() + sight.cell);
  }

  TakenSight weighed(const CellSight& sight) const {
    const Sheet& sheet = sheetOf(sight.layer);
    double expected = 0.0;
    double variance = CellEstimate::kStartSigma * CellEstimate::kStartSigma;
    if (sheet.estimates) {
      expected = (*sheet.estimates)[sight.cell].error();
      variance = (*sheet.estimates)[sight.cell].variance();
    }
    const double off = sight.error_mm - expected;
    return {sight, off * off / (variance + settings_.sigma_mm * settings_.sigma_mm)};
  }

  /// The cell whose crown the point lies on; none, and counted, where it does not.
  std::optional<TakenSight> take(const Point3& point, const std::optional<CellSight>& newest) {
    if (!newest) {
      ++counts.off_path;
      return std::nullopt;
    }
    if (!isSeen(*newest)) return std::nullopt;
    const TakenSight taken = weighed(*newest);
    if (taken.surprise <= kSureSquared || sheets_.size() == 1) return taken;
    const auto below = atlas_.belowAt(point, newest->layer);
    if (!below) return taken;
    const TakenSight other = weighed(*below);
    if (!(other.surprise < taken.surprise && other.surprise <= kGateSquared)) return taken;
    return isSeen(*below) ? std::optional<TakenSight>(other) : std::nullopt;
  }

  /// Whether the point lies where its cell should be level and is seen well; counted where not.
  bool isSeen(const CellSight& sight) {
    const Sheet& sheet = sheetOf(sight.layer);
    const double cosine = sheet.is_plane ? sheet.cosine : sheet.cells->growth[sight.cell].dot(to_sensor_);
    if (cosine < least_cosine_) {
      ++counts.grazing;
      return false;
    }
    const bool is_beside = sight.across_share > 0.5 * settings_.crown_share;
    if (is_beside) ++counts.beside_crown;
    return !is_beside;
  }

  static bool isBetter(const TakenSight& a, const TakenSight& b) {
    return std::make_tuple(a.surprise, a.sight.error_mm, a.sight.layer, a.sight.cell) <
           std::make_tuple(b.surprise, b.sight.error_mm, b.sight.layer, b.sight.cell);
  }

  void add(const CellSight& sight) {
    ++counts.used;
    if (runs_.empty() || runs_.back().cell != sight.cell || runs_.back().layer != sight.layer)
      runs_.push_back({sight.layer, sight.cell, 0, 0});
    runs_.back().units += static_cast<std::int64_t>(std::floor(sight.error_mm * kUnitsPerMm + 0.5));
    ++runs_.back().points;
  }

  const CellAtlas& atlas_;
  const SightSettings& settings_;
  Eigen::Isometry3d pose_;
  Eigen::Vector3d to_sensor_;
  Eigen::Vector3d stamp_sigma_;
  std::vector<Sheet> sheets_;  ///< ascending by layer
  double least_cosine_ = 0.0;
  std::vector<CrownRun> runs_;
};

}  // namespace

std::uint64_t PointCounts::accounted() const {
  return used + trimmed + not_finite + outside_window + spray + off_path + grazing + beside_crown + mirrored;
}

PointCounts& PointCounts::operator+=(const PointCounts& other) {
  received += other.received;
  used += other.used;
  trimmed += other.trimmed;
  not_finite += other.not_finite;
  outside_window += other.outside_window;
  spray += other.spray;
  off_path += other.off_path;
  grazing += other.grazing;
  beside_crown += other.beside_crown;
  mirrored += other.mirrored;
  return *this;
}

double pointSigma(const Eigen::Vector3d& growth, const SightSettings& settings) {
  return std::hypot(settings.sigma_mm * growth.z(), settings.lateral_sigma_mm * growth.x(),
                    settings.pose_sigma_mm);
}

ProfileReadings readProfile(const SensorProfile& profile, const CellAtlas& atlas,
                            const std::vector<LayerPrediction>& predictions, const SightSettings& settings) {
  ProfileReader reader(profile, atlas, predictions, settings);
  const SoundPoints sound = soundPoints(profile.points, reader.layerHeight(), settings);
  reader.counts = sound.counts;
  reader.read(sound);
  ProfileReadings result;
  result.readings = reader.readings();
  result.counts = reader.counts;
  return result;
}

void describe(SettingsSchema& schema, SightSettings& settings) {
  schema.number("sight.window_layers", settings.window_layers, Bounds::above(0.0, 10.0),
                "Reach of a cell along its growth, in layer heights.");
  schema.number("sight.crown_share", settings.crown_share, Bounds::above(0.0, 1.0),
                "Part of a bead's width, around its middle, that is measured.");
  schema.number("sight.sigma_mm", settings.sigma_mm, Bounds::above(0.0, 10.0),
                "Standard deviation of a point along the beam.");
  schema.number("sight.lateral_sigma_mm", settings.lateral_sigma_mm, {0.0, 10.0},
                "Standard deviation of a point along the line of light.");
  schema.number("sight.pose_sigma_mm", settings.pose_sigma_mm, {0.0, 10.0},
                "Standard deviation of the sensor's place.");
  schema.number("sight.greatest_angle_deg", settings.greatest_angle_deg, Bounds::above(0.0, 90.0),
                "Greatest angle between beam and growth at which a cell is measured.");
  schema.number("sight.least_depth_mm", settings.least_depth_mm, {0.0, 1e5},
                "Least depth of the sensor's window.");
  schema.number("sight.greatest_depth_mm", settings.greatest_depth_mm, {0.0, 1e5},
                "Greatest depth of the sensor's window; 0 for no far end.");
  schema.integer("sight.trim_points", settings.trim_points, {0, 1e6},
                 "Points left out at both ends of a profile.");
}

}  // namespace lamina
