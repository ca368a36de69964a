// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/svg/svg_reader.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/svg/style_sheet.hpp"
#include "geometry/svg/svg_path.hpp"
#include "geometry/svg/xml_scanner.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/polygon/fill_rule.hpp"

namespace lamina {
namespace {

constexpr double kMmPerInch = 25.4;

void skipSeparators(std::string_view& text) {
  while (!text.empty() && (std::isspace(static_cast<unsigned char>(text[0])) != 0 || text[0] == ','))
    text.remove_prefix(1);
}

/// A number at the beginning of the text, which is taken off it.
std::optional<double> takeNumber(std::string_view& text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return value;
}

/// Column by column.
Eigen::Affine2d affine(const std::array<double, 6>& v) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.linear() << v[0], v[2], v[1], v[3];
  map.translation() << v[4], v[5];
  return map;
}

std::optional<Eigen::Affine2d> rotation(const std::vector<double>& v) {
  if (v.size() != 1 && v.size() != 3) return std::nullopt;
  const Eigen::Vector2d centre = v.size() == 3 ? Eigen::Vector2d(v[1], v[2]) : Eigen::Vector2d(0.0, 0.0);
  return Eigen::Affine2d(Eigen::Translation2d(centre) * Eigen::Rotation2Dd(v[0] * kDegree) *
                         Eigen::Translation2d(-centre));
}

std::optional<Eigen::Affine2d> single(std::string_view name, const std::vector<double>& v) {
  if (name == "matrix" && v.size() == 6) return affine({v[0], v[1], v[2], v[3], v[4], v[5]});
  if (name == "translate" && (v.size() == 1 || v.size() == 2))
    return affine({1.0, 0.0, 0.0, 1.0, v[0], v.size() == 2 ? v[1] : 0.0});
  if (name == "scale" && (v.size() == 1 || v.size() == 2))
    return affine({v[0], 0.0, 0.0, v.size() == 2 ? v[1] : v[0], 0.0, 0.0});
  if (name == "rotate") return rotation(v);
  if (name == "skewX" && v.size() == 1) return affine({1.0, 0.0, std::tan(v[0] * kDegree), 1.0, 0.0, 0.0});
  if (name == "skewY" && v.size() == 1) return affine({1.0, std::tan(v[0] * kDegree), 0.0, 1.0, 0.0, 0.0});
  return std::nullopt;
}

/// The numbers of a text, with blanks or commas between them or where a sign or a second point begins the
/// next; nothing if something is no number.
std::optional<std::vector<double>> svgNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::optional<double> number = takeNumber(text);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// A `transform` of SVG: matrix, translate, scale, rotate, skewX, skewY, the first one outermost. Nothing if
/// it is none.
std::optional<Eigen::Affine2d> svgTransform(std::string_view text) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::size_t open = text.find('(');
    const std::size_t close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return std::nullopt;
    const auto numbers = svgNumbers(text.substr(open + 1, close - open - 1));
    const auto next = numbers ? single(trimmed(text.substr(0, open)), *numbers) : std::nullopt;
    if (!next) return std::nullopt;
    map = map * *next;
    text.remove_prefix(close + 1);
  }
  return map;
}

/// How many millimetres a length of SVG is: "20mm", "96" (pixels), "1in", "2.5cm", "72pt", "6pc". Nothing if
/// it is none, or a share of something.
std::optional<double> svgLength(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"", kMmPerInch / 96.0},
                                                                          {"px", kMmPerInch / 96.0},
                                                                          {"mm", 1.0},
                                                                          {"cm", 10.0},
                                                                          {"in", kMmPerInch},
                                                                          {"pt", kMmPerInch / 72.0},
                                                                          {"pc", kMmPerInch / 6.0}}};
  text = trimmed(text);
  const std::optional<double> value = takeNumber(text);
  if (!value) return std::nullopt;
  for (const auto& [name, mm] : kUnits)
    if (trimmed(text) == name) return *value * mm;
  return std::nullopt;
}

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

/// Reads elements one after the other; a stack holds what they hand down.
class SvgDocument {
 public:
  SvgDocument(std::string_view text, const std::string& name)
      : scanner_(text, name), styles_(text), name_(name) {}

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
  /// By its attribute, or by the rules of style sheets, which count more, or by its own style, which counts
  /// most.
  std::string property(const XmlTag& tag, const std::string& key) const {
    std::string own = declaredIn(tag.attribute("style"), key);
    if (!own.empty()) return own;
    std::string of_sheet = styles_.property(tag.name, tag.attribute("class"), key);
    return of_sheet.empty() ? tag.attribute(key) : of_sheet;
  }

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
    const std::string fill = property(tag, "fill");
    if (!fill.empty() && fill != "inherit") context.is_filled = fill != "none";
    const std::string rule = property(tag, "fill-rule");
    if (!rule.empty()) context.rule = rule == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    const std::string visibility = property(tag, "visibility");
    if (property(tag, "display") == "none" || isOneOf(kUndrawn, tag.name) || visibility == "hidden")
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
  StyleSheet styles_;
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
