// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/support_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/spatial/edge_bands.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/piecewise.hpp"

namespace lamina {
namespace {

constexpr std::size_t kRadii = 4;        // for which it is known where a branch may be
constexpr double kSurelyReached = 0.98;  // of a step: what is left goes beyond the border
constexpr double kMeeting = 1e-6;        // mm
constexpr double kPushedOut = 1e-3;      // mm: beyond the border of what is blocked
constexpr double kCoarseOutline = 0.02;  // mm: by which those of wide branches are simplified, and wider
constexpr double kRadiusSlack = 1e-9;    // mm

/// Where branches of some radii may not be, layer by layer.
class BlockedPlaces {
 public:
  BlockedPlaces(const StackedMaterial& stack, std::size_t count, const SupportSettings& settings,
                Progress& progress) {
    for (std::size_t c = 0; c < kRadii; ++c) {
      const double share = static_cast<double>(c) / (kRadii - 1);
      radii_[c] = 0.5 * (settings.tip_mm + share * std::max(0.0, settings.branch_mm - settings.tip_mm));
    }
    find(stack, count, settings, progress);
  }

  bool contain(const Point2& at, double radius_mm, std::size_t layer) const {
    return bordersOf(radius_mm, layer).enclose(at);
  }

  /// The nearest place that is free, a little beyond the border; none if that is farther than `reach_mm`. Of
  /// equally near ones that on the first edge.
  std::optional<Point2> nearestFree(const Point2& at, double radius_mm, std::size_t layer,
                                    double reach_mm) const {
    double nearest = reach_mm;
    std::uint32_t first = 0;
    std::optional<Point2> free;
    bordersOf(radius_mm, layer).visitNear(at, reach_mm, [&](const BorderEdge& edge, std::uint32_t index) {
      const Point2 along = edge.to - edge.from;
      const double squared = along.squaredNorm();
      const double t = squared > 0.0 ? std::clamp((at - edge.from).dot(along) / squared, 0.0, 1.0) : 0.0;
      const Point2 way = edge.from + t * along - at;
      const double length = way.norm();
      const double distance = length + kPushedOut;
      const bool is_nearer = distance < nearest || (distance == nearest && free && index < first);
      if (!is_nearer || length == 0.0) return;
      nearest = distance;
      first = index;
      free = at + way * (distance / length);
    });
    return free;
  }

 private:
  using Borders = std::shared_ptr<const EdgeBands>;

  /// The least radius round the part itself, as it decides where a tip has room; others round that.
  void find(const StackedMaterial& stack, std::size_t count, const SupportSettings& settings,
            Progress& progress) {
    std::array<std::vector<SharedRegions>, kRadii> blocked;
    for (std::vector<SharedRegions>& layers : blocked) layers.resize(count);
    const auto isShared = [&](std::size_t k) { return k > 0 && stack.material[k] == stack.material[k - 1]; };
    const auto grow = [&](std::size_t k) {
      if (isShared(k)) return;
      blocked[0][k] = std::make_shared<const Regions>(
          grownByPieces(*stack.material[k], settings.side_gap_mm + radii_[0]));
      const Regions narrow = simplified(*blocked[0][k], kCoarseOutline);
      // By no less than the distance, though from fewer corners.
      for (std::size_t c = 1; c < kRadii; ++c)
        blocked[c][k] =
            std::make_shared<const Regions>(grownByPieces(narrow, radii_[c] - radii_[0] + kCoarseOutline));
    };
    parallelFor(count, grow, progress, "supports");
    for (std::vector<SharedRegions>& layers : blocked) {
      for (std::size_t k = 1; k < count; ++k)
        if (isShared(k)) layers[k] = layers[k - 1];
      if (settings.foot == SupportFoot::Bed) addOutOfReach(stack, settings, layers);
    }
    arrange(blocked, progress);
  }

  /// The greatest radius that a branch can have so far below the highest tip.
  static double widestBelow(double height_mm, const SupportSettings& settings) {
    const double length_mm = height_mm / std::cos(toRadians(settings.branch_angle_deg));
    return 0.5 * settings.tip_mm + std::tan(toRadians(settings.branch_taper_deg)) * length_mm;
  }

  void arrange(const std::array<std::vector<SharedRegions>, kRadii>& blocked, Progress& progress) {
    const std::size_t count = blocked.front().size();
    for (std::vector<Borders>& layers : borders_) layers.resize(count);
    const auto isShared = [&](std::size_t c, std::size_t k) {
      return k > 0 && blocked[c][k] == blocked[c][k - 1];
    };
    const auto arrange_layer = [&](std::size_t k) {
      for (std::size_t c = 0; c < kRadii; ++c)
        if (blocked[c][k] && !isShared(c, k))
          borders_[c][k] = std::make_shared<const EdgeBands>(*blocked[c][k]);
    };
    parallelFor(count, arrange_layer, progress, "supports");
    for (std::size_t c = 0; c < kRadii; ++c)
      for (std::size_t k = 1; k < count; ++k)
        if (isShared(c, k)) borders_[c][k] = borders_[c][k - 1];
  }

