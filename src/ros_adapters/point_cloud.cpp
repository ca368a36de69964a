// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_cloud.hpp"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>

#include "conversions.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using sensor_msgs::PointField;

std::size_t sizeOf(const PointField& field) {
  return field.datatype == PointField::FLOAT64 ? sizeof(double) : sizeof(float);
}

/// A field of that name that points have.
const PointField& coordinateOf(const sensor_msgs::PointCloud2& cloud, const std::string& name) {
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&name](const PointField& each) { return each.name == name; });
  if (field == cloud.fields.end())
    throw InvalidInput("point cloud has no field '" + name + "'; needs x, y and z");
  if (field->datatype != PointField::FLOAT32 && field->datatype != PointField::FLOAT64)
    throw InvalidInput("field '" + name + "' of the point cloud is of type " +
                       std::to_string(field->datatype) + "; must be FLOAT32 (7) or FLOAT64 (8)");
  if (std::size_t(field->offset) + sizeOf(*field) > cloud.point_step)
    throw InvalidInput("field '" + name + "' of the point cloud lies beyond its point_step of " +
                       std::to_string(cloud.point_step) + " bytes");
  return *field;
}

void checkLayout(const sensor_msgs::PointCloud2& cloud) {
  const std::size_t row = std::size_t(cloud.width) * cloud.point_step;
  const std::size_t needed = cloud.height == 0 ? 0 : std::size_t(cloud.height - 1) * cloud.row_step + row;
  if ((cloud.height > 1 && cloud.row_step < row) || cloud.data.size() < needed)
    throw InvalidInput("point cloud of " + std::to_string(cloud.width) + " x " +
                       std::to_string(cloud.height) + " points has " + std::to_string(cloud.data.size()) +
                       " bytes; needs " + std::to_string(needed));
}

template <class Number>
double numberAt(const std::uint8_t* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Reads the coordinates of a point, whatever their type and the order of their bytes.
class PointReader {
 public:
  /// @throws InvalidInput as `fromMessage`
  explicit PointReader(const sensor_msgs::PointCloud2& cloud)
      : fields_{coordinateOf(cloud, "x"), coordinateOf(cloud, "y"), coordinateOf(cloud, "z")},
        is_swapped_(cloud.is_bigendian != 0) {
    checkLayout(cloud);
  }

  /// @param point  its first byte
  /// @return [m]
  Point3 at(const std::uint8_t* point) const { return {read(point, 0), read(point, 1), read(point, 2)}; }

 private:
  double read(const std::uint8_t* point, std::size_t axis) const {
    const PointField& field = fields_[axis];
    const std::uint8_t* bytes = point + field.offset;
    std::array<std::uint8_t, sizeof(double)> swapped{};
    if (is_swapped_) {
      std::reverse_copy(bytes, bytes + sizeOf(field), swapped.begin());
      bytes = swapped.data();
    }
    return field.datatype == PointField::FLOAT64 ? numberAt<double>(bytes) : numberAt<float>(bytes);
  }

  std::array<PointField, 3> fields_;
  bool is_swapped_;  ///< whether the first byte of a number is its highest
};

sensor_msgs::PointCloud2 emptyCloud(const std::vector<std::string>& fields) {
  sensor_msgs::PointCloud2 cloud;
  for (const std::string& name : fields) {
    PointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += sizeof(float);
  }
  cloud.height = 1;
  return cloud;
}

void appendFloat(sensor_msgs::PointCloud2& cloud, float value) {
  std::uint8_t bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  cloud.data.insert(cloud.data.end(), bytes, bytes + sizeof value);
}

void endPoint(sensor_msgs::PointCloud2& cloud) {
  ++cloud.width;
  cloud.row_step += cloud.point_step;
}

void append(sensor_msgs::PointCloud2& cloud, std::initializer_list<double> millimetres) {
  for (const double value : millimetres) appendFloat(cloud, static_cast<float>(toMetres(value)));
  endPoint(cloud);
}

}  // namespace

