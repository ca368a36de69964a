// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/moved_watch.hpp"

#include <algorithm>
#include <cmath>

#include "control/run/layer_ground.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPoints = 32768;
constexpr std::size_t kCoarsePoints = 1024;  // that a search goes through
constexpr std::size_t kFinePoints = 8192;
constexpr std::size_t kTellingPoints = 32;  // contradictions among them by which a search may be given up
constexpr std::size_t kLeastHigh = 64;
// Sideways.
constexpr double kHighLayers = 0.5;   // below the top at most: of what belongs on a bead
constexpr double kLowLayers = 0.75;   // below the top at least: of what belongs beside it
constexpr double kSprayLayers = 2.0;  // above the top
constexpr double kCrown = 0.35;       // of the width, which flanks do not reach
constexpr std::size_t kLeastStray = 12;
constexpr double kStrayShare = 0.005;  // of high points
constexpr std::size_t kLeftOneIn = 4;  // of contradictions that a shift leaves
constexpr std::size_t kHardly = 2;     // contradictions more that may be noise
constexpr std::size_t kHardlyOneIn = 100;
constexpr double kSameSquare = 1e-9;  // mm²
constexpr double kReach = 10.0;       // mm
constexpr double kReachWidths = 10.0;
constexpr int kSteps = 10;  // to either side
constexpr int kFineSteps = 4;
constexpr double kLeastBeside = 0.25;  // mm
constexpr double kBesideWidths = 1.0 / 6.0;
// Along the beam.
constexpr double kGroundLayers = 3.0;  // below the top
constexpr double kSquare = 5.0;        // mm
constexpr std::size_t kInSquare = 3;   // points
constexpr std::size_t kLeastSquares = 8;
constexpr int kStillScans = 2;  // after the first
constexpr double kStillLayers = 0.1;
constexpr double kStillMm = 0.02;
constexpr double kRiseLayers = 0.25;
constexpr double kRiseMm = 0.05;

double leastBeside(const ScannedLayer& layer) {
  return std::max(kLeastBeside, kBesideWidths * layer.width_mm);
}
double leastRise(const ScannedLayer& layer) { return std::max(kRiseMm, kRiseLayers * layer.height_mm); }

/// Points of a scan, on the top of the layer.
class Outline {
 public:
  void add(const Point3& on_top, bool is_high) { (is_high ? high_ : low_).push_back(on_top); }
  std::size_t high() const { return high_.size(); }
  std::size_t size() const { return high_.size() + low_.size(); }

  /// Every n-th of the points, about as many as wanted.
  Outline thinned(std::size_t wanted) const {
    const std::size_t one_in = std::max<std::size_t>(1, size() / wanted);
    Outline thin;
    for (std::size_t i = 0; i < high_.size(); i += one_in) thin.high_.push_back(high_[i]);
    for (std::size_t i = 0; i < low_.size(); i += one_in) thin.low_.push_back(low_[i]);
    return thin;
  }

  /// Of high points those beside the cells, if the sensor shows all of them so far off.
  std::size_t stray(const CellAtlas& atlas, const Eigen::Vector3d& shift) const {
    std::size_t stray = 0;
    for (const auto& sight : atlas.newestAt(moved(high_, shift))) stray += sight ? 0 : 1;
    return stray;
  }
  /// These, and low points on the crowns of cells.
  std::size_t wrong(const CellAtlas& atlas, const Eigen::Vector3d& shift) const {
    std::size_t wrong = stray(atlas, shift);
    for (const auto& sight : atlas.newestAt(moved(low_, shift)))
      wrong += sight && sight->across_share <= kCrown ? 1 : 0;
    return wrong;
  }

 private:
  static std::vector<Point3> moved(std::vector<Point3> points, const Eigen::Vector3d& shift) {
    for (Point3& point : points) point -= shift;
    return points;
  }

  std::vector<Point3> high_;
  std::vector<Point3> low_;
};

/// Searches for the shift that leaves fewest contradictions. What points do not show is as expected.
class ShiftSearch {
 public:
  ShiftSearch(const CellAtlas& atlas, const Eigen::Matrix3d& axes, const Eigen::Vector3d& expected)
      : atlas_(atlas), axes_(axes), expected_(expected) {}