  /// From the bed up: a branch can go no farther aside in a layer than its lean allows.
  static void addOutOfReach(const StackedMaterial& stack, const SupportSettings& settings,
                            std::vector<SharedRegions>& blocked) {
    const double lean = kSurelyReached * std::tan(toRadians(settings.branch_angle_deg));
    SharedRegions own_below;
    for (std::size_t k = 0; k < blocked.size(); ++k) {
      const SharedRegions own = blocked[k];
      if (!own) return;  // nor farther up
      const bool is_prism = own == own_below && blocked[k - 1] == own;
      own_below = own;
      if (k == 0 || is_prism) continue;
      const Regions out_of_reach = offset(*blocked[k - 1], -lean * stack.bounds[k].height());
      if (!out_of_reach.empty()) blocked[k] = std::make_shared<const Regions>(united(*own, out_of_reach));
    }
  }

  const EdgeBands& bordersOf(double radius_mm, std::size_t layer) const {
    std::size_t c = 0;
    while (c + 1 < kRadii && radii_[c] < radius_mm - kRadiusSlack) ++c;
    return *borders_[c][layer];
  }

  std::array<double, kRadii> radii_{};
  std::array<std::vector<Borders>, kRadii> borders_;
};

/// The lower end of a branch that still grows.
struct BranchEnd {
  Point2 at;
  double radius_mm = 0.0;
  double length_mm = 0.0;  ///< to its farthest tip
  std::size_t branch = 0;
};

enum class BranchFoot { Open, Bed, Part, None };

class BranchGrower {
 public:
  BranchGrower(const StackedMaterial& stack, std::vector<BranchTip> tips, const SupportSettings& settings,
               Progress& progress)
      : stack_(stack),
        settings_(settings),
        tips_(std::move(tips)),
        count_(highestLayer()),
        blocked_(stack, count_, settings, progress),
        lean_(std::tan(toRadians(settings.branch_angle_deg))),
        taper_(std::tan(toRadians(settings.branch_taper_deg))) {}

  SupportTree grow() {
    discs_.resize(stack_.size());
    joined_.resize(tips_.size());
    feet_.assign(tips_.size(), BranchFoot::Open);
    for (std::size_t i = 0; i < tips_.size(); ++i) joined_[i] = i;
    std::vector<std::vector<std::size_t>> starting(count_ + 1);
    for (std::size_t i = 0; i < tips_.size(); ++i) starting[firstLayerOf(tips_[i])].push_back(i);
    for (std::size_t k = count_; k-- > 0;) {
      step(k);
      for (const std::size_t i : starting[k]) begin(i, k);
      for (const BranchEnd& end : ends_)
        discs_[k].push_back(
            {end.at, end.radius_mm, stack_.bounds[k].bottom_mm, stack_.bounds[k].top_mm, end.branch});
    }
    for (const BranchEnd& end : ends_) feet_[end.branch] = BranchFoot::Bed;
    return finished();
  }

 private:
  std::size_t highestLayer() const {
    std::size_t highest = 0;
    for (const BranchTip& tip : tips_) highest = std::max(highest, lastLayerOf(tip) + 1);
    return highest;
  }
  static std::size_t lastLayerOf(const BranchTip& tip) {
    return tip.top.caps.empty() ? tip.top.full_layers - 1 : tip.top.caps.back().layer;
  }
  /// The uppermost of its own height; the lowest for a tip without any.
  static std::size_t firstLayerOf(const BranchTip& tip) {
    return tip.top.full_layers > 0 ? tip.top.full_layers - 1 : 0;
  }

  /// A tip that is too near to a wall that leans begins where it is far enough.
  void begin(std::size_t tip, std::size_t layer) {
    const double radius = 0.5 * settings_.tip_mm;
    std::size_t k = layer;
    if (waiting_.empty()) waiting_.resize(count_);
    if (blocked_.contain(tips_[tip].at, radius, k) && !keepsLedgeGap(tips_[tip].at, k)) {
      if (k == 0 || isInPart(tips_[tip].at, k)) {
        feet_[tip] = BranchFoot::None;
        return;
      }
      waiting_[k - 1].push_back(tip);
      return;
    }
    if (k == firstLayerOf(tips_[tip]))
      for (const ColumnTop::Cap& cap : tips_[tip].top.caps)
        discs_[cap.layer].push_back({tips_[tip].at, radius, cap.bottom_mm, cap.top_mm, tip});
    if (tips_[tip].top.full_layers > 0)
      ends_.push_back({tips_[tip].at, radius, 0.0, tip});
    else
      feet_[tip] = BranchFoot::Bed;
  }

