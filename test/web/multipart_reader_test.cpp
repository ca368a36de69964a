// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/multipart_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

#include "lamina/base/error.hpp"

namespace lamina::test {
namespace {

struct FormPart {
  MultipartHead head;
  std::string bytes;
  bool is_whole = false;
};

std::vector<FormPart> partsOfForm(const std::string& boundary, const std::string& body, std::size_t step) {
  std::vector<FormPart> parts;
  MultipartReader reader(boundary, {[&](const MultipartHead& head) {
                                      parts.push_back({head, "", false});
                                    },
                                    [&](std::string_view piece) { parts.back().bytes += piece; },
                                    [&] { parts.back().is_whole = true; }});
  for (std::size_t at = 0; at < body.size(); at += step) reader.read(std::string_view(body).substr(at, step));
  reader.finish();
  return parts;
}

const char* const kForm =
    "preamble\r\n--b1\r\nContent-Disposition: form-data; name=\"print\"\r\n\r\ntrue\r\n--b1\r\n"
    "content-disposition: form-data; name=\"file\"; filename=\"C:\\a\\part one.gcode\"\r\n"
    "Content-Type: application/octet-stream\r\n\r\nG1 X1\r\n--b\r\n--b2\r\n\r\n--b1\r\n"
    "Content-Disposition: form-data; name=empty\r\n\r\n\r\n--b1--\r\nepilogue";

TEST(MultipartReader, ReadsAFormHoweverItIsSplit) {
  for (std::size_t step = 1; step < 400; step = step < 30 ? step + 1 : step * 2) {
    const auto parts = partsOfForm("b1", kForm, step);
    ASSERT_EQ(parts.size(), 3U) << step;
    EXPECT_EQ(parts[0].head.name, "print");
    EXPECT_FALSE(parts[0].head.filename);
    EXPECT_EQ(parts[0].bytes, "true");
    EXPECT_EQ(parts[1].head.filename, "C:\\a\\part one.gcode");
    EXPECT_EQ(parts[1].bytes, "G1 X1\r\n--b\r\n--b2\r\n");
    EXPECT_EQ(parts[2].head.name, "empty");
    EXPECT_EQ(parts[2].bytes, "");
    EXPECT_TRUE(parts[2].is_whole);
  }
}

TEST(MultipartReader, GivesBackAnyBytes) {
  ASSERT_TRUE(rc::check([](const std::string& bytes) {
    const std::string boundary = "----------------------------0123456789";
    RC_PRE(bytes.find("\r\n--" + boundary) == std::string::npos && bytes.find("--" + boundary) != 0);
    const std::string body = "--" + boundary +
                             "\r\nContent-Disposition: form-data; name=\"f\"; filename=\"x\"\r\n\r\n" +
                             bytes + "\r\n--" + boundary + "--\r\n";
    const auto parts = partsOfForm(boundary, body, *rc::gen::inRange<std::size_t>(1, 100));
    RC_ASSERT(parts.size() == 1U);
    RC_ASSERT(parts[0].bytes == bytes);
  }));
}

TEST(MultipartReader, RefusesWhatIsNoForm) {
  const std::string head = "--b\r\nContent-Disposition: form-data; name=\"f\"\r\n\r\n";
  EXPECT_THROW(partsOfForm("b", head + "cut off", 7), InvalidInput);
  EXPECT_THROW(partsOfForm("b", "no boundary at all", 7), InvalidInput);
  EXPECT_THROW(partsOfForm("b", "--bx\r\n", 7), InvalidInput);
  EXPECT_THROW(partsOfForm("b", "--b\r\nContent-Type: text/plain\r\n\r\nx\r\n--b--", 7), InvalidInput);
  EXPECT_THROW(partsOfForm("b", "--b\r\nX: " + std::string(9000, 'x') + "\r\n\r\n", 512), InvalidInput);
  std::string many;
  for (int i = 0; i < 17; ++i) many += head + "x\r\n";
  EXPECT_THROW(partsOfForm("b", many + "--b--", 64), InvalidInput);
}

TEST(MultipartReader, TakesTheExtendedNameBeforeThePlainOne) {
  const std::string body =
      "--b\r\nContent-Disposition: form-data; name=\"file\"; filename=\"Wuerfel.gcode\"; "
      "filename*=UTF-8''W%C3%BCrfel.gcode\r\n\r\nx\r\n--b--";
  EXPECT_EQ(partsOfForm("b", body, 5).at(0).head.filename, "W\xc3\xbcrfel.gcode");
}

TEST(MultipartReader, FindsTheBoundary) {
  EXPECT_EQ(multipartBoundary("multipart/form-data; boundary=abc"), "abc");
  EXPECT_EQ(multipartBoundary("Multipart/Form-Data; charset=x; Boundary=\"a b\""), "a b");
  EXPECT_FALSE(multipartBoundary("multipart/form-data"));
  EXPECT_FALSE(multipartBoundary("text/plain; boundary=abc"));
  EXPECT_FALSE(multipartBoundary("multipart/form-data; boundary=" + std::string(71, 'b')));
}

TEST(SafeFileName, KeepsWhatCanBeShownAndNothingThatLeadsElsewhere) {
  EXPECT_EQ(safeFileName("part.gcode"), "part.gcode");
  EXPECT_EQ(safeFileName("../../etc/passwd"), "passwd");
  EXPECT_EQ(safeFileName("C:\\temp\\part.gcode"), "part.gcode");
  EXPECT_EQ(safeFileName(".."), "program.gcode");
  EXPECT_EQ(safeFileName(""), "program.gcode");
  EXPECT_EQ(safeFileName(".hidden"), "hidden");
  EXPECT_EQ(safeFileName(std::string("a\0b\n.g", 6)), "a_b_.g");
  EXPECT_EQ(safeFileName("W\xc3\xbcrfel.gcode"), "W\xc3\xbcrfel.gcode");
  EXPECT_EQ(safeFileName("a\xff\xc3"), "a__");
  EXPECT_EQ(safeFileName(std::string(119, 'x') + "\xc3\xbc"), std::string(119, 'x'));
}

}  // namespace
}  // namespace lamina::test