  /// The best of a grid of shifts; of those that are hardly worse, the nearest to what is expected.
  Eigen::Vector3d best(const Outline& outline, const Eigen::Vector3d& middle, double step, int steps) const {
    const std::vector<Eigen::Vector3d> shifts = grid(middle, step, steps);
    std::vector<std::size_t> wrong;
    wrong.reserve(shifts.size());
    for (const Eigen::Vector3d& shift : shifts) wrong.push_back(outline.wrong(atlas_, shift));
    const std::size_t least = *std::min_element(wrong.begin(), wrong.end());
    const std::size_t hardly = least + std::max(kHardly, outline.wrong(atlas_, expected_) / kHardlyOneIn);
    const auto found =
        std::find_if(wrong.begin(), wrong.end(), [hardly](std::size_t each) { return each <= hardly; });
    return shifts[static_cast<std::size_t>(found - wrong.begin())];
  }

 private:
  std::vector<Eigen::Vector3d> grid(const Eigen::Vector3d& middle, double step, int steps) const {
    std::vector<Eigen::Vector3d> shifts;
    const std::size_t side = 2 * static_cast<std::size_t>(steps) + 1;
    shifts.reserve(side * side);
    for (int u = -steps; u <= steps; ++u)
      for (int v = -steps; v <= steps; ++v)
        shifts.emplace_back(middle + step * (u * axes_.row(0) + v * axes_.row(1)).transpose());
    const auto off = [this](const Eigen::Vector3d& shift) { return (shift - expected_).squaredNorm(); };
    std::stable_sort(
        shifts.begin(), shifts.end(),
        [&off](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return off(a) < off(b) - kSameSquare; });
    return shifts;
  }

  const CellAtlas& atlas_;
  const Eigen::Matrix3d& axes_;
  Eigen::Vector3d expected_;
};

std::string hundredths(double value) { return numberText(std::round(100.0 * value) / 100.0); }

std::string reasonOf(const SeenShift& shift, const std::string& sensor) {
  const std::string name = sensor.empty() ? "the sensor" : "sensor '" + sensor + "'";
  const std::string end = "; expected at most " + hundredths(shift.most_mm) +
                          " mm: it has moved on its mount, or its clock: calibrate it";
  if (shift.up_mm != 0.0)
    return name + " shows what nothing was laid on " + hundredths(std::abs(shift.up_mm)) + " mm " +
           (shift.up_mm > 0.0 ? "higher" : "lower") + " than in the scan before" + end;
  const Eigen::Vector3d& beside = shift.beside_mm;
  return name + " shows beads " + hundredths(beside.norm()) + " mm beside their places (x " +
         hundredths(beside.x()) + ", y " + hundredths(beside.y()) + ", z " + hundredths(beside.z()) + ")" +
         end;
}

}  // namespace

ScannedLayer scannedLayer(const LayerCells& cells, const std::vector<double>& errors_mm,
                          const Eigen::Vector3d& normal) {
  if (cells.size() == 0) return {};
  return {cells.layer, cells.middle.front().dot(normal), meanOverCells(cells, errors_mm),
          cells.height_mm.front(), widestBead(cells)};
}

MovedWatch::MovedWatch(const Eigen::Vector3d& normal)
    : normal_(normal), axes_(shortestRotation(normal, Eigen::Vector3d::UnitZ()).matrix()) {}

void MovedWatch::begin() {
  points_.clear();
  one_in_ = 1;
  received_ = 0;
}

void MovedWatch::see(const std::vector<Point3>& points, const Eigen::Isometry3d& toolpath_from_sensor) {
  for (const Point3& point : points) {
    if (received_++ % one_in_ != 0 || !point.allFinite() || point.isZero(0.0)) continue;
    points_.push_back(toolpath_from_sensor * point);
    if (points_.size() < kMostPoints) continue;
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize(points_.size() / 2);
    one_in_ *= 2;
  }
}

std::optional<SeenShift> MovedWatch::shift(const CellAtlas& atlas, const ScannedLayer& layer) {
  SeenShift shift;
  if (const auto up = rise(layer)) {
    shift.up_mm = *up;
    shift.most_mm = leastRise(layer);
    return shift;
  }
  const auto beside_mm = beside(atlas, layer);
  if (!beside_mm) return std::nullopt;
  if (!first_) {
    first_ = *beside_mm;
    return std::nullopt;
  }
  shift.beside_mm = *beside_mm - *first_;
  shift.most_mm = leastBeside(layer);
  return shift.beside_mm.norm() > shift.most_mm ? std::optional<SeenShift>(shift) : std::nullopt;
}

