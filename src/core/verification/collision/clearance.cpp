// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/clearance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/kinematics/cartesian/machine_bodies.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"
#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/deposited_tree.hpp"
#include "verification/collision/extents.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

/// A place of the nozzle on its way.
struct NozzlePlace {
  Point3 tip = Point3::Zero();  ///< [mm, bed frame]
  WaypointIndex at;             ///< there, or to which it moves
  std::size_t deposited = 0;    ///< boxes that are there (`depositedBoxes`)
};

/// All waypoints of a layer and places between them, `spacing_mm` apart at most, in the order of the motion.
/// @param deposited  boxes that are there when the layer begins
std::vector<NozzlePlace> nozzlePlaces(const Toolpath& toolpath, std::size_t layer, std::size_t deposited,
                                      const Eigen::Isometry3d& bed_from_part,
                                      const ClearanceSettings& settings) {
  std::vector<NozzlePlace> places;
  const std::vector<Path>& paths = toolpath.layers[layer].paths;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const Path& path = paths[p];
    places.push_back({bed_from_part * path.firstPoint(), {layer, p, 0}, deposited});
    if (!path.is_closed) deposited += piecesDepositedAt(path, 0, settings.tolerance_mm);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t waypoint = path.motionEnd(m);
      const Point3 start = bed_from_part * path.points[m];
      const Point3 along = bed_from_part * path.points[waypoint] - start;
      const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / settings.spacing_mm)));
      for (int i = 1; i <= steps; ++i)
        places.push_back({start + static_cast<double>(i) / steps * along, {layer, p, waypoint}, deposited});
      deposited += piecesDepositedAt(path, waypoint, settings.tolerance_mm);
    }
  }
  return places;
}

/// A body of the machine over the bed, by where the nozzle tip is. It never turns.
class HeadBody {
 public:
  /// @param normal  of the layers [bed frame]
  HeadBody(const MachineBody& body, const CartesianMachine& machine, const Point3& normal);

  const std::string& link() const { return link_; }
  /// Origin of the body's frame [mm, bed frame].
  Point3 originFor(const Point3& tip) const { return origin_from_tip_ * tip; }
  Extents extentsAt(const Point3& origin) const;
  /// Whether it is in the box, by FCL.
  bool meets(const DepositedBox& box, const Point3& origin) const;

 private:
  std::string link_;
  Eigen::Affine3d origin_from_tip_;
  Eigen::Matrix3d rotation_;
  Point3 normal_;
  Solid solid_;
  Extents around_origin_;
};

HeadBody::HeadBody(const MachineBody& body, const CartesianMachine& machine, const Point3& normal)
    : link_(body.link),
      rotation_(body.bed_from_body_at_zero.linear()),
      normal_(normal),
      solid_(body.shape),
      around_origin_(solid_.extentsAt(Eigen::Isometry3d(rotation_), normal)) {
  const Eigen::Affine3d axes_from_tip = axesFromBed(machine);
  origin_from_tip_.linear() = body.motion * axes_from_tip.linear();
  origin_from_tip_.translation() =
      body.motion * axes_from_tip.translation() + body.bed_from_body_at_zero.translation();
}

Extents HeadBody::extentsAt(const Point3& origin) const {
  Extents extents = around_origin_;
  extents.box.low += origin;
  extents.box.high += origin;
  const double along = normal_.dot(origin);
  extents.low_normal += along;
  extents.high_normal += along;
  return extents;
}

bool HeadBody::meets(const DepositedBox& box, const Point3& origin) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation_;
  pose.translation() = origin;
  return solid_.meets(box, pose);
}

constexpr std::size_t kPlacesTogether = 64;  // looked up in the tree at once
constexpr double kSpacingsTogether = 2.0;    // how far apart these may be, in spacings

/// What a body runs into at one place.
struct Hit {
  std::size_t body = 0;
  Obstacle obstacle = Obstacle::Bed;
  std::size_t box = 0;
};

/// Consecutive places near each other.
struct PlaceRange {
  const NozzlePlace* begin;
  const NozzlePlace* end;

  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

/// One layer's part of the report.
struct LayerClearance {
  std::size_t colliding = 0;
  std::optional<Collision> first;
};

/// Of the layers, in the frame of the bed.
Point3 normalOf(const MachineRun& run) { return run.bed_from_part.linear() * layerNormal(run.toolpath); }

std::vector<HeadBody> headBodies(const std::vector<MachineBody>& bodies, const CartesianMachine& machine,
                                 const Point3& normal) {
  std::vector<HeadBody> head;
  head.reserve(bodies.size());
  for (const MachineBody& body : bodies) head.emplace_back(body, machine, normal);
  return head;
}

/// Checks the places of a toolpath against what is deposited before.
class ClearanceCheck {
 public:
  ClearanceCheck(const MachineRun& run, const std::vector<MachineBody>& bodies,
                 const ClearanceSettings& settings)
      : run_(run),
        settings_(settings),
        deposited_(depositedBoxes(run.toolpath, run.bed_from_part, settings.tolerance_mm)),
        tree_(deposited_.boxes, normalOf(run)),
        bodies_(headBodies(bodies, run.machine, normalOf(run))) {}

