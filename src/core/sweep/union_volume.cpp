// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/sweep/solid_union.hpp"

namespace lamina {
namespace {

constexpr int kTurns = 60;              // tried, all round a half turn
constexpr double kLinesPerBead = 20.0;  // across the smallest bead
constexpr double kSlabsPerBead = 16.0;  // where tops and bottoms lie close
// Gauss-Legendre, 8 points on [-1, 1]: the upper half.
constexpr double kNodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
constexpr double kWeights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                               0.1012285362903763};

/// By how much the lines along x may miss the area of a solid turned like this, in spacings of the lines
/// squared: of a side along which the length inside changes by the cotangent of its slope from line to line
/// about that, but a line more or less at most. Its sides are as long as it is, its ends about as high.
double missedBy(const Point2& length, const Point2& turn, double pitch_mm) {
  const double along = std::abs(length.dot(turn)),
               across = std::abs(length.x() * turn.y() - length.y() * turn.x());
  return std::min(length.norm() / pitch_mm, along / across) + std::min(kLinesPerBead, across / along);
}

/// The turn about z after which the lines, along x, run least along the sides and ends of solids.
double turnOf(const std::vector<BeadSolid>& solids, double pitch_mm) {
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTurns; ++i) {
    const double angle = M_PI * i / kTurns;
    const Point2 turn(std::cos(angle), -std::sin(angle));
    double missed = 0.0;
    for (const BeadSolid& solid : solids) {
      const Point2 length = solid.length().head<2>();
      if (!length.isZero()) missed += missedBy(length, turn, pitch_mm);
    }
    if (missed >= least) continue;
    least = missed;
    best = angle;
  }
  return best;
}

double thinnestOf(const std::vector<BeadSolid>& solids) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const BeadSolid& solid : solids) thinnest = std::min(thinnest, solid.box().size().z());
  return thinnest;
}

/// Solids by their height, to find those at a level.
class HeightOrder {
 public:
  HeightOrder(const std::vector<BeadSolid>& solids, double thinnest) : thinnest_(thinnest) {
    const double turn = turnOf(solids, thinnest / kLinesPerBead);
    for (const BeadSolid& solid : solids) {
      const BeadSolid turned = solid.turned(turn);
      entries_.push_back({turned, turned.box()});
      thickest_ = std::max(thickest_, entries_.back().box.size().z());
    }
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.box.low.z() < b.box.low.z(); });
  }

  /// Bottoms and tops, rising, nearer ones taken as one.
  std::vector<double> levels() const {
    std::vector<double> all;
    for (const Entry& entry : entries_) {
      all.push_back(entry.box.low.z());
      all.push_back(entry.box.high.z());
    }
    std::sort(all.begin(), all.end());
    std::vector<double> kept;
    for (const double z : all)
      if (kept.empty() || z - kept.back() > thinnest_ / kSlabsPerBead) kept.push_back(z);
    if (!kept.empty()) kept.back() = std::max(kept.back(), all.back());
    return kept;
  }

  template <class Visit>
  void visitAt(double z, const Visit& visit) const {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), z - thickest_ - 1e-9,
                                  [](const Entry& e, double low) { return e.box.low.z() < low; });
    for (; entry != entries_.end() && entry->box.low.z() < z; ++entry)
      if (z < entry->box.high.z()) visit(entry->solid, entry->box);
  }

 private:
  struct Entry {
    BeadSolid solid;
    Box3 box;
  };
  std::vector<Entry> entries_;
  double thickest_ = 0.0;
  double thinnest_;
};

/// A stretch of one of the lines along x.
struct LineStretch {
  std::int64_t line;
  Stretch stretch;
};

double coveredLength(std::vector<LineStretch>& stretches) {
  std::sort(stretches.begin(), stretches.end(), [](const LineStretch& a, const LineStretch& b) {
    return a.line != b.line ? a.line < b.line : a.stretch.from < b.stretch.from;
  });
  double sum = 0.0, covered_to = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& s = stretches[i].stretch;
    const bool is_first = i == 0 || stretches[i - 1].line != stretches[i].line;
    const double from = is_first ? s.from : std::max(s.from, covered_to);
    sum += std::max(0.0, s.to - from);
    covered_to = is_first ? s.to : std::max(covered_to, s.to);
  }
  return sum;
}

double areaAt(const HeightOrder& solids, double z, double pitch_mm) {
  std::vector<LineStretch> stretches;
  solids.visitAt(z, [&](const BeadSolid& solid, const Box3& box) {
    const auto first = static_cast<std::int64_t>(std::ceil(box.low.y() / pitch_mm));
    const auto last = static_cast<std::int64_t>(std::floor(box.high.y() / pitch_mm));
    for (std::int64_t line = first; line <= last; ++line)
      if (const auto stretch = solid.alongX(static_cast<double>(line) * pitch_mm, z))
        stretches.push_back({line, *stretch});
  });
  return coveredLength(stretches) * pitch_mm;
}

/// Beads are round towards bottom and top: in the angle about their middle the area is smooth.
double slabVolume(const HeightOrder& solids, double low, double high, double pitch_mm) {
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  double sum = 0.0;
  for (std::size_t i = 0; i < std::size(kNodes); ++i)
    for (const double node : {-kNodes[i], kNodes[i]}) {
      const double angle = 0.5 * M_PI * (1.0 + node);
      sum += kWeights[i] * std::sin(angle) * areaAt(solids, middle + half * std::cos(angle), pitch_mm);
    }
  return 0.5 * M_PI * half * sum;
}

}  // namespace

double unionVolume(const std::vector<BeadSolid>& solids, Progress& progress) {
  if (solids.empty()) return 0.0;
  const double thinnest = thinnestOf(solids);
  const HeightOrder order(solids, thinnest);
  const std::vector<double> levels = order.levels();
  const double pitch_mm = thinnest / kLinesPerBead;
  std::vector<double> volumes(levels.size() - 1);
  parallelFor(
      volumes.size(),
      [&](std::size_t i) { volumes[i] = slabVolume(order, levels[i], levels[i + 1], pitch_mm); }, progress,
      "measure");
  double sum = 0.0;
  for (const double volume : volumes) sum += volume;
  return sum;
}

}  // namespace lamina