/// By the median of the places that were still.
std::optional<double> MovedWatch::rise(const ScannedLayer& layer) {
  struct Sum {
    double height_mm = 0.0;
    std::size_t points = 0;
  };
  std::map<Square, Sum> sums;
  const double below = layer.top_mm - layer.expected_mm - kGroundLayers * layer.height_mm;
  for (const Point3& point : points_) {
    const Point3 at = axes_ * point;
    if (!(at.z() < below)) continue;
    Sum& sum = sums[{std::lround(at.x() / kSquare), std::lround(at.y() / kSquare)}];
    sum.height_mm += at.z();
    ++sum.points;
  }
  const double still = std::max(kStillMm, kStillLayers * layer.height_mm);
  std::vector<double> rises;
  for (const auto& [square, sum] : sums) {
    if (sum.points < kInSquare) continue;
    const double height_mm = sum.height_mm / static_cast<double>(sum.points);
    const auto [entry, is_new] = ground_.insert({square, {height_mm, 0}});
    Ground& ground = entry->second;
    const double rise = height_mm - ground.height_mm;
    if (ground.still >= kStillScans) rises.push_back(rise);
    ground.height_mm = height_mm;
    ground.still = !is_new && std::abs(rise) <= still ? ground.still + 1 : 0;
  }
  if (rises.size() < kLeastSquares) return std::nullopt;
  const auto middle = rises.begin() + static_cast<std::ptrdiff_t>(rises.size() / 2);
  std::nth_element(rises.begin(), middle, rises.end());
  const double median = *middle;
  const auto alike = std::count_if(rises.begin(), rises.end(),
                                   [&](double rise) { return std::abs(rise - median) <= still; });
  if (5 * static_cast<std::size_t>(alike) < 4 * rises.size()) return std::nullopt;
  return std::abs(median) > leastRise(layer) ? std::optional<double>(median) : std::nullopt;
}

/// None if too little is seen, or no shift explains what contradicts.
std::optional<Eigen::Vector3d> MovedWatch::beside(const CellAtlas& atlas, const ScannedLayer& layer) const {
  Outline outline;
  for (const Point3& point : points_) {
    const double height = point.dot(normal_) - layer.top_mm;
    const double layers = (height + layer.expected_mm) / layer.height_mm;
    const bool is_high = layers > -kHighLayers && layers < kSprayLayers;
    if (is_high || layers < -kLowLayers) outline.add(point - height * normal_, is_high);
  }
  if (outline.high() < kLeastHigh) return std::nullopt;
  const Eigen::Vector3d expected = first_.value_or(Eigen::Vector3d::Zero());
  // Beads are where none was laid: what lies too low alone may have broken off.
  const std::size_t stray = outline.stray(atlas, expected);
  const double most = kStrayShare * static_cast<double>(outline.high());
  if (stray < kLeastStray || static_cast<double>(stray) < most) return expected;
  const ShiftSearch search(atlas, axes_, expected);
  double step = std::min(kReach, kReachWidths * layer.width_mm) / kSteps;
  const Outline coarse = outline.thinned(kCoarsePoints);
  Eigen::Vector3d found = search.best(coarse, expected, step, kSteps);
  const std::size_t before = coarse.wrong(atlas, expected);
  if (before >= kTellingPoints && 2 * coarse.wrong(atlas, found) > before) return std::nullopt;
  const Outline fine = outline.thinned(kFinePoints);
  for (int finer = 0; finer < 2; ++finer) {
    step *= 0.25;
    found = search.best(fine, found, step, kFineSteps);
  }
  const bool explains = kLeftOneIn * outline.stray(atlas, found) <= stray &&
                        kLeftOneIn * outline.wrong(atlas, found) <= outline.wrong(atlas, expected);
  if (!explains) return std::nullopt;
  return found;
}

void MovedWatches::begin() {
  for (auto& [sensor, watch] : watches_) watch.begin();
}

void MovedWatches::see(const std::string& sensor, const std::vector<Point3>& points,
                       const Eigen::Isometry3d& toolpath_from_sensor) {
  watches_.try_emplace(sensor, normal_).first->second.see(points, toolpath_from_sensor);
}

std::string MovedWatches::moved(const CellAtlas& atlas, const ScannedLayer& layer) {
  std::string reason;
  for (auto& [sensor, watch] : watches_) {
    const auto shift = watch.shift(atlas, layer);
    if (shift && reason.empty()) reason = reasonOf(*shift, sensor);
  }
  return reason;
}

}  // namespace lamina
