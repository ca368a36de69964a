// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/direction_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "slicing/multi_direction/sphere_directions.hpp"

namespace lamina {
namespace {

constexpr double kCutShare = 0.005;  // of the surface: what a cut has to be worth
constexpr double kCutAreaShare = 0.01;
constexpr double kEnoughShare = 0.001;  // of the surface, unsupported, from which no cut is looked for
constexpr std::array<double, 4> kLeftShares = {0.0, 0.01, 0.02, 0.05};  // of what hangs, above a cut
constexpr int kRefinements = 5;
constexpr double kSameDirection = 0.95;
constexpr double kSameHeightMm = 2.0;
constexpr double kAsGood = 0.95;     // of what a proposal may gain: it is not worth trying
constexpr std::size_t kAtOnce = 16;  // candidates that are tried side by side

/// A part that has been cut so far.
struct PartLeft {
  CutSequence sequence;
  CellsLeft cells;
  HangingFaces hanging;
  double price_mm2 = 0.0;  // of its cuts, and what hangs in their pieces

  double cost() const { return price_mm2 + hanging.area_mm2; }
};

/// A plane that may be worth a cut.
struct CutProposal {
  CuttingPlane plane;
  double bound_mm2 = 0.0;  // of the gain
  double highest_mm = 0.0;
};

/// A cut that holds, and what it is worth.
struct HoldingCut {
  CuttingPlane plane;
  CutCells cells;
  double gain_mm2 = 0.0;
  double hanging_mm2 = 0.0;
};

double surfaceOf(const FacePolygons& faces) {
  double sum = 0.0;
  for (std::uint32_t face = 0; face < faces.count(); ++face) sum += faces.area(face);
  return sum;
}

double overhangLimit(const CutQuestion& question) {
  return -std::sin(toRadians(question.settings.max_overhang_deg)) - 1e-9;
}

double highestAlong(const FacePolygons& faces, std::uint32_t face, const Point3& up) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Point3* at = faces.begin(face); at != faces.end(face); ++at)
    highest = std::max(highest, up.dot(*at));
  return highest;
}

/// Areas above heights along a direction, in steps.
class AreaAbove {
 public:
  AreaAbove(double low_mm, double high_mm, double step_mm)
      : low_(low_mm),
        step_(step_mm),
        area_(static_cast<std::size_t>(std::ceil((high_mm - low_mm) / step_mm)) + 2, 0.0) {}

  void add(const FacePolygons& faces, std::uint32_t face, const Point3& up) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Point3* at = faces.begin(face); at != faces.end(face); ++at)
      lowest = std::min(lowest, up.dot(*at));
    const std::size_t first = stepOf(lowest);
    const std::size_t last = stepOf(highestAlong(faces, face, up));
    double above = faces.area(face);
    for (std::size_t step = first; step <= last; ++step) {
      const double next = step == last ? 0.0 : faces.areaAbove(face, {up, low_ + step_ * (step + 1.0)});
      area_[step] += above - next;
      above = next;
    }
  }

  /// From areas within each step to those above where it begins.
  void sum() {
    for (std::size_t step = area_.size() - 1; step > 0; --step) area_[step - 1] += area_[step];
  }

  double above(double height_mm) const { return area_[stepOf(height_mm)]; }
  /// Where the first step begins above which there is no more than that.
  double lowestWithin(double area_mm2) const {
    std::size_t step = 0;
    while (step + 1 < area_.size() && area_[step] > area_mm2) ++step;
    return low_ + step_ * static_cast<double>(step);
  }

 private:
  std::size_t stepOf(double height_mm) const {
    const double step = std::floor((height_mm - low_) / step_);
    return static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(area_.size() - 1)));
  }

  double low_;
  double step_;
  std::vector<double> area_;
};

std::array<double, 2> rangeAlong(const FacePolygons& faces, const Point3& up) {
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
  if (faces.count() == 0) return {0.0, 0.0};
  for (const Point3* at = faces.begin(0); at != faces.end(faces.count() - 1); ++at) {
    range[0] = std::min(range[0], up.dot(*at));
    range[1] = std::max(range[1], up.dot(*at));
  }
  return range;
}

