// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/svg/svg_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/mesh/extrusion.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kFlat = 0.005;  // mm: promised distance of curves

std::string pageOf(const std::string& content) {
  return "<?xml version='1.0'?>\n<!-- a < b -->\n<svg xmlns='http://www.w3.org/2000/svg' width='40mm' "
         "height='40mm' "
         "viewBox='0 0 40 40'>" +
         content + "</svg>\n";
}

Regions read(const std::string& content) { return readSvg(pageOf(content), "page.svg"); }

/// Whether no point of one is farther than `off_mm` from the other.
bool isWithin(const Regions& one, const Regions& other, double off_mm) {
  return difference(one, offset(other, off_mm)).empty() && difference(other, offset(one, off_mm)).empty();
}

/// 20 mm square from (10, 10) with a round hole of radius 5 mm in its middle.
Regions expectedPlate() {
  Region region;
  region.outer = {{10, 10}, {30, 10}, {30, 30}, {10, 30}};
  Polygon hole;
  for (int i = 0; i < 3600; ++i)
    hole.emplace_back(20 + 5 * std::cos(-i * M_PI / 1800), 20 + 5 * std::sin(-i * M_PI / 1800));
  region.holes = {hole};
  return {region};
}

struct Drawing {
  const char* name;
  std::string svg;
};

class SvgPlate : public testing::TestWithParam<Drawing> {};

TEST_P(SvgPlate, IsTheSameHoweverItIsDrawn) {
  const Regions plate = readSvg(GetParam().svg, "plate.svg");
  ASSERT_EQ(plate.size(), 1U);
  EXPECT_EQ(plate[0].holes.size(), 1U);
  EXPECT_NEAR(area(plate), 400.0 - 25.0 * M_PI, kFlat * 10.0 * M_PI);
  EXPECT_TRUE(isWithin(plate, expectedPlate(), 0.01));
}

constexpr char kHoleByArcs[] = "M10 10h20v20H10z M25 20a5 5 0 0 1-10 0 5 5 0 0110 0z";

INSTANTIATE_TEST_SUITE_P(
    Each, SvgPlate,
    testing::Values(
        Drawing{"Millimetres", pageOf(std::string("<path fill-rule='evenodd' d='") + kHoleByArcs + "'/>")},
        Drawing{"NonZero",
                pageOf("<path d='M10,10 30,10 30,30 10,30z M20,15A5,5,0,0,0,20,25A5,5,0,0,0,20,15'/>")},
        Drawing{"Pixels",
                "<svg width='151.18110236220472' height='151.18110236220472px'><g "
                "transform='scale(3.7795275590551181)'>"
                "<path style='fill:#000;fill-rule:evenodd' d='" +
                    std::string(kHoleByArcs) + "'/></g></svg>"},
        Drawing{"Inches",
                "<svg width='1.5748031496062993in' height='4cm' viewBox='100 -50 80 80'><g "
                "transform='translate(100,-50)'>"
                "<g transform='matrix(2 0 0 2 0 0)'><path fill-rule='evenodd' d='" +
                    std::string(kHoleByArcs) + "'/></g></g></svg>"},
        Drawing{
            "Turned",
            pageOf("<g transform='rotate(90 20 20) translate(40) scale(-1 1)'><path fill-rule='evenodd' d='" +
                   std::string(kHoleByArcs) + "'/></g>")},
        Drawing{
            "Curves",
            pageOf(
                "<path fill-rule='evenodd' d='M30 30L10 30 10 10 30 10Z"
                "m-5-10c0 2.7614237-2.2385763 5-5 5s-5-2.2385763-5-5s2.2385763-5 5-5s5 2.2385763 5 5'/>")}),
    [](const auto& each) { return each.param.name; });

TEST(SvgReader, KnowsTheShapes) {
  EXPECT_NEAR(area(read("<rect x='1' y='2' width='3' height='4'/>")), 12.0, 1e-6);
  EXPECT_NEAR(area(read("<rect x='1' y='2' width='10' height='8' rx='2'/>")), 80.0 - (4.0 - M_PI) * 4.0,
              kFlat * 4.0 * M_PI);
  EXPECT_NEAR(area(read("<circle cx='20' cy='20' r='10'/>")), 100.0 * M_PI, kFlat * 20.0 * M_PI);
  EXPECT_NEAR(area(read("<ellipse cx='20' cy='20' rx='10' ry='5'/>")), 50.0 * M_PI, kFlat * 20.0 * M_PI);
  EXPECT_NEAR(area(read("<polygon points='0,0 10,0 10,10'/>")), 50.0, 1e-6);
  EXPECT_NEAR(area(read("<path d='M0 0Q10 20 20 0z'/>")), 2.0 / 3.0 * 20.0 * 10.0, 0.1);
}

TEST(SvgReader, TurnsThePageSoThatUpIsUp) {
  const Box2 box = boundingBox(outlines(read("<rect x='1' y='2' width='3' height='4'/>")));
  EXPECT_NEAR(box.low.x(), 1.0, 1e-6);
  EXPECT_NEAR(box.low.y(), 40.0 - 6.0, 1e-6);
  EXPECT_NEAR(box.high.y(), 38.0, 1e-6);
}

