// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_groups.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr int kGroupWord = VoxelGrid::kWord;

/// All bits of word `w` that lie within the frame.
std::uint64_t bitsOfFrame(const VoxelFrame& frame, int w) {
  const int count = std::min(kGroupWord, frame.count[0] - w * kGroupWord);
  return count == kGroupWord ? ~std::uint64_t{0} : (std::uint64_t{1} << static_cast<unsigned>(count)) - 1;
}

/// Appends the runs of a row.
void appendRuns(const VoxelGrid& pores, int j, int k, std::vector<PoreRun>& runs) {
  int low = -1;  // of a run that reaches the end of the word before
  for (int w = 0; w < pores.wordCount(); ++w) {
    std::uint64_t bits = pores.word(w, j, k);
    int at = 0;
    while (at < kGroupWord) {
      const std::uint64_t rest = (low < 0 ? bits : ~bits) >> static_cast<unsigned>(at);
      if (rest == 0) break;
      at += __builtin_ctzll(rest);
      if (low < 0) {
        low = w * kGroupWord + at;
      } else {
        runs.push_back({low, w * kGroupWord + at, j, k, 0});
        low = -1;
      }
    }
  }
  if (low >= 0) runs.push_back({low, pores.frame().count[0], j, k, 0});
}

/// Where the runs of each row begin.
using RowStarts = std::vector<std::uint32_t>;

/// Sets of runs; the root of each is its first run.
class RunSets {
 public:
  explicit RunSets(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }
  std::uint32_t rootOf(std::uint32_t run) {
    while (parent_[run] != run) {
      parent_[run] = parent_[parent_[run]];
      run = parent_[run];
    }
    return run;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Runs of all rows, and which of them touch.
class Labelling {
 public:
  Labelling(const VoxelGrid& pores, Progress& progress) : pores_(pores), progress_(progress) {}

  PoreGroups run() {
    collect();
    RunSets sets(runs_.size());
    uniteWithinSlices(sets);
    for (int k = 1; k < count_[2]; ++k)
      for (int j = 0; j < count_[1]; ++j) uniteRows(sets, row(j, k - 1), row(j, k));
    PoreGroups found{pores_.frame(), std::move(runs_), {}};
    number(sets, found);
    return found;
  }

 private:
  std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j);
  }

  void collect() {
    std::vector<std::vector<PoreRun>> slices(static_cast<std::size_t>(count_[2]));
    const auto collectSlice = [&](std::size_t k) {
      for (int j = 0; j < count_[1]; ++j) appendRuns(pores_, j, static_cast<int>(k), slices[k]);
    };
    parallelFor(slices.size(), collectSlice, progress_, "pores");
    std::size_t total = 0;
    for (const auto& slice : slices) total += slice.size();
    if (total >= std::numeric_limits<std::uint32_t>::max())
      throw InvalidInput("the grid has " + std::to_string(total) + " runs of pores; must be below 2^32");
    runs_.reserve(total);
    for (const auto& slice : slices) runs_.insert(runs_.end(), slice.begin(), slice.end());
    starts_.assign(row(0, count_[2]) + 1, 0);
    for (const PoreRun& run : runs_) ++starts_[row(run.j, run.k) + 1];
    for (std::size_t r = 1; r < starts_.size(); ++r) starts_[r] += starts_[r - 1];
  }

  /// Runs of different slices are in different sets so far.
  void uniteWithinSlices(RunSets& sets) {
    const auto uniteSlice = [&](std::size_t k) {
      for (int j = 1; j < count_[1]; ++j)
        uniteRows(sets, row(j - 1, static_cast<int>(k)), row(j, static_cast<int>(k)));
    };
    parallelFor(static_cast<std::size_t>(count_[2]), uniteSlice, progress_, "pores");
  }

  void uniteRows(RunSets& sets, std::size_t one, std::size_t other) {
    std::uint32_t a = starts_[one];
    std::uint32_t b = starts_[other];
    while (a < starts_[one + 1] && b < starts_[other + 1]) {
      if (runs_[a].low < runs_[b].high && runs_[b].low < runs_[a].high) sets.unite(a, b);
      runs_[a].high < runs_[b].high ? ++a : ++b;
    }
  }

  static void number(RunSets& sets, PoreGroups& found) {
    std::uint32_t groups = 0;
    for (std::uint32_t r = 0; r < found.runs.size(); ++r) {
      const std::uint32_t root = sets.rootOf(r);
      found.runs[r].group = root == r ? groups++ : found.runs[root].group;
    }
    found.groups.resize(groups);
  }