class CutSearch {
 public:
  CutSearch(const CutQuestion& question, Progress& progress)
      : question_(question),
        progress_(progress),
        surface_mm2_(surfaceOf(question.faces)),
        step_mm_(question.cells.frame().voxel_mm),
        directions_(sphereDirections(question.settings.count, toRadians(question.settings.max_tilt_deg))) {}

  CutSequence best() const {
    std::vector<PartLeft> beam;
    beam.push_back({{{}, {}, question_.faces, 0.0},
                    CellsLeft(question_.cells.nodeCount(), 1),
                    hangingFaces(question_.faces, question_),
                    0.0});
    PartLeft best = beam.front();
    for (int cuts = 0; cuts < question_.settings.most_cuts; ++cuts) {
      if (best.hanging.area_mm2 <= kEnoughShare * surface_mm2_) break;
      beam = continued(beam);
      if (beam.empty() || beam.front().cost() >= best.cost()) break;
      best = beam.front();
    }
    return std::move(best.sequence);
  }

  /// Of cuts in what a sequence leaves.
  CutObstacles obstacles(const CutSequence& sequence) const {
    PartLeft part{sequence, CellsLeft(question_.cells.nodeCount(), 1), hangingFaces(sequence.rest, question_),
                  0.0};
    for (const CuttingPlane& cut : sequence.cuts)
      if (TriedCut tried = cutCells(question_.cells, part.cells, cut, question_.rules); tried)
        part.cells = std::move(tried.cells.left);
    std::vector<DirectionObstacle> of_direction(directions_.size());
    parallelFor(
        directions_.size(), [&](std::size_t i) { of_direction[i] = obstacleAlong(part, directions_[i]); },
        progress_, "directions");
    CutObstacles all;
    all.least_gain_mm2 = kCutShare * surface_mm2_;
    all.least_base_mm2 = question_.rules.least_base_mm2;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      ++all.directions[static_cast<std::size_t>(of_direction[i])];
      if (of_direction[i] == DirectionObstacle::Bed)
        all.least_tip_mm = std::min(all.least_tip_mm, leastTipHeight(question_.rules.head, directions_[i]));
    }
    return all;
  }

 private:
  /// Of the lowest plane that is proposed.
  DirectionObstacle obstacleAlong(const PartLeft& part, const Point3& up) const {
    if (proposalsAbove(-std::numeric_limits<double>::infinity(), part, up).empty())
      return DirectionObstacle::Gain;
    const std::vector<CutProposal> proposals = proposalsAlong(part, up);
    if (proposals.empty()) return DirectionObstacle::Bed;
    const CuttingPlane& lowest = proposals.front().plane;
    switch (cutCells(question_.cells, part.cells, lowest, question_.rules).fault) {
      case CutFault::InBed:
        return DirectionObstacle::Bed;
      case CutFault::SmallBase:
        return DirectionObstacle::Base;
      case CutFault::LooseRest:
        return DirectionObstacle::Rest;
      case CutFault::SmallPiece:
        return DirectionObstacle::Gain;
      case CutFault::None:
        break;
    }
    const bool is_worth = levelGain(part, lowest) > kCutShare * surface_mm2_;
    return is_worth ? DirectionObstacle::Price : DirectionObstacle::Gain;
  }

  double priceOf(const HoldingCut& cut) const {
    return cut.hanging_mm2 + kCutShare * surface_mm2_ + kCutAreaShare * cut.cells.area_mm2;
  }

  /// The best of all sequences with one cut more, each once.
  std::vector<PartLeft> continued(const std::vector<PartLeft>& beam) const {
    std::vector<PartLeft> longer;
    for (const PartLeft& part : beam)
      for (const HoldingCut& cut : cutsOf(part)) longer.push_back(withCut(part, cut));
    std::stable_sort(longer.begin(), longer.end(),
                     [](const PartLeft& a, const PartLeft& b) { return a.cost() < b.cost(); });
    const auto isSame = [](const PartLeft& a, const PartLeft& b) { return a.cells == b.cells; };
    longer.erase(std::unique(longer.begin(), longer.end(), isSame), longer.end());
    const auto most = static_cast<std::size_t>(question_.settings.beam);
    if (longer.size() > most) longer.erase(longer.begin() + static_cast<std::ptrdiff_t>(most), longer.end());
    return longer;
  }

  PartLeft withCut(const PartLeft& part, const HoldingCut& cut) const {
    PartLeft next{part.sequence, cut.cells.left, {}, part.price_mm2 + priceOf(cut)};
    next.sequence.cuts.push_back(cut.plane);
    next.sequence.hanging_mm2.push_back(cut.hanging_mm2);
    next.sequence.cut_mm2 += cut.cells.area_mm2;
    next.sequence.rest = part.sequence.rest.below(cut.plane);
    next.hanging = hangingFaces(next.sequence.rest, question_);
    return next;
  }

  /// Cuts that hold and are worth it, the best first, no two alike.
  std::vector<HoldingCut> cutsOf(const PartLeft& part) const {
    const std::vector<CutProposal> proposals = proposalsFor(part);
    const auto most = static_cast<std::size_t>(question_.settings.beam);
    std::vector<HoldingCut> found;
    for (std::size_t first = 0; first < proposals.size(); first += kAtOnce) {
      if (found.size() == most && found.back().gain_mm2 >= kAsGood * proposals[first].bound_mm2) break;
      const std::size_t count = std::min(kAtOnce, proposals.size() - first);
      std::vector<std::optional<HoldingCut>> tried(count);
      parallelFor(
          count, [&](std::size_t i) { tried[i] = lowestHolding(part, proposals[first + i]); }, progress_,
          "cuts");
      for (std::optional<HoldingCut>& cut : tried)
        if (cut) insert(std::move(*cut), most, found);
    }
    return found;
  }

  static void insert(HoldingCut cut, std::size_t most, std::vector<HoldingCut>& found) {
    const auto isAlike = [&](const HoldingCut& other) {
      return cut.plane.up.dot(other.plane.up) >= kSameDirection &&
             std::abs(cut.plane.from_mm - other.plane.from_mm) <= kSameHeightMm;
    };
    const auto alike = std::find_if(found.begin(), found.end(), isAlike);
    if (alike != found.end()) {
      if (alike->gain_mm2 >= cut.gain_mm2) return;
      found.erase(alike);
    }
    const auto place = std::find_if(found.begin(), found.end(),
                                    [&](const HoldingCut& other) { return other.gain_mm2 < cut.gain_mm2; });
    found.insert(place, std::move(cut));
    if (found.size() > most) found.pop_back();
  }

  /// For each direction the planes above which little hangs, those that may gain most first.
  std::vector<CutProposal> proposalsFor(const PartLeft& part) const {
    std::vector<std::vector<CutProposal>> of_direction(directions_.size());
    parallelFor(
        directions_.size(), [&](std::size_t i) { of_direction[i] = proposalsAlong(part, directions_[i]); },
        progress_, "directions");
    std::vector<CutProposal> all;
    for (std::vector<CutProposal>& some : of_direction) all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const CutProposal& a, const CutProposal& b) { return a.bound_mm2 > b.bound_mm2; });
    return all;
  }

  std::vector<CutProposal> proposalsAlong(const PartLeft& part, const Point3& up) const {
    return proposalsAbove(lowestClearOfBed(question_.cells, part.cells, up, question_.rules), part, up);
  }

  std::vector<CutProposal> proposalsAbove(double clear_mm, const PartLeft& part, const Point3& up) const {
    const FacePolygons& faces = part.sequence.rest;
    const auto [low, high] = rangeAlong(faces, up);
    AreaAbove level(low, high, step_mm_);
    for (const std::uint32_t face : part.hanging.faces) level.add(faces, face, up);
    level.sum();
    AreaAbove own(low, high, step_mm_);
    double nothing_above = low;
    for (std::uint32_t face = 0; face < faces.count(); ++face) {
      if (faces.normal(face).dot(up) >= overhangLimit(question_)) continue;
      own.add(faces, face, up);
      nothing_above = std::max(nothing_above, highestAlong(faces, face, up));
    }
    own.sum();
    std::vector<CutProposal> proposals;
    for (const double share : kLeftShares) {
      const double wanted = share == 0.0 ? nothing_above : own.lowestWithin(share * part.hanging.area_mm2);
      const double from = std::max(wanted, clear_mm);
      const double gain = level.above(from) - kCutShare * surface_mm2_;
      if (gain <= 0.0 || (!proposals.empty() && proposals.back().plane.from_mm == from)) continue;
      proposals.push_back({{up, from}, gain, high});
    }
    return proposals;
  }

  /// The lowest plane from a proposal upwards that holds, if it gains.
  std::optional<HoldingCut> lowestHolding(const PartLeft& part, const CutProposal& proposal) const {
    CuttingPlane plane = proposal.plane;
    double fails_mm = plane.from_mm;
    while (plane.from_mm < proposal.highest_mm) {
      if (levelGain(part, plane) <= kCutShare * surface_mm2_) return std::nullopt;
      if (cutCells(question_.cells, part.cells, plane, question_.rules)) break;
      fails_mm = plane.from_mm;
      plane.from_mm += step_mm_;
    }
    if (plane.from_mm >= proposal.highest_mm) return std::nullopt;
    plane.from_mm = lowered(part, plane, fails_mm);
    return valued(part, plane);
  }

  /// Between a plane that fails and one that holds; at a corner of the part, if one is within a cell above.
  double lowered(const PartLeft& part, CuttingPlane plane, double fails_mm) const {
    double holds_mm = plane.from_mm;
    for (int i = 0; i < kRefinements && fails_mm < holds_mm; ++i) {
      plane.from_mm = 0.5 * (fails_mm + holds_mm);
      (cutCells(question_.cells, part.cells, plane, question_.rules) ? holds_mm : fails_mm) = plane.from_mm;
    }
    double corner_mm = holds_mm + step_mm_;
    const FacePolygons& faces = part.sequence.rest;
    for (const Point3* at = faces.begin(0); at != faces.end(faces.count() - 1); ++at) {
      const double height = plane.up.dot(*at);
      if (height >= holds_mm && height < corner_mm) corner_mm = height;
    }
    plane.from_mm = corner_mm;
    return cutCells(question_.cells, part.cells, plane, question_.rules) ? corner_mm : holds_mm;
  }

  /// What hangs above a plane along +z.
  double levelGain(const PartLeft& part, const CuttingPlane& plane) const {
    double sum = 0.0;
    for (const std::uint32_t face : part.hanging.faces) sum += part.sequence.rest.areaAbove(face, plane);
    return sum;
  }

  std::optional<HoldingCut> valued(const PartLeft& part, const CuttingPlane& plane) const {
    TriedCut tried = cutCells(question_.cells, part.cells, plane, question_.rules);
    if (!tried) return std::nullopt;
    HoldingCut cut{plane, std::move(tried.cells), 0.0, 0.0};
    const FacePolygons& faces = part.sequence.rest;
    for (std::uint32_t face = 0; face < faces.count(); ++face)
      if (faces.normal(face).dot(plane.up) < overhangLimit(question_))
        cut.hanging_mm2 += faces.areaAbove(face, plane);
    cut.gain_mm2 = levelGain(part, plane) - priceOf(cut);
    if (cut.gain_mm2 <= 0.0) return std::nullopt;
    return cut;
  }

  const CutQuestion& question_;
  Progress& progress_;
  double surface_mm2_;
  double step_mm_;
  std::vector<Point3> directions_;
};

}  // namespace

std::vector<std::uint32_t> facesHangingAlong(const FacePolygons& faces, const Point3& up,
                                             const CutQuestion& question) {
  std::vector<std::uint32_t> hanging;
  for (std::uint32_t face = 0; face < faces.count(); ++face)
    if (faces.normal(face).dot(up) < overhangLimit(question)) hanging.push_back(face);
  return hanging;
}

HangingFaces hangingFaces(const FacePolygons& faces, const CutQuestion& question) {
  HangingFaces hanging;
  const double held_mm = question.rules.bed_mm + question.first_layer_mm;
  for (std::uint32_t face = 0; face < faces.count(); ++face) {
    if (faces.normal(face).z() >= overhangLimit(question)) continue;
    if (highestAlong(faces, face, Point3::UnitZ()) <= held_mm) continue;
    hanging.faces.push_back(face);
    hanging.area_mm2 += faces.area(face);
  }
  return hanging;
}

CutSequence bestCuts(const CutQuestion& question, Progress& progress) {
  return CutSearch(question, progress).best();
}

CutObstacles cutObstacles(const CutSequence& sequence, const CutQuestion& question, Progress& progress) {
  return CutSearch(question, progress).obstacles(sequence);
}

}  // namespace lamina
