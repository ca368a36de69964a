// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "part_view.hpp"

#include <ros/single_subscriber_publisher.h>

#include <algorithm>
#include <utility>

#include "conversions.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kGap = 0.25;  // between the parts, of the wider one

}  // namespace

PartView::PartView(std::string frame) : frame_(std::move(frame)) {
  node_.setCallbackQueue(&queue_);
  source_.publisher = advertise(names::kSourceLayers, source_);
  inclined_.publisher = advertise(names::kInclinedLayers, inclined_);
}

ros::Publisher PartView::advertise(const std::string& topic, const Side& side) {
  const auto greet = [&side](const ros::SingleSubscriberPublisher& newcomer) {
    newcomer.publish(side.layers.all());
  };
  return node_.advertise<visualization_msgs::MarkerArray>(topic, 10, greet);
}

void PartView::load(Side& side, DrawnPart part) {
  side.box.reset();
  if (part.layers > 0) side.box = part.box;
  side.layers.load(std::move(part.chunks), part.layers);
}

void PartView::showSource(DrawnPart part) {
  load(source_, std::move(part));
  standApart();
}

void PartView::showInclined(DrawnPart part) {
  load(inclined_, std::move(part));
  inclined_.publisher.publish(inclined_.layers.all());
  standApart();
}

void PartView::removeInclined() { showInclined({}); }

Point3 PartView::sourceShift() const {
  if (!source_.box || !inclined_.box) return Point3::Zero();
  const Box3& source = *source_.box;
  const Box3& inclined = *inclined_.box;
  const double gap = kGap * std::max(source.size().y(), inclined.size().y());
  return {0.5 * (inclined.low.x() + inclined.high.x() - source.low.x() - source.high.x()),
          inclined.low.y() - gap - source.high.y(), 0.0};
}

void PartView::standApart() {
  source_.layers.moveTo(toMessage(sourceShift()));
  source_.publisher.publish(source_.layers.all());
}

void PartView::showLayers(std::size_t layers) {
  for (Side* side : {&source_, &inclined_}) {
    const visualization_msgs::MarkerArray changes = side->layers.show(layers);
    if (!changes.markers.empty()) side->publisher.publish(changes);
  }
}

std::size_t PartView::layerCount() const {
  return std::max(source_.layers.layerCount(), inclined_.layers.layerCount());
}

std::optional<Box3> PartView::box() const {
  std::optional<Box3> both = inclined_.box;
  if (!source_.box) return both;
  const Box3 moved{source_.box->low + sourceShift(), source_.box->high + sourceShift()};
  if (!both) return moved;
  return Box3{both->low.cwiseMin(moved.low), both->high.cwiseMax(moved.high)};
}

}  // namespace lamina
