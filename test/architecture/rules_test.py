#!/usr/bin/env python3
"""The architecture checks must find what they are there to find."""
import pathlib
import tempfile
import unittest

import budgets
import include_rule
import live_properties
import one_definition


def tree(files):
    root = pathlib.Path(tempfile.mkdtemp())
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


def faults(files):
    return list(include_rule.faults(tree(files)))


class IncludeRule(unittest.TestCase):
    def test_an_arrow_may_be_followed(self):
        self.assertEqual(faults({"src/core/planning/a.cpp": '#include "lamina/base/error.hpp"\n'}), [])

    def test_against_the_arrow_is_refused(self):
        self.assertEqual(len(faults({"include/lamina/geometry/a.hpp": '#include "lamina/slicing/layer.hpp"\n'})), 1)

    def test_siblings_do_not_meet(self):
        self.assertEqual(len(faults({"src/core/slicing/a.cpp": '#include "lamina/toolpath/toolpath.hpp"\n'})), 1)

    def test_ros_headers_and_generated_messages_are_refused(self):
        for header in ("<ros/ros.h>", "<geometry_msgs/Point.h>", '"lamina/Toolpath.h"', "<tf2_ros/buffer.h>"):
            self.assertEqual(len(faults({"src/core/base/a.cpp": f"#include {header}\n"})), 1, header)

    def test_the_command_line_knows_no_ros(self):
        self.assertEqual(len(faults({"src/cli/a.cpp": "#include <ros/ros.h>\n"})), 1)

    def test_a_folder_outside_the_rule_is_refused(self):
        self.assertEqual(len(faults({"src/core/extras/a.cpp": "\n"})), 1)


class OneDefinition(unittest.TestCase):
    def test_two_types_of_one_name_are_refused(self):
        found = one_definition.faults(tree({"include/a.hpp": "struct Place {\n};\n", "src/b.hpp": "class Place final {\n};\n"}))
        self.assertEqual(len(list(found)), 1)

    def test_a_type_may_be_announced_and_have_parts_elsewhere(self):
        found = one_definition.faults(tree({"include/a.hpp": "class Place {\n};\n",
                                            "src/b.hpp": "class Place;\nclass Place::State {\n};\n"}))
        self.assertEqual(list(found), [])


class LiveProperties(unittest.TestCase):
    def test_a_dropped_result_is_found_by_its_line(self):
        for source in ("TEST(A, B) {\n  rc::check([] {});\n}\n", "f();\nrc::check(\"a\", [] {});\n",
                       "for (;;)\n  rc::check([] {});\n", "// why\n(void)rc::check([] {});\n", "{\n::rc::check(f); }\n",
                       "R\"(\n)\"; rc::check(f);\n", "char quote = '\"';\nrc::check(f);\n", "case 1:\n  rc :: check (f);\n"):
            self.assertEqual(list(live_properties.dropped(source)), [2], source)

    def test_a_used_result_may_stand(self):
        for source in ("EXPECT_TRUE(rc::check([] {}));", "ASSERT_TRUE(\n    rc::check(\"a\", f));", "return rc::check(f);",
                       "const bool holds = rc::check(f);", "if (!rc::check(f)) fail();", "return is_quick ? true : rc::check(f);"):
            self.assertEqual(list(live_properties.dropped(source)), [], source)

    def test_comments_and_literals_are_no_calls(self):
        for source in ("// rc::check(f);", "/* ;\nrc::check(f); */", 'text = "; rc::check(f);";', 'R"(; rc::check(f);)";'):
            self.assertEqual(list(live_properties.dropped(source)), [], source)

    def test_faults_name_file_and_line(self):
        found = list(live_properties.faults(tree({"test/base/a_test.cpp": "void f() {\n  rc::check(g);\n}\n"})))
        self.assertEqual(len(found), 1)
        self.assertIn("test/base/a_test.cpp:2: ", found[0])


class Budgets(unittest.TestCase):
    def test_function_length_counts_from_signature_to_brace(self):
        lines = ["int f(int a) {", "  return a;", "}", "", "void g() {", "}"]
        self.assertEqual(list(budgets.function_lengths(lines)), [(1, 3), (5, 2)])


if __name__ == "__main__":
    unittest.main()