std::vector<std::vector<Point3>> profilesFromMessage(const sensor_msgs::PointCloud2& cloud) {
  const PointReader reader(cloud);
  if (cloud.width == 0) return {};  // whatever height it states
  std::vector<std::vector<Point3>> rows(cloud.height);
  for (std::uint32_t row = 0; row < cloud.height; ++row) {
    const std::uint8_t* at = cloud.data.data() + std::size_t(row) * cloud.row_step;
    rows[row].reserve(cloud.width);
    for (std::uint32_t i = 0; i < cloud.width; ++i, at += cloud.point_step)
      rows[row].push_back(reader.at(at) * kMillimetresPerMetre);
  }
  return rows;
}

CloudPoints fromMessage(const sensor_msgs::PointCloud2& cloud, const Eigen::Isometry3d& target_from_cloud) {
  const PointReader reader(cloud);
  CloudPoints result;
  result.points.reserve(std::size_t(cloud.width) * cloud.height);
  for (std::uint32_t row = 0; row < cloud.height; ++row) {
    const std::uint8_t* at = cloud.data.data() + std::size_t(row) * cloud.row_step;
    for (std::uint32_t i = 0; i < cloud.width; ++i, at += cloud.point_step) {
      const Point3 point = reader.at(at) * kMillimetresPerMetre;
      // Drivers send zeros in place of points that they miss: at the origin a sensor sees nothing but itself.
      if (point.allFinite() && !point.isZero(0.0))
        result.points.push_back(target_from_cloud * point);
      else
        ++result.not_finite;
    }
  }
  return result;
}

sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points) {
  return toCloudMessage(points, {});
}

sensor_msgs::PointCloud2 toCloudMessage(const std::vector<Point3>& points,
                                        const std::vector<CloudField>& fields) {
  std::vector<std::string> names{"x", "y", "z"};
  for (const CloudField& field : fields) names.push_back(field.name);
  sensor_msgs::PointCloud2 cloud = emptyCloud(names);
  cloud.is_dense = true;
  cloud.data.reserve(points.size() * cloud.point_step);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double value : points[i]) appendFloat(cloud, static_cast<float>(toMetres(value)));
    for (const CloudField& field : fields) appendFloat(cloud, field.values.at(i));
    endPoint(cloud);
  }
  return cloud;
}

sensor_msgs::PointCloud2 toCloudMessage(const HeightMap& heights, const HeightMap& deviation,
                                        const Eigen::Isometry3d& bed_from_maps) {
  sensor_msgs::PointCloud2 cloud = emptyCloud({"x", "y", "z", "deviation"});
  for (std::size_t cell = 0; cell < heights.grid().cellCount(); ++cell) {
    if (!heights.isKnown(cell)) continue;
    const Point2 centre = heights.grid().centre(cell);
    const Point3 place = bed_from_maps * Point3(centre.x(), centre.y(), heights.at(cell));
    append(cloud, {place.x(), place.y(), place.z(), deviation.at(cell)});
  }
  return cloud;
}

sensor_msgs::Image toImageMessage(const HeightMap& map) {
  const HeightGrid& grid = map.grid();
  sensor_msgs::Image image;
  image.width = static_cast<std::uint32_t>(grid.columns);
  image.height = static_cast<std::uint32_t>(grid.rows);
  image.encoding = sensor_msgs::image_encodings::TYPE_32FC1;
  image.step = static_cast<std::uint32_t>(image.width * sizeof(float));
  image.data.resize(std::size_t(image.step) * image.height);
  std::uint8_t* at = image.data.data();
  for (int row = grid.rows - 1; row >= 0; --row) {
    for (int column = 0; column < grid.columns; ++column, at += sizeof(float)) {
      const auto value = static_cast<float>(toMetres(map.at(grid.cell(column, row))));
      std::memcpy(at, &value, sizeof value);
    }
  }
  return image;
}

}  // namespace lamina
