// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "height_topics.hpp"

#include "conversions.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"

#ifdef LAMINA_HAS_OCTOMAP_MSGS
#include <octomap/OcTree.h>
#include <octomap_msgs/conversions.h>

#include "lamina/monitoring/octree_export.hpp"
#endif

namespace lamina {
namespace {

constexpr std::uint32_t kNoBound = 0;  // of a queue: no report is left out

template <class Message>
void publishOnBed(const ros::Publisher& publisher, Message message) {
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kBedFrame;
  publishLatched(publisher, message);
}

std::uint8_t sightOf(LayerSight sight) {
  switch (sight) {
    case LayerSight::Seen:
      return lamina_msgs::LayerHeight::SEEN;
    case LayerSight::CutShort:
      return lamina_msgs::LayerHeight::CUT_SHORT;
    case LayerSight::NotSeen:
      break;
  }
  return lamina_msgs::LayerHeight::NOT_SEEN;
}

#ifdef LAMINA_HAS_OCTOMAP_MSGS
ros::Publisher advertiseOctomap(ros::NodeHandle& node) {
  return node.advertise<octomap_msgs::Octomap>(names::kHeightOctomap, 1, true);
}

void publishOctomap(const ros::Publisher& publisher, const HeightMap& heights,
                    const Eigen::Isometry3d& bed_from_heights) {
  octomap_msgs::Octomap message;
  if (octomap_msgs::binaryMapToMsg(*octreeOf(heights, kMetresPerMillimetre, bed_from_heights), message))
    publishOnBed(publisher, message);
}
#else
ros::Publisher advertiseOctomap(ros::NodeHandle&) { return {}; }
void publishOctomap(const ros::Publisher&, const HeightMap&, const Eigen::Isometry3d&) {}
#endif

}  // namespace

HeightTopics::HeightTopics(ros::NodeHandle node)
    : measuring_(node.advertise<lamina_msgs::Measuring>(names::kMeasuring, 1, true)),
      layer_height_(node.advertise<lamina_msgs::LayerHeight>(names::kLayerHeight, kNoBound, true)),
      height_map_{node.advertise<sensor_msgs::PointCloud2>(names::kHeightMap, 1, true)},
      deviation_{node.advertise<sensor_msgs::Image>(names::kHeightDeviation, 1, true)},
      octomap_{advertiseOctomap(node)} {}

lamina_msgs::LayerHeight toMessage(const LayerHeightReport& report, const std::string& toolpath_id,
                                   const lamina_msgs::ProfileCounts& counts) {
  lamina_msgs::LayerHeight message;
  message.toolpath_id = toolpath_id;
  message.layer = static_cast<std::uint32_t>(report.layer);
  message.expected_height = toMetres(report.expected_height_mm);
  message.mean_error = toMetres(report.statistics.mean_mm);
  message.rms_error = toMetres(report.statistics.rms_mm);
  message.worst_error = toMetres(report.statistics.worst_mm);
  message.coverage = report.statistics.coverage;
  message.cells = static_cast<std::uint32_t>(report.statistics.cells);
  message.sight = sightOf(report.sight);
  message.profiles = static_cast<std::uint32_t>(report.profiles);
  message.counts = counts;
  return message;
}

void HeightTopics::publish(const LayerHeightReport& report, const std::string& toolpath_id,
                           const lamina_msgs::ProfileCounts& counts) {
  publishOnBed(layer_height_, toMessage(report, toolpath_id, counts));
}

void HeightTopics::publishMeasuring(const std::string& toolpath_id, const ros::Time& toolpath_stamp) {
  lamina_msgs::Measuring message;
  message.toolpath_id = toolpath_id;
  message.toolpath_stamp = toolpath_stamp;
  publishOnBed(measuring_, message);
}

bool HeightTopics::MapTopic::take() {
  const bool was_awaited = isAwaited();
  if (was_awaited) is_outdated = false;
  return was_awaited;
}

void HeightTopics::outdateMaps() {
  for (MapTopic* map : {&height_map_, &deviation_, &octomap_}) map->is_outdated = true;
}

bool HeightTopics::areMapsAwaited() const {
  return height_map_.isAwaited() || deviation_.isAwaited() || octomap_.isAwaited();
}

void HeightTopics::publishMaps(const HeightMonitor& monitor) {
  if (height_map_.isAwaited() || octomap_.isAwaited()) {
    const HeightMap heights = monitor.measured().heights();
    if (height_map_.take())
      publishOnBed(height_map_.publisher,
                   toCloudMessage(heights, monitor.deviation(), monitor.bedFromHeights()));
    if (octomap_.take()) publishOctomap(octomap_.publisher, heights, monitor.bedFromHeights());
  }
  if (deviation_.take()) publishOnBed(deviation_.publisher, toImageMessage(monitor.deviation()));
}

}  // namespace lamina