  LayerClearance check(std::size_t layer) const {
    const std::vector<NozzlePlace> places =
        nozzlePlaces(run_.toolpath, layer, deposited_.before_layer[layer], run_.bed_from_part, settings_);
    std::vector<std::pair<std::size_t, std::size_t>> waypoints;
    LayerClearance report;
    const NozzlePlace* const last = places.data() + places.size();
    for (const NozzlePlace* begin = places.data(); begin != last;) {
      const PlaceRange range{begin, endOfRange(begin, last)};
      const std::vector<std::optional<Hit>> hits = hitsOf(range);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i]) continue;
        const NozzlePlace& place = range.begin[i];
        waypoints.emplace_back(place.at.path, place.at.waypoint);
        if (!report.first) report.first = collisionOf(place, *hits[i]);
      }
      begin = range.end;
    }
    std::sort(waypoints.begin(), waypoints.end());
    report.colliding =
        static_cast<std::size_t>(std::unique(waypoints.begin(), waypoints.end()) - waypoints.begin());
    return report;
  }

 private:
  const NozzlePlace* endOfRange(const NozzlePlace* begin, const NozzlePlace* last) const {
    const double reach = kSpacingsTogether * settings_.spacing_mm;
    const NozzlePlace* end = begin + 1;
    while (end != last && static_cast<std::size_t>(end - begin) < kPlacesTogether &&
           (end->tip - begin->tip).cwiseAbs().maxCoeff() <= reach)
      ++end;
    return end;
  }

  /// The first hit of each place, in the order of the bodies; the bed before material, and that in the order
  /// of deposition.
  std::vector<std::optional<Hit>> hitsOf(const PlaceRange& range) const {
    std::vector<std::optional<Hit>> hits(range.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      std::vector<Point3> origins(range.size());
      std::vector<Extents> extents(range.size());
      Extents all;
      for (std::size_t i = 0; i < range.size(); ++i) {
        origins[i] = bodies_[b].originFor(range.begin[i].tip);
        extents[i] = bodies_[b].extentsAt(origins[i]);
        all.include(extents[i]);
        if (!hits[i] && extents[i].box.low.z() < -settings_.tolerance_mm) hits[i] = Hit{b, Obstacle::Bed, 0};
      }
      tree_.visitMeeting(all, (range.end - 1)->deposited, [&](std::size_t box, const Extents& of_box) {
        bool is_done = true;
        for (std::size_t i = 0; i < range.size(); ++i) {
          if (hits[i]) continue;
          const bool meets = box < range.begin[i].deposited && extents[i].meets(of_box) &&
                             bodies_[b].meets(deposited_.boxes[box], origins[i]);
          if (meets) hits[i] = Hit{b, Obstacle::Material, box};
          is_done = is_done && meets;
        }
        return is_done;
      });
    }
    return hits;
  }

  Collision collisionOf(const NozzlePlace& place, const Hit& hit) const {
    Collision collision;
    collision.at = place.at;
    collision.tip = place.tip;
    collision.link = bodies_[hit.body].link();
    collision.obstacle = hit.obstacle;
    collision.place = {place.tip.x(), place.tip.y(), 0.0};
    if (hit.obstacle == Obstacle::Bed) return collision;
    collision.deposited = deposited_.boxes[hit.box].deposited;
    collision.place = deposited_.boxes[hit.box].middle;
    return collision;
  }

  const MachineRun& run_;
  ClearanceSettings settings_;
  DepositedBoxes deposited_;
  DepositedTree tree_;
  std::vector<HeadBody> bodies_;
};

}  // namespace

const char* toString(Obstacle obstacle) {
  constexpr std::array<const char*, 3> kNames = {"bed", "material", "machine"};
  return kNames.at(static_cast<std::size_t>(obstacle));
}

ClearanceReport checkClearance(const MachineRun& run, const std::vector<MachineBody>& bodies,
                               const ClearanceSettings& settings, Progress& progress) {
  if (bodies.empty())
    throw InvalidConfig("machine '" + run.machine.name +
                        "' has no collision geometry on any link that moves against the bed; expected some "
                        "on its nozzle and head");
  const ClearanceCheck check(run, bodies, settings);
  std::vector<LayerClearance> layers(run.toolpath.layers.size());
  parallelFor(
      layers.size(), [&](std::size_t l) { layers[l] = check.check(l); }, progress, "clearance");
  ClearanceReport report;
  report.waypoints = totals(run.toolpath).waypoints;
  for (const LayerClearance& layer : layers) {
    report.colliding += layer.colliding;
    if (layer.first) report.first_of_layers.push_back(*layer.first);
  }
  return report;
}

ClearanceReport checkClearance(const MachineRun& run, const ClearanceSettings& settings, Progress& progress) {
  return checkClearance(run, movingBodies(run.machine), settings, progress);
}

}  // namespace lamina
