// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/html.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lamina {
namespace {

TEST(Html, EscapesWhatABrowserWouldTakeForItself) {
  EXPECT_EQ(escapedHtml("<b a=\"1\" c='2'>&amp;"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
  EXPECT_EQ(escapedHtml("100 µm, 5 mm²\n"), "100 µm, 5 mm²\n");
  EXPECT_EQ(escapedHtml(std::string("a\0b\x1b", 4)), "a?b?");
}

TEST(Html, ShowsWhatIsNoUtf8AsQuestionMarks) {
  EXPECT_EQ(escapedHtml("\xff"), "?");
  EXPECT_EQ(escapedHtml("\xc3"), "?");
  EXPECT_EQ(escapedHtml("\xc0\xaf"), "??");
  EXPECT_EQ(escapedHtml("\xed\xa0\x80"), "???");
  EXPECT_EQ(escapedHtml("\xf4\x90\x80\x80"), "????");
  EXPECT_EQ(escapedHtml("\xe2\x82<"), "??&lt;");
}

RC_GTEST_PROP(Html, LeavesNoMarkupInText, (const std::string& text)) {
  const std::string escaped = escapedHtml(text);
  RC_ASSERT(escaped.find_first_of("<>\"'") == std::string::npos);
  RC_ASSERT(escaped.size() >= text.size());
}

TEST(Html, MakesAPageOfTablesAndPictures) {
  HtmlPage page("A & B");
  page.heading("One <two>");
  page.paragraph("three");
  page.table({{"name", "value"}, {{"x", "1.5"}, {"<y>", "none"}}, 1});
  page.table({{"gain_mean"}, {{"2"}}, 1});
  page.table({{"empty"}, {}, 0});
  page.pictures({"foo"}, {"a \"picture\""});
  const std::string text = page.text();
  EXPECT_EQ(text.rfind("<!DOCTYPE html>", 0), 0U);
  for (const char* piece :
       {"<title>A &amp; B</title>", "<h2>One &lt;two&gt;</h2>", "<p>three</p>", "<th>gain_<wbr>mean</th>",
        "<td class=\"number\">1.5</td>", "<td>&lt;y&gt;</td>", "<tr class=\"marked\"><td>x</td>",
        "src=\"data:image/png;base64,Zm9v\"", "alt=\"a &quot;picture&quot;\""})
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
  EXPECT_EQ(text.find("empty"), std::string::npos);
  EXPECT_EQ(text.find("<script"), std::string::npos);
  EXPECT_EQ(text.find("http"), std::string::npos);
}

}  // namespace
}  // namespace lamina
