// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/path_low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kCutOff = 4.0;       // standard deviations
constexpr double kBeadReach = 1.25;   // bead widths: rasters lie at most one apart
constexpr double kFoldedReach = 2.0;  // bead widths of the same path that are no neighbour

/// A station continued beyond the ends of its path.
struct Image {
  double along;
  double span;  ///< length it stands for
  double value;
};

void requireAscending(const std::vector<double>& values, const Stations& stations) {
  const std::vector<double>& along = stations.along_mm;
  if (along.size() != values.size())
    throw InvalidInput("a low-pass has " + std::to_string(values.size()) + " values at " +
                       std::to_string(along.size()) + " stations; expected as many");
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double least = i == 0 ? 0.0 : along[i - 1];
    const bool is_placed =
        along[i] >= least && along[i] <= stations.length_mm && (i == 0 || along[i] > least);
    if (!is_placed)
      throw InvalidInput("station " + std::to_string(i) + " lies at " + std::to_string(along[i]) +
                         " mm; expected stations to ascend from 0 to " + std::to_string(stations.length_mm) +
                         " mm");
  }
}

/// Length that each station stands for: half the way to its neighbours, all of it at a reflecting end.
std::vector<double> spansOf(const Stations& stations) {
  const std::vector<double>& at = stations.along_mm;
  const std::size_t count = at.size();
  const bool joins = stations.ends == PathEnds::Joined;
  std::vector<double> spans(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double seam = 0.5 * (at.front() + stations.length_mm - at.back());
    const double before = i > 0 ? 0.5 * (at[i] - at[i - 1]) : (joins ? seam : at[i]);
    const double after =
        i + 1 < count ? 0.5 * (at[i + 1] - at[i]) : (joins ? seam : stations.length_mm - at[i]);
    spans[i] = before + after;
  }
  return spans;
}

std::vector<Image> imagesOf(const std::vector<double>& values, const Stations& stations, double reach) {
  const std::vector<double> spans = spansOf(stations);
  const auto blocks = static_cast<long>(std::ceil(reach / stations.length_mm));
  const std::size_t count = values.size();
  std::vector<Image> images;
  images.reserve(count * static_cast<std::size_t>(2 * blocks + 1));
  for (long block = -blocks; block <= blocks; ++block) {
    const bool is_mirrored = stations.ends == PathEnds::Reflected && block % 2 != 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = is_mirrored ? count - 1 - k : k;
      const double within = is_mirrored ? stations.length_mm - stations.along_mm[i] : stations.along_mm[i];
      const double along = static_cast<double>(block) * stations.length_mm + within;
      if (along < -reach || along > stations.length_mm + reach) continue;
      images.push_back({along, spans[i], values[i]});
    }
  }
  return images;
}

/// Bead widths and cells as a grid in the plane in which the layer is widest.
class NeighbourGrid {
 public:
  NeighbourGrid(const LayerCells& cells, double widest) : cells_(cells), grid_(boxOf(cells), widest) {
    for (const Point3& middle : cells.middle) grid_.insert(middle.head<2>());
    run_of_.resize(cells.size());
    for (std::size_t r = 0; r < cells.runs.size(); ++r)
      std::fill_n(run_of_.begin() + static_cast<std::ptrdiff_t>(cells.runs[r].first), cells.runs[r].count, r);
  }

  /// Calls visit(cell, squared distance) for cells within reach, the cell itself included; returns
  /// whether one of them is of another bead.
  template <class Visit>
  bool visitWithinBead(std::size_t cell, Visit visit) const {
    const double reach = kBeadReach * cells_.width_mm[cell];
    bool has_neighbour = false;
    grid_.visitNear(cells_.middle[cell].head<2>(), reach, [&](std::uint32_t other, double) {
      const double squared = (cells_.middle[other] - cells_.middle[cell]).squaredNorm();
      if (squared > reach * reach) return;
      has_neighbour |= isOfOtherBead(cell, other);
      visit(other, squared);
    });
    return has_neighbour;
  }

 private:
  static Box2 boxOf(const LayerCells& cells) {
    Box2 box;
    for (const Point3& middle : cells.middle) box.include(Point2(middle.head<2>()));
    return box;
  }
  bool isOfOtherBead(std::size_t cell, std::size_t other) const {
    if (run_of_[cell] != run_of_[other]) return true;
    const CellRun& run = cells_.runs[run_of_[cell]];
    double apart = std::abs(cells_.along_mm[cell] - cells_.along_mm[other]);
    if (run.is_closed) apart = std::min(apart, run.length_mm - apart);
    return apart > kFoldedReach * cells_.width_mm[cell];
  }

  const LayerCells& cells_;
  PointGrid grid_;
  std::vector<std::size_t> run_of_;
};

std::vector<double> lowPassedAcross(const std::vector<double>& along, const LayerCells& cells, double sigma) {
  const double widest = *std::max_element(cells.width_mm.begin(), cells.width_mm.end());
  if (!(widest > 0.0)) return along;
  const NeighbourGrid grid(cells, widest);
  std::vector<double> across = along;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double sum = 0.0;
    double weights = 0.0;
    const bool has_neighbour = grid.visitWithinBead(i, [&](std::size_t other, double squared) {
      const double weight = std::exp(-0.5 * squared / (sigma * sigma));
      sum += weight * along[other];
      weights += weight;
    });
    if (has_neighbour) across[i] = sum / weights;
  }
  return across;
}

}  // namespace

std::vector<double> lowPassed(const std::vector<double>& values, const Stations& stations, double sigma_mm) {
  requireAscending(values, stations);
  if (!(sigma_mm > 0.0) || values.empty() || !(stations.length_mm > 0.0)) return values;
  const double reach = kCutOff * sigma_mm;
  const std::vector<Image> images = imagesOf(values, stations, reach);
  const double factor = -0.5 / (sigma_mm * sigma_mm);
  std::vector<double> smooth(values.size());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double here = stations.along_mm[i];
    while (begin < images.size() && images[begin].along < here - reach) ++begin;
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t k = begin; k < images.size() && images[k].along <= here + reach; ++k) {
      const double apart = images[k].along - here;
      const double weight = images[k].span * std::exp(factor * apart * apart);
      sum += weight * (images[k].value - values[i]);
      weights += weight;
    }
    smooth[i] = weights > 0.0 ? values[i] + sum / weights : values[i];
  }
  return smooth;
}

Stations stationsOf(const LayerCells& cells, const CellRun& run) {
  const auto first = cells.along_mm.begin() + static_cast<std::ptrdiff_t>(run.first);
  return {{first, first + static_cast<std::ptrdiff_t>(run.count)},
          run.length_mm,
          run.is_closed ? PathEnds::Joined : PathEnds::Reflected};
}

std::vector<double> lowPassed(const std::vector<double>& values, const LayerCells& cells, double sigma_mm) {
  if (!(sigma_mm > 0.0) || cells.size() == 0) return values;
  std::vector<double> along(values.size());
  for (const CellRun& run : cells.runs) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(run.first);
    const std::vector<double> of_run(first, first + static_cast<std::ptrdiff_t>(run.count));
    const std::vector<double> smooth = lowPassed(of_run, stationsOf(cells, run), sigma_mm);
    std::copy(smooth.begin(), smooth.end(), along.begin() + static_cast<std::ptrdiff_t>(run.first));
  }
  return lowPassedAcross(along, cells, sigma_mm);
}

}  // namespace lamina