  const VoxelGrid& pores_;
  Progress& progress_;
  const std::array<int, 3> count_ = pores_.frame().count;
  std::vector<PoreRun> runs_;
  RowStarts starts_;
};

/// Sums over the voxels of a group, about its first voxel.
struct Moments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const PoreRun& run) {
    const double n = run.high - run.low;
    const Eigen::Vector3d middle = Eigen::Vector3d(0.5 * (run.low + run.high - 1), run.j, run.k) - origin;
    first += n * middle;
    second += n * middle * middle.transpose();
    second(0, 0) += n * (n * n - 1.0) / 12.0;
  }
  Eigen::Matrix3d covariance(double n) const {
    const Eigen::Vector3d mean = first / n;
    return second / n - mean * mean.transpose() + Eigen::Matrix3d::Identity() / 12.0;
  }
};

unsigned facesOf(const PoreRun& run, const std::array<int, 3>& count) {
  unsigned faces = 0;
  const std::array<int, 3> low{run.low, run.j, run.k};
  const std::array<int, 3> high{run.high, run.j + 1, run.k + 1};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (low[a] == 0) faces |= faceBit(axis, AxisEnd::Low);
    if (high[a] == count[a]) faces |= faceBit(axis, AxisEnd::High);
  }
  return faces;
}

void measure(PoreGroups& found) {
  std::vector<Moments> moments(found.groups.size());
  for (const PoreRun& run : found.runs) {
    PoreGroup& group = found.groups[run.group];
    if (group.voxels == 0) moments[run.group].origin = Eigen::Vector3d(run.low, run.j, run.k);
    group.voxels += run.high - run.low;
    group.faces |= facesOf(run, found.frame.count);
    moments[run.group].add(run);
  }
  for (std::size_t g = 0; g < moments.size(); ++g) {
    PoreGroup& group = found.groups[g];
    const Eigen::Matrix3d covariance = moments[g].covariance(static_cast<double>(group.voxels));
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues();
    for (std::size_t axis = 0; axis < 3; ++axis)
      group.axes[axis] = 2.0 * std::sqrt(5.0 * variances[static_cast<Eigen::Index>(2 - axis)]);
  }
}

}  // namespace

bool PoreGroup::joinsAlong(int axis) const {
  const unsigned both = faceBit(axis, AxisEnd::Low) | faceBit(axis, AxisEnd::High);
  return (faces & both) == both;
}

bool PoreGroup::joinsOpposite() const { return joinsAlong(0) || joinsAlong(1) || joinsAlong(2); }

bool PoreGroup::joinsTwoFaces() const { return (faces & (faces - 1)) != 0; }

double PoreGroup::equivalentDiameter() const { return std::cbrt(6.0 * static_cast<double>(voxels) / M_PI); }

PoreGroups labelPores(const VoxelGrid& pores, Progress& progress) {
  PoreGroups found = Labelling(pores, progress).run();
  measure(found);
  return found;
}

VoxelGrid voxelsOf(const PoreGroups& pores, const std::function<bool(const PoreGroup&)>& is_chosen) {
  VoxelGrid grid(pores.frame);
  for (const PoreRun& run : pores.runs) {
    if (!is_chosen(pores.groups[run.group])) continue;
    for (int w = run.low / kGroupWord; w * kGroupWord < run.high; ++w) {
      const int low = std::max(run.low - w * kGroupWord, 0);
      const int high = std::min(run.high - w * kGroupWord, kGroupWord);
      const std::uint64_t to_high = high == kGroupWord ? ~std::uint64_t{0} : (std::uint64_t{1} << high) - 1;
      grid.fillWord(w, run.j, run.k, to_high & ~((std::uint64_t{1} << low) - 1));
    }
  }
  return grid;
}

VoxelGrid inverted(const VoxelGrid& grid) {
  VoxelGrid made(grid.frame());
  for (int k = 0; k < grid.frame().count[2]; ++k)
    for (int j = 0; j < grid.frame().count[1]; ++j)
      for (int w = 0; w < grid.wordCount(); ++w)
        made.fillWord(w, j, k, ~grid.word(w, j, k) & bitsOfFrame(grid.frame(), w));
  return made;
}

}  // namespace lamina
