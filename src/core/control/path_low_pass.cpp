// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/path_low_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kCutOff = 4.0;      // standard deviations
constexpr double kFlat = 4.0;        // a Gaussian so many times as wide as a path leaves its mean alone
constexpr double kSamePlace = 1e-6;  // of a piece of the path
constexpr std::size_t kBlock = 16;   // stations at a time

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
      throw InvalidInput("station " + std::to_string(i) + " lies at " + numberText(along[i]) +
                         " mm; expected stations to ascend from 0 to " + numberText(stations.length_mm) +
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

/// Whether stations stand in the middles of equal pieces of their path.
bool areEqual(const Stations& stations) {
  const std::size_t count = stations.along_mm.size();
  const double each = stations.length_mm / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i)
    if (std::abs(stations.along_mm[i] - (static_cast<double>(i) + 0.5) * each) > kSamePlace * each)
      return false;
  return true;
}

/// A path in equal pieces, one value each.
struct EqualPieces {
  const double* values;
  std::size_t count;
  double each_mm;
  PathEnds ends;

  double length() const { return static_cast<double>(count) * each_mm; }  ///< [mm]
};

/// Values of a path, continued beyond its ends by so many.
std::vector<double> continued(const EqualPieces& pieces, std::size_t beyond) {
  const auto& [values, count, each_mm, ends] = pieces;
  std::vector<double> all(count + 2 * beyond);
  std::copy(values, values + count, all.begin() + static_cast<std::ptrdiff_t>(beyond));
  const std::size_t period = ends == PathEnds::Joined ? count : 2 * count;
  for (std::size_t k = 1; k <= beyond; ++k) {
    const std::size_t after = (k - 1 + count) % period;
    const std::size_t before = (period - k % period) % period;
    all[beyond + count + k - 1] = values[after < count ? after : period - 1 - after];
    all[beyond - k] = values[before < count ? before : period - 1 - before];
  }
  return all;
}

double meanOf(const EqualPieces& pieces) {
  double sum = 0.0;  // of differences, so that a constant stays as it is to the last bit
  for (std::size_t i = 0; i < pieces.count; ++i) sum += pieces.values[i] - pieces.values[0];
  return pieces.values[0] + sum / static_cast<double>(pieces.count);
}

/// The low-pass over equal pieces: one kernel for all of them.
void smoothEqual(const EqualPieces& pieces, double sigma_mm, double* smooth) {
  const std::size_t count = pieces.count;
  if (sigma_mm > kFlat * pieces.length()) {
    std::fill_n(smooth, count, meanOf(pieces));
    return;
  }
  const auto taps = static_cast<std::size_t>(kCutOff * sigma_mm / pieces.each_mm);
  std::vector<double> kernel(taps);
  double weights = 1.0;
  for (std::size_t k = 0; k < taps; ++k) {
    const double apart = static_cast<double>(k + 1) * pieces.each_mm / sigma_mm;
    kernel[k] = std::exp(-0.5 * apart * apart);
    weights += 2.0 * kernel[k];
  }
  std::vector<double> all = continued(pieces, taps);
  all.resize(all.size() + kBlock);  // blocks are whole
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const double* here = all.data() + taps + begin;
    // Summed are differences, so that a constant stays as it is to the last bit.
    double twice[kBlock];
    double sum[kBlock] = {};
    for (std::size_t j = 0; j < kBlock; ++j) twice[j] = 2.0 * here[j];
    for (std::size_t k = 0; k < taps; ++k) {
      const double* after = here + k + 1;
      const double* before = here - k - 1;
      for (std::size_t j = 0; j < kBlock; ++j) sum[j] += kernel[k] * (after[j] + before[j] - twice[j]);
    }
    const std::size_t end = std::min(kBlock, count - begin);
    for (std::size_t j = 0; j < end; ++j) smooth[begin + j] = here[j] + sum[j] / weights;
  }
}

/// A Gaussian of distances up to a greatest one, from a table.
class WeightByDistance {
 public:
  WeightByDistance(double sigma_mm, double greatest_mm) : per_mm_(kTableSteps / greatest_mm) {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const double apart = static_cast<double>(i) / (per_mm_ * sigma_mm);
      table_[i] = std::exp(-0.5 * apart * apart);
    }
  }
  double at(float distance_mm) const {
    const double place = static_cast<double>(distance_mm) * per_mm_;
    const std::size_t i = std::min(static_cast<std::size_t>(place), std::size_t{kTableSteps} - 1);
    return table_[i] + (place - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
  }

 private:
  static constexpr int kTableSteps = 4096;
  double per_mm_;
  std::array<double, kTableSteps + 1> table_{};
};

std::vector<double> lowPassedAcross(const std::vector<double>& along, const LayerCells& cells, double sigma) {
  float greatest = 0.0F;
  for (const CellsBeside& beside : cells.beside) {
    if (beside.left != CellsBeside::kNone) greatest = std::max(greatest, beside.left_mm);
    if (beside.right != CellsBeside::kNone) greatest = std::max(greatest, beside.right_mm);
  }
  if (!(greatest > 0.0F)) return along;
  const WeightByDistance weight(sigma, static_cast<double>(greatest));
  std::vector<double> across = along;
  for (std::size_t i = 0; i < cells.beside.size(); ++i) {
    const CellsBeside& beside = cells.beside[i];
    double sum = 0.0;
    double weights = 1.0;
    const auto count = [&](std::uint32_t other, float distance) {
      if (other == CellsBeside::kNone) return;
      const double share = weight.at(distance);
      sum += share * (along[other] - along[i]);
      weights += share;
    };
    count(beside.left, beside.left_mm);
    count(beside.right, beside.right_mm);
    across[i] += sum / weights;
  }
  return across;
}

}  // namespace

std::vector<double> lowPassed(const std::vector<double>& values, const Stations& stations, double sigma_mm) {
  requireAscending(values, stations);
  if (!(sigma_mm > 0.0) || values.empty() || !(stations.length_mm > 0.0)) return values;
  if (areEqual(stations)) {
    std::vector<double> smooth(values.size());
    const double each_mm = stations.length_mm / static_cast<double>(values.size());
    smoothEqual({values.data(), values.size(), each_mm, stations.ends}, sigma_mm, smooth.data());
    return smooth;
  }
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
  for (const CellRun& run : cells.runs)
    smoothEqual({values.data() + run.first, run.count, run.cellLength(),
                 run.is_closed ? PathEnds::Joined : PathEnds::Reflected},
                sigma_mm, along.data() + run.first);
  return lowPassedAcross(along, cells, sigma_mm);
}

}  // namespace lamina
