// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/bridged_areas.hpp"

#include <cmath>
#include <utility>

#include "geometry/polygon/region_lists.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/planning/bridges/bridge_direction.hpp"
#include "planning/bridges/bridge_threads.hpp"

namespace lamina {
namespace {

constexpr double kBetweenRoundThreads = 0.05;  // mm

Regions touching(const Regions& regions, Box2 box, double margin_mm) {
  Regions found;
  box.low.array() -= margin_mm;
  box.high.array() += margin_mm;
  for (const Region& region : regions) {
    const Box2 own = boundingBox({region.outer});
    if (!own.isEmpty() && (own.low.array() <= box.high.array()).all() &&
        (box.low.array() <= own.high.array()).all())
      found.push_back(region);
  }
  return found;
}

class AreaSharer {
 public:
  AreaSharer(const Regions& inside, const Regions& below, const BridgeMeasures& measures)
      : inside_(inside), below_(below), measures_(measures) {}

  BridgedAreas share() {
    Regions covered;
    Regions unheld;
    for (const Region& piece : overNothing(inside_, below_, measures_.narrowest_mm))
      addPiece(piece, covered, unheld);
    if (covered.empty() && unheld.empty()) {
      areas_.rest = inside_;
      return std::move(areas_);
    }
    areas_.rest = inside_;
    if (!covered.empty()) areas_.rest = difference(inside_, unite(outlines(covered)));
    if (!unheld.empty()) {
      areas_.hanging = intersection(offset(unheld, measures_.fringe_mm), areas_.rest);
      areas_.rest = difference(areas_.rest, areas_.hanging);
    }
    return std::move(areas_);
  }

 private:
  void addPiece(const Region& piece, Regions& covered, Regions& unheld) {
    const BridgeSettings& settings = measures_.settings;
    const Regions near = touching(below_, boundingBox({piece.outer}), settings.anchor_mm);
    const BridgeDirection direction = directionOver(piece, near);
    if (direction.held == 0.0 || direction.held < settings.least_held) {
      ++areas_.counts.unheld;
      areas_.counts.unheld_mm2 += area({piece});
      unheld.push_back(piece);
      return;
    }
    const ThreadLayout layout{direction.angle_rad, measures_.thread_pitch_mm, settings.anchor_mm};
    DepositedBridge bridge{coveredByThreads(piece, inside_, layout),
                           bridgeThreads(piece, near, inside_, layout)};
    appendTo(covered, bridge.area);
    areas_.bridges.push_back(std::move(bridge));
    Bridging one;
    one.bridges = 1;
    one.longest_mm = direction.span_mm;
    one.too_long = settings.longest_mm > 0.0 && direction.span_mm > settings.longest_mm ? 1 : 0;
    areas_.counts += one;
  }

  BridgeDirection directionOver(const Region& piece, const Regions& near) const {
    const BridgeSettings& settings = measures_.settings;
    const BridgeSearch search{settings.anchor_mm, measures_.thread_pitch_mm, settings.least_held};
    return settings.angle_deg < 0.0 ? bridgeDirection(piece, near, search)
                                    : bridgeAlong(toRadians(settings.angle_deg), piece, near, search);
  }

  const Regions& inside_;
  const Regions& below_;
  const BridgeMeasures& measures_;
  BridgedAreas areas_;
};

}  // namespace

Regions overNothing(const Regions& inside, const Regions& below, double narrowest_mm) {
  if (inside.empty()) return {};
  Regions free = difference(inside, touching(below, boundingBox(outlines(inside)), 0.0));
  if (free.empty() || narrowest_mm == 0.0) return free;
  return offset(offset(free, -0.5 * narrowest_mm), 0.5 * narrowest_mm);
}

BridgedAreas bridgedAreas(const Regions& inside, const Regions& below, const BridgeMeasures& measures) {
  return AreaSharer(inside, below, measures).share();
}

double threadPitch(const BridgeSettings& settings, double bead_width_mm, double pitch_mm) {
  if (settings.thread == BridgeThread::Bead) return pitch_mm;
  return (settings.thread_mm > 0.0 ? settings.thread_mm : bead_width_mm) + kBetweenRoundThreads;
}

Bead threadBead(const BridgeSettings& settings, const Bead& bead) {
  if (settings.thread == BridgeThread::Bead) {
    if (settings.flow == 1.0) return bead;
    return beadOfArea(settings.flow * crossSection(bead), bead.height_mm);
  }
  const double diameter = settings.thread_mm > 0.0 ? settings.thread_mm : bead.width_mm;
  const double scaled = diameter * std::sqrt(settings.flow);
  return {scaled, scaled};
}

}  // namespace lamina
