// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/thumbnail.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/picture/pixel_image.hpp"
#include "picture/toolpath_drawing.hpp"

namespace lamina {
namespace {

constexpr int kSmallestSide = 16;
constexpr int kLargestSide = 2000;
constexpr double kThumbnailMargin = 0.04;  // of the smaller side
constexpr double kSamePixel = 0.4;

[[noreturn]] void refuseThumbnail(std::string_view stated) {
  throw InvalidConfig("program.thumbnails has '" + std::string(stated) +
                      "'; expected sizes from 16 to 2000 pixels with a format, png, qoi or jpg, as \"220x124 "
                      "png, 16x16 qoi\"");
}

int sideFrom(std::string_view digits, std::string_view stated) {
  int side = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), side);
  if (result.ec != std::errc{} || result.ptr != digits.data() + digits.size()) refuseThumbnail(stated);
  if (side < kSmallestSide || side > kLargestSide) refuseThumbnail(stated);
  return side;
}

Thumbnail thumbnailFrom(std::string_view stated) {
  const std::size_t times = stated.find('x');
  const std::size_t space = stated.find(' ');
  if (times == std::string_view::npos || space == std::string_view::npos || space < times)
    refuseThumbnail(stated);
  Thumbnail thumbnail;
  thumbnail.width_px = sideFrom(stated.substr(0, times), stated);
  thumbnail.height_px = sideFrom(stated.substr(times + 1, space - times - 1), stated);
  const std::string_view format = trimmed(stated.substr(space));
  if (format == "png")
    thumbnail.format = ImageFormat::Png;
  else if (format == "qoi")
    thumbnail.format = ImageFormat::Qoi;
  else if (format == "jpg")
    thumbnail.format = ImageFormat::Jpeg;
  else
    refuseThumbnail(stated);
  return thumbnail;
}

bool isInThumbnail(const Path& path) { return path.role != PathRole::Travel && path.role != PathRole::Skirt; }

/// The box of what is shown, from the bottom of the first layer.
Box3 shownBox(const Toolpath& toolpath) {
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (isInThumbnail(path))
        for (const Point3& point : path.points) box.include(point);
  if (box.isEmpty())
    throw InvalidInput("the toolpath of '" + toolpath.part_name + "' deposits nothing to be shown");
  box.low.z() -= toolpath.layers.front().height_mm;
  return box;
}

/// The box as it is seen.
Box2 seenBoxOf(const Projection& projection, const Box3& box) {
  Box2 seen;
  for (int corner = 0; corner < 8; ++corner)
    seen.include(projection({(corner & 1) != 0 ? box.high.x() : box.low.x(),
                             (corner & 2) != 0 ? box.high.y() : box.low.y(),
                             (corner & 4) != 0 ? box.high.z() : box.low.z()}));
  return seen;
}

/// The path through those of its waypoints that are at least so far apart, with one bead.
Path coarsePath(const Path& path, double step_mm) {
  Path coarse;
  coarse.role = path.role;
  coarse.deposit = path.deposit;
  coarse.is_closed = path.is_closed;
  coarse.bead = path.bead.at(path.points.size() / 2);
  coarse.feed_mm_s = path.feed_mm_s.at(0);
  coarse.orientation = path.orientation.at(path.points.size() / 2);
  for (const Point3& point : path.points)
    if (coarse.points.empty() || (point - coarse.points.back()).norm() >= step_mm)
      coarse.points.push_back(point);
  if (coarse.points.size() < 2 || !path.is_closed) coarse.points.push_back(path.points.back());
  return coarse;
}

bool hasTopSkin(const ToolpathLayer& layer) {
  return std::any_of(layer.paths.begin(), layer.paths.end(),
                     [](const Path& path) { return path.role == PathRole::TopSkin; });
}

/// What lies within a part's walls, and is seen only where no skin covers it.
bool isHidden(PathRole role) {
  return role == PathRole::Infill || role == PathRole::Skin || role == PathRole::InnerWall ||
         role == PathRole::GapFill;
}

/// What is shown, without what falls on the same pixels, or is hidden by the layers above.
Toolpath coarseToolpath(const Toolpath& toolpath, double step_mm) {
  Toolpath coarse;
  coarse.part_name = toolpath.part_name;
  coarse.part_from_layers = toolpath.part_from_layers;
  const bool is_closed = std::any_of(toolpath.layers.begin(), toolpath.layers.end(), hasTopSkin);
  double shown_to_mm = -1e300;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    const ToolpathLayer& layer = toolpath.layers[l];
    const bool is_seen = layer.z_mm - shown_to_mm >= step_mm || l + 1 == toolpath.layers.size();
    if (!is_seen) continue;
    shown_to_mm = layer.z_mm;
    coarse.layers.push_back({layer.z_mm, layer.height_mm, {}});
    const bool hides = is_closed && l + 1 < toolpath.layers.size() && !hasTopSkin(layer);
    for (const Path& path : layer.paths)
      if (isInThumbnail(path) && !(hides && isHidden(path.role)))
        coarse.layers.back().paths.push_back(coarsePath(path, step_mm));
  }
  return coarse;
}

}  // namespace

std::vector<Thumbnail> thumbnailsFrom(const std::string& text) {
  std::vector<Thumbnail> thumbnails;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    thumbnails.push_back(thumbnailFrom(trimmed(rest.substr(0, comma))));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return thumbnails;
}

std::string drawThumbnail(const Toolpath& toolpath, const Thumbnail& thumbnail) {
  const Box3 box = shownBox(toolpath);
  const Projection projection(PictureView::Oblique);
  const double border_px = kThumbnailMargin * std::min(thumbnail.width_px, thumbnail.height_px);
  Box2 area;
  area.include({border_px, border_px});
  area.include({thumbnail.width_px - border_px, thumbnail.height_px - border_px});
  Canvas canvas(thumbnail.width_px, thumbnail.height_px);
  canvas.show(seenBoxOf(projection, box), area);
  drawDeposition(canvas, projection, coarseToolpath(toolpath, kSamePixel / canvas.pixelsPerMm()), box,
                 PictureColour::Role);
  if (thumbnail.format == ImageFormat::Png) return canvas.png();
  return thumbnail.format == ImageFormat::Qoi ? qoiFile(canvas.pixels()) : jpegFile(canvas.pixels());
}

}  // namespace lamina