TEST(SvgReader, LeavesOutWhatIsNotFilledOrNotShown) {
  const std::string square = "<rect x='0' y='0' width='2' height='2'/>";
  for (const char* other :
       {"<rect fill='none' x='9' y='9' width='5' height='5'/>",
        "<g style='display: none'><rect x='9' y='9' width='5' height='5'/></g>",
        "<defs><rect x='9' y='9' width='5' height='5'/></defs>", "<line x1='0' y1='0' x2='9' y2='9'/>"})
    EXPECT_NEAR(area(read(square + other)), 4.0, 1e-6) << other;
}

/// Drawing programs write the properties of shapes into a style sheet.
TEST(SvgReader, TakesStyleSheetsForClassesAndElements) {
  const auto areaOf = [](const std::string& css, const std::string& shapes) {
    return area(read("<style>" + css + "</style>" + shapes));
  };
  const std::string two =
      "<rect class='a' width='2' height='3'/><rect class='b c' x='5' width='4' height='1'/>";
  EXPECT_NEAR(areaOf("", two), 10.0, 1e-6);
  EXPECT_NEAR(areaOf(".b { fill: none; stroke: #000 }", two), 6.0, 1e-6);
  EXPECT_NEAR(areaOf("<![CDATA[/* .a{fill:none} */ .x, .c{display:none}]]>", two), 6.0, 1e-6);
  EXPECT_NEAR(areaOf("rect{fill:none}.a{fill:red}", two), 6.0, 1e-6) << "a class counts more than an element";
  EXPECT_NEAR(areaOf(".a{fill:none}.a{fill:red}", two), 10.0, 1e-6) << "of two rules the last";
  EXPECT_NEAR(areaOf(".a{fill:none}", "<rect class='a' style='fill:red' width='2' height='3'/>"), 6.0, 1e-6);
  EXPECT_NEAR(areaOf(".a{fill:none", two), 4.0, 1e-6) << "a rule without its end";
  EXPECT_NEAR(areaOf(".a{fill:none !important;stroke:red}", two), 4.0, 1e-6);
  EXPECT_NEAR(areaOf("@import url(a.css); .a{fill:none}", two), 4.0, 1e-6);
  EXPECT_NEAR(areaOf(".a{fill:none}", "<rect class='x\n\ta' width='2' height='3'/>" + two), 4.0, 1e-6);
}

TEST(SvgReader, TakesNoStyleSheetThatIsEmptyOrWithinAComment) {
  const std::string rect = "<rect class='a' width='2' height='3'/>";
  EXPECT_NEAR(area(read("<!-- <style>.a{fill:none}</style> -->" + rect)), 6.0, 1e-6);
  EXPECT_NEAR(
      area(read("<style id='s'/>" + rect + "<style>.a{fill:none}</style>" + "<rect width='1' height='1'/>")),
      1.0, 1e-6)
      << "a sheet without text ends where it begins";
}

TEST(SvgReader, RefusesWhatItCannotTakeNamingTheLine) {
  for (const std::string& bad :
       {std::string("<svg viewBox='0 0 1 1'><rect width='1' height='1'/></svg>"),
        std::string("<html></html>"), std::string(""), pageOf("<text>A</text>"), pageOf("<use href='#a'/>"),
        pageOf("<path d='M0 0 L1'/>"), pageOf("<path d='L1 1'/>"), pageOf("<rect width='1%' height='1'/>"),
        pageOf("<g transform='turn(3)'/>"), pageOf("<g>"), pageOf("<polygon points='1 2 3'/>"),
        pageOf("<line x2='5'/>"), std::string("<svg width='10mm' height='10mm'")}) {
    try {
      readSvg(bad, "bad.svg");
      ADD_FAILURE() << "accepted: " << bad;
    } catch (const InvalidMesh& error) {
      EXPECT_EQ(std::string(error.what()).rfind("bad.svg:", 0), 0U) << error.what();
    }
  }
}

TEST(SvgReader, ReadsOrRefusesAnyMutatedText) {
  const std::string page = pageOf("<g transform='rotate(30)'><path style='fill-rule:evenodd' d='" +
                                  std::string(kHoleByArcs) + "c1 2 3 4 5 6s1 2 3 4q1 2 3 4t5 6'/></g>");
  Random random(1);
  int read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = page;
    for (int change = 0; change < 3; ++change)
      text[static_cast<std::size_t>(random.below(text.size()))] =
          page[static_cast<std::size_t>(random.below(page.size()))];
    try {
      readSvg(text, "mutated.svg");
      ++read;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(read, 100);
}

TEST(Extrusion, IsAClosedPrism) {
  const Regions plate =
      read("<path fill-rule='evenodd' d='" + std::string(kHoleByArcs) + "'/><circle cx='5' cy='5' r='4'/>");
  const Mesh mesh = extruded(plate, 3.0);
  EXPECT_NEAR(volume(mesh), 3.0 * area(plate), 1e-6);
  EXPECT_FALSE(pairHalfEdges(mesh).has_border);
  EXPECT_TRUE(extruded({}, 3.0).triangles.empty());
}

}  // namespace
}  // namespace lamina
