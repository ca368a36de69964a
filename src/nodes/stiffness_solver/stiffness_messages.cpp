// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness_messages.hpp"

#include <ros/time.h>

#include "conversions.hpp"
#include "lamina/stiffness/surface_points.hpp"
#include "names.hpp"
#include "point_cloud.hpp"

namespace lamina {

lamina_msgs::ComputeStiffnessResult toMessage(const StiffnessResult& result) {
  lamina_msgs::ComputeStiffnessResult message;
  message.force = result.force_n;
  message.modulus = toPascals(result.modulus_mpa);
  message.greatest_stress = toPascals(static_cast<double>(result.greatest_stress_mpa));
  message.elements = static_cast<std::uint64_t>(result.model.lattice.elementCount());
  for (const DroppedPart& part : result.dropped)
    message.elements_left_out += static_cast<std::uint64_t>(part.elements);
  message.iterations = static_cast<std::uint32_t>(result.iterations);
  message.residual = result.residual;
  return message;
}

sensor_msgs::PointCloud2 stiffnessCloud(const StiffnessResult& result) {
  const SurfacePoints surface = surfacePoints(result);
  std::vector<Point3> places;
  std::vector<CloudField> fields{
      {"displacement_x", {}}, {"displacement_y", {}}, {"displacement_z", {}}, {"von_mises", {}}};
  for (std::size_t i = 0; i < surface.place.size(); ++i) {
    places.emplace_back(surface.place[i].cast<double>());
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      fields[static_cast<std::size_t>(axis)].values.push_back(
          static_cast<float>(toMetres(static_cast<double>(surface.displacement[i][axis]))));
    fields[3].values.push_back(static_cast<float>(toPascals(static_cast<double>(surface.von_mises[i]))));
  }
  sensor_msgs::PointCloud2 cloud = toCloudMessage(places, fields);
  cloud.header.stamp = ros::Time::now();
  cloud.header.frame_id = names::kBedFrame;
  return cloud;
}

}  // namespace lamina