  void step(std::size_t layer) {
    if (layer + 1 < count_) {
      const double height = stack_.bounds[layer + 1].top_mm - stack_.bounds[layer].top_mm;
      const std::vector<Point2> goals = goalsOf(layer, lean_ * height);
      std::vector<BranchEnd> kept;
      for (std::size_t i = 0; i < ends_.size(); ++i)
        if (std::optional<BranchEnd> end = moved(ends_[i], goals[i], layer, height)) kept.push_back(*end);
      ends_ = std::move(kept);
      joinThoseThatMeet();
    }
    if (waiting_.empty()) return;
    const std::vector<std::size_t> waiting = std::exchange(waiting_[layer], {});
    for (const std::size_t tip : waiting) begin(tip, layer);
  }

  /// Towards the nearest neighbour if both meet above the bed, else straight down.
  std::vector<Point2> goalsOf(std::size_t layer, double step_mm) const {
    const double reach = 2.0 * lean_ * (stack_.bounds[layer].top_mm - stack_.bounds.front().bottom_mm);
    std::vector<std::size_t> by_x(ends_.size());
    for (std::size_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
    std::sort(by_x.begin(), by_x.end(), [this](std::size_t a, std::size_t b) {
      return std::make_pair(ends_[a].at.x(), a) < std::make_pair(ends_[b].at.x(), b);
    });
    std::vector<Point2> goals(ends_.size());
    for (std::size_t place = 0; place < by_x.size(); ++place) {
      const Point2& at = ends_[by_x[place]].at;
      double nearest = reach;
      std::optional<Point2> mate;
      const auto look = [&](std::size_t other) {
        const Point2& there = ends_[by_x[other]].at;
        if (std::abs(there.x() - at.x()) >= nearest) return false;
        const double distance = (there - at).norm();
        if (distance < nearest) {
          nearest = distance;
          mate = there;
        }
        return true;
      };
      for (std::size_t other = place + 1; other < by_x.size() && look(other); ++other) {
      }
      for (std::size_t other = place; other-- > 0 && look(other);) {
      }
      goals[by_x[place]] = at;
      if (mate && nearest > 0.0)
        goals[by_x[place]] = at + std::min(step_mm, 0.5 * nearest) / nearest * (*mate - at);
    }
    return goals;
  }

  bool isInPart(const Point2& at, std::size_t layer) const {
    bool is_inside = false;
    for (const Region& region : *stack_.material[layer]) {
      is_inside = is_inside != encloses(region.outer, at);
      for (const Polygon& hole : region.holes) is_inside = is_inside != encloses(hole, at);
    }
    return is_inside;
  }

  bool isNearPart(const Point2& at, std::size_t layer, double distance_mm) const {
    bool is_near = false;
    for (const Region& region : *stack_.material[layer])
      forEachEdge(region, [&](const BorderEdge& edge) {
        is_near = is_near || (nearestOnSegment(edge.from, edge.to, at) - at).norm() < distance_mm;
      });
    return is_near || isInPart(at, layer);
  }

  /// As thin as a tip.
  bool keepsLedgeGap(const Point2& at, std::size_t layer) const {
    return !isNearPart(at, layer, ledgeGap(settings_) + 0.5 * settings_.tip_mm);
  }

  /// Where a branch goes that has no way at the full gap: out to where it has, or straight down.
  std::optional<Point2> besidePart(const Point2& from, std::size_t layer, double step_mm) const {
    const double gap = settings_.side_gap_mm - ledgeGap(settings_);
    const std::optional<Point2> free =
        blocked_.nearestFree(from, 0.5 * settings_.tip_mm, layer, gap + step_mm);
    if (free) {
      const Point2 way = *free - from;
      const Point2 at = from + std::min(1.0, step_mm / way.norm()) * way;
      if (keepsLedgeGap(at, layer)) return at;
    }
    return keepsLedgeGap(from, layer) ? std::make_optional(from) : std::nullopt;
  }

  std::optional<BranchEnd> moved(BranchEnd end, const Point2& goal, std::size_t layer, double height_mm) {
    const double step = lean_ * height_mm;
    const Point2 from = end.at;
    const double wide =
        std::min(std::max(end.radius_mm, 0.5 * settings_.tip_mm + taper_ * (end.length_mm + height_mm)),
                 0.5 * std::max(settings_.branch_mm, settings_.tip_mm));
    const auto settle = [&](const Point2& at, double radius) {
      end.at = at;
      end.radius_mm = radius;
      end.length_mm += std::hypot(height_mm, (at - from).norm());
      return end;
    };
    // Where the part comes too near a thick branch goes on as thin as its tip.
    for (const double radius : {wide, end.radius_mm, 0.5 * settings_.tip_mm}) {
      for (const Point2& at : {goal, from})
        if (!blocked_.contain(at, radius, layer)) return settle(at, radius);
      const std::optional<Point2> free = blocked_.nearestFree(from, radius, layer, step);
      if (free && !blocked_.contain(*free, radius, layer)) return settle(*free, radius);
    }
    if (const std::optional<Point2> at = besidePart(from, layer, step))
      return settle(*at, 0.5 * settings_.tip_mm);
    rest(end, layer + 1);
    return std::nullopt;
  }

  /// A branch that can go no farther stands on the part if any of that is below it, a gap above.
  void rest(const BranchEnd& end, std::size_t layer) {
    const bool is_on_part =
        settings_.foot == SupportFoot::Everywhere && isNearPart(end.at, layer - 1, end.radius_mm);
    feet_[end.branch] = is_on_part ? BranchFoot::Part : BranchFoot::None;
    if (!is_on_part) return;
    const double least = stack_.bounds[layer - 1].top_mm + settings_.bottom_gap_mm - kMeeting;
    for (std::size_t k = layer; k < count_ && stack_.bounds[k].bottom_mm < least; ++k)
      discs_[k].erase(std::remove_if(discs_[k].begin(), discs_[k].end(),
                                     [&](const BranchDisc& disc) { return disc.branch == end.branch; }),
                      discs_[k].end());
  }

  void joinThoseThatMeet() {
    std::vector<std::size_t> by_x(ends_.size());
    for (std::size_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
    std::sort(by_x.begin(), by_x.end(), [this](std::size_t a, std::size_t b) {
      return std::make_pair(ends_[a].at.x(), a) < std::make_pair(ends_[b].at.x(), b);
    });
    std::vector<bool> is_gone(ends_.size(), false);
    for (std::size_t place = 0; place < by_x.size(); ++place) {
      BranchEnd& end = ends_[by_x[place]];
      if (is_gone[by_x[place]]) continue;
      for (std::size_t next = place + 1; next < by_x.size(); ++next) {
        const BranchEnd& other = ends_[by_x[next]];
        if (other.at.x() - end.at.x() > kMeeting) break;
        if (is_gone[by_x[next]] || (other.at - end.at).norm() > kMeeting) continue;
        is_gone[by_x[next]] = true;
        joined_[other.branch] = end.branch;
        end.length_mm = std::max(end.length_mm, other.length_mm);
        end.radius_mm = std::max(end.radius_mm, other.radius_mm);
      }
    }
    std::vector<BranchEnd> left;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      if (!is_gone[i]) left.push_back(ends_[i]);
    ends_ = std::move(left);
  }

  bool isHeld(std::size_t branch) const {
    while (joined_[branch] != branch) branch = joined_[branch];
    return feet_[branch] != BranchFoot::None;
  }

  SupportTree finished() {
    SupportTree tree;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      if (isHeld(i))
        tree.tips.push_back(tips_[i]);
      else
        ++tree.dropped;
    }
    for (std::vector<BranchDisc>& discs : discs_)
      discs.erase(std::remove_if(discs.begin(), discs.end(),
                                 [this](const BranchDisc& disc) { return !isHeld(disc.branch); }),
                  discs.end());
    tree.layers = std::move(discs_);
    return tree;
  }

  const StackedMaterial& stack_;
  const SupportSettings& settings_;
  std::vector<BranchTip> tips_;
  std::size_t count_;  ///< of layers up to the highest tip
  BlockedPlaces blocked_;
  double lean_;   ///< aside for each millimetre down
  double taper_;  ///< of the radius for each millimetre of length
  std::vector<BranchEnd> ends_;
  std::vector<std::size_t> joined_;  ///< branch that each goes on as; itself if it has met none
  std::vector<BranchFoot> feet_;
  std::vector<std::vector<std::size_t>> waiting_;  ///< tips that begin in a layer, if it has room
  std::vector<std::vector<BranchDisc>> discs_;
};

}  // namespace

SupportTree growBranches(const StackedMaterial& stack, std::vector<BranchTip> tips,
                         const SupportSettings& settings, Progress& progress) {
  return BranchGrower(stack, std::move(tips), settings, progress).grow();
}

}  // namespace lamina
