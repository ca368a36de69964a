// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/svg/svg_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/svg/svg_path.hpp"
#include "geometry/svg/svg_transform.hpp"
#include "geometry/svg/xml_scanner.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/polygon/fill_rule.hpp"

namespace lamina {
namespace {

/// What elements hand down to those within them.
struct SvgContext {
  Eigen::Affine2d mm_from_user = Eigen::Affine2d::Identity();
  bool is_filled = true;
  bool is_shown = true;
  FillRule rule = FillRule::NonZero;
};

/// What is in them is drawn only where something refers to it, or not at all.
constexpr std::array<const char*, 12> kUndrawn = {"defs",    "symbol", "clipPath",  "mask",
                                                  "pattern", "marker", "metadata",  "title",
                                                  "desc",    "style",  "namedview", "script"};
constexpr std::array<const char*, 6> kRefused = {"text", "image", "use", "foreignObject", "svg", "switch"};

template <std::size_t n>
bool isOneOf(const std::array<const char*, n>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* each) { return name == each; });
}

/// A property by its attribute, or by the style, which counts more.
std::string propertyOf(const XmlTag& tag, const std::string& key) {
  const std::string style = tag.attribute("style");
  for (std::string_view rest = style; !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view each = rest.substr(0, end);
    const std::size_t colon = std::min(each.find(':'), each.size());
    if (trimmed(each.substr(0, colon)) == key)
      return std::string(trimmed(each.substr(std::min(colon + 1, each.size()))));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return tag.attribute(key);
}

/// Reads elements one after the other; a stack holds what they hand down.
class SvgDocument {
 public:
  SvgDocument(std::string_view text, const std::string& name) : scanner_(text, name), name_(name) {}

  Regions read() {
    XmlTag tag;
    if (!scanner_.next(tag) || tag.name != "svg")
      scanner_.refuse(tag.line, "no SVG; expected the element 'svg'");
    contexts_.push_back(within(page(tag), tag));
    std::vector<std::string> open = {tag.name};
    while (!open.empty() && scanner_.next(tag)) {
      if (tag.is_end) {
        if (tag.name != open.back())
          scanner_.refuse(tag.line, "'" + tag.name + "' ends; expected '" + open.back() + "' to");
        open.pop_back();
        contexts_.pop_back();
        continue;
      }
      const SvgContext context = within(contexts_.back(), tag);
      draw(tag, context);
      if (tag.is_empty) continue;
      contexts_.push_back(context);
      open.push_back(tag.name);
    }
    if (!open.empty()) scanner_.refuse(tag.line, "'" + open.back() + "' is not closed");
    Regions regions = enclosed(drawn_, FillRule::NonZero);
    if (regions.empty())
      throw InvalidMesh(name_ + ": fills nothing" +
                        (strokes_ > 0 ? "; " + std::to_string(strokes_) + " strokes have no area" : "") +
                        "; expected shapes with a fill");
    return regions;
  }

 private:
  double lengthOf(const XmlTag& tag, const std::string& key) {
    const std::string text = tag.attribute(key);
    if (text.empty()) return 0.0;
    // In an element the unit of a bare number is that of its coordinates.
    const auto bare = svgNumbers(text);
    if (bare && bare->size() == 1) return bare->front();
    const std::optional<double> mm = svgLength(text);
    if (!mm) scanner_.refuse(tag.line, key + " is '" + text + "'; expected a length");
    return *mm / *svgLength("1");
  }

  /// From user units to millimetres, y up from the lower edge of the page.
  SvgContext page(const XmlTag& tag) {
    const std::optional<double> width = svgLength(tag.attribute("width"));
    const std::optional<double> height = svgLength(tag.attribute("height"));
    if (!width || !height || !(*width > 0.0) || !(*height > 0.0))
      scanner_.refuse(tag.line, "the page has no size; expected width and height, as \"20mm\"");
    Point2 scale(*svgLength("1"), *svgLength("1"));
    Point2 shift(0.0, 0.0);
    const std::string box_text = tag.attribute("viewBox");
    if (!box_text.empty()) {
      const auto box = svgNumbers(box_text);
      if (!box || box->size() != 4 || !((*box)[2] > 0.0) || !((*box)[3] > 0.0))
        scanner_.refuse(tag.line, "viewBox is '" + box_text + "'; expected x, y, width and height");
      scale = {*width / (*box)[2], *height / (*box)[3]};
      // Any other aspect than none keeps that of the drawing, in the middle of the page.
      if (tag.attribute("preserveAspectRatio").substr(0, 4) != "none") scale.setConstant(scale.minCoeff());
      const Point2 drawn = scale.cwiseProduct(Point2((*box)[2], (*box)[3]));
      shift = 0.5 * (Point2(*width, *height) - drawn) - scale.cwiseProduct(Point2((*box)[0], (*box)[1]));
    }
    SvgContext context;
    context.mm_from_user.linear() << scale.x(), 0.0, 0.0, -scale.y();
    context.mm_from_user.translation() << shift.x(), *height - shift.y();
    return context;
  }

  SvgContext within(SvgContext context, const XmlTag& tag) {
    const std::string transform = tag.name == "svg" ? "" : tag.attribute("transform");
    if (!transform.empty()) {
      const auto map = svgTransform(transform);
      if (!map) scanner_.refuse(tag.line, "transform is '" + transform + "'; expected transforms of SVG");
      context.mm_from_user = context.mm_from_user * *map;
    }
    const std::string fill = propertyOf(tag, "fill");
    if (!fill.empty() && fill != "inherit") context.is_filled = fill != "none";
    const std::string rule = propertyOf(tag, "fill-rule");
    if (!rule.empty()) context.rule = rule == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    const std::string visibility = propertyOf(tag, "visibility");
    if (propertyOf(tag, "display") == "none" || isOneOf(kUndrawn, tag.name) || visibility == "hidden")
      context.is_shown = false;
    return context;
  }

  void draw(const XmlTag& tag, const SvgContext& context) {
    if (!context.is_shown) return;
    if (isOneOf(kRefused, tag.name))
      scanner_.refuse(tag.line, "'" + tag.name + "' is no outline; expected paths and shapes");
    if (tag.name == "line") ++strokes_;
    std::vector<Polygon> outlines = outlinesOf(tag, context.mm_from_user);
    if (!context.is_filled && !outlines.empty()) ++strokes_;
    if (!context.is_filled || outlines.empty()) return;
    for (const Region& region : enclosed(outlines, context.rule)) {
      drawn_.push_back(region.outer);
      drawn_.insert(drawn_.end(), region.holes.begin(), region.holes.end());
    }
  }

  std::vector<Polygon> outlinesOf(const XmlTag& tag, const Eigen::Affine2d& map) {
    if (tag.name == "path") return pathOf(tag, map);
    if (tag.name == "rect") return rectangleOf(tag, map);
    if (tag.name == "circle") {
      const double radius = lengthOf(tag, "r");
      return ellipseOf({{lengthOf(tag, "cx"), lengthOf(tag, "cy")}, {radius, radius}}, map);
    }
    if (tag.name == "ellipse")
      return ellipseOf(
          {{lengthOf(tag, "cx"), lengthOf(tag, "cy")}, {lengthOf(tag, "rx"), lengthOf(tag, "ry")}}, map);
    if (tag.name == "polygon" || tag.name == "polyline") return polygonOf(tag, map);
    return {};
  }

  std::vector<Polygon> pathOf(const XmlTag& tag, const Eigen::Affine2d& map) {
    auto outlines = svgPath(tag.attribute("d"), map);
    if (!outlines) scanner_.refuse(tag.line, "the data of a path ('d') are none of SVG");
    return std::move(*outlines);
  }

  std::vector<Polygon> polygonOf(const XmlTag& tag, const Eigen::Affine2d& map) {
    const auto numbers = svgNumbers(tag.attribute("points"));
    if (!numbers || numbers->size() % 2 != 0) scanner_.refuse(tag.line, "points are no pairs of numbers");
    SvgPen pen(map);
    for (std::size_t i = 0; i + 1 < numbers->size(); i += 2) {
      const Point2 point((*numbers)[i], (*numbers)[i + 1]);
      i == 0 ? pen.moveTo(point) : pen.lineTo(point);
    }
    return std::move(pen).finish();
  }

  static std::vector<Polygon> ellipseOf(const SvgEllipse& ellipse, const Eigen::Affine2d& map) {
    if (!(ellipse.radii.minCoeff() > 0.0)) return {};
    SvgPen pen(map);
    pen.moveTo(ellipse.centre + Point2(ellipse.radii.x(), 0.0));
    pen.ellipticTo(ellipse, 0.0, 2.0 * M_PI);
    return std::move(pen).finish();
  }

  std::vector<Polygon> rectangleOf(const XmlTag& tag, const Eigen::Affine2d& map) {
    const Point2 low(lengthOf(tag, "x"), lengthOf(tag, "y"));
    const Point2 size(lengthOf(tag, "width"), lengthOf(tag, "height"));
    if (!(size.minCoeff() > 0.0)) return {};
    double rx = lengthOf(tag, "rx");
    double ry = lengthOf(tag, "ry");
    if (rx == 0.0) rx = ry;
    if (ry == 0.0) ry = rx;
    const Point2 radii(std::min(rx, 0.5 * size.x()), std::min(ry, 0.5 * size.y()));
    const Point2 high = low + size;
    SvgPen pen(map);
    pen.moveTo({low.x() + radii.x(), low.y()});
    const auto corner = [&](double x, double y, double begin_rad) {
      if (radii.minCoeff() > 0.0) return pen.ellipticTo({{x, y}, radii}, begin_rad, begin_rad + 0.5 * M_PI);
      pen.lineTo({x, y});
    };
    corner(high.x() - radii.x(), low.y() + radii.y(), -0.5 * M_PI);
    corner(high.x() - radii.x(), high.y() - radii.y(), 0.0);
    corner(low.x() + radii.x(), high.y() - radii.y(), 0.5 * M_PI);
    corner(low.x() + radii.x(), low.y() + radii.y(), M_PI);
    return std::move(pen).finish();
  }

  XmlScanner scanner_;
  std::string name_;
  std::vector<SvgContext> contexts_;
  std::vector<Polygon> drawn_;
  std::size_t strokes_ = 0;
};

}  // namespace

bool isSvgName(const std::string& name) {
  constexpr std::string_view kSuffix = ".svg";
  if (name.size() < kSuffix.size()) return false;
  std::string end = name.substr(name.size() - kSuffix.size());
  std::transform(end.begin(), end.end(), end.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return end == kSuffix;
}

Regions readSvg(std::string_view text, const std::string& name) { return SvgDocument(text, name).read(); }

}  // namespace lamina
