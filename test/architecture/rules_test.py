#!/usr/bin/env python3
"""The architecture checks must find what they are there to find."""
import pathlib
import subprocess
import tempfile
import unittest

import anonymous_names
import budgets
import docs_links
import equal_functions
import include_rule
import interfaces
import live_properties
import one_definition
import one_source
import references
import scratch_files
import settings_coverage
import suites_of_rostests


def tree(files):
    root = pathlib.Path(tempfile.mkdtemp())
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


def repository(files):
    root = tree(files)
    for command in (["init", "--quiet"], ["add", "--all"]):
        subprocess.run(["git", "-C", root, *command], check=True)
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

    def test_nested_folders_keep_the_rule_of_the_folder_around_them(self):
        nested = {"include/lamina/geometry/mesh/a.hpp": '#include "lamina/slicing/planar/layer.hpp"\n'}
        self.assertEqual(len(faults(nested)), 1)
        self.assertEqual(faults({"src/core/slicing/planar/a.cpp": '#include "lamina/geometry/mesh/mesh.hpp"\n'}), [])

    def test_nested_folders_may_have_rules_of_their_own(self):
        sibling = {"src/core/streaming/transport/a.cpp": '#include "lamina/streaming/session/streamer.hpp"\n'}
        self.assertEqual(len(faults(sibling)), 1)

    def test_ros_headers_and_generated_messages_are_refused(self):
        for header in ("<ros/ros.h>", "<geometry_msgs/Point.h>", '"lamina/Toolpath.h"', "<tf2_ros/buffer.h>"):
            self.assertEqual(len(faults({"src/core/base/a.cpp": f"#include {header}\n"})), 1, header)

    def test_the_command_line_knows_no_ros(self):
        self.assertEqual(len(faults({"src/cli/a.cpp": "#include <ros/ros.h>\n"})), 1)

    def test_a_folder_outside_the_rule_is_refused(self):
        self.assertEqual(len(faults({"src/core/extras/a.cpp": "\n"})), 1)


class Interfaces(unittest.TestCase):
    def found(self, files, gaps=None):
        return list(interfaces.faults(tree(files), gaps or {}))

    def test_an_option_stands_in_a_test(self):
        option = {"src/cli/a.cpp": 'add_flag("-s,--strict", x);\n'}
        self.assertEqual(len(self.found(option)), 1)
        self.assertEqual(len(self.found({**option, "test/cli/a.py": 'run("--stricter")\n'})), 1)
        self.assertEqual(self.found({**option, "test/cli/a.py": 'run("--strict")\n'}), [])

    def test_a_launch_file_is_started_and_passes_its_arguments_on(self):
        launch = {"launch/a.launch": '<arg name="rate" default="1"/>\n', "tools/demo": "roslaunch a.launch\n"}
        self.assertEqual(len(self.found(launch)), 1)
        launch["launch/a.launch"] += '<param name="rate" value="$(arg rate)"/>\n'
        self.assertEqual(self.found(launch), [])
        del launch["tools/demo"]
        self.assertEqual(len(self.found(launch)), 1)

    def test_a_launch_file_keeps_nodes_of_others_on_the_loopback_interface(self):
        launch = {"launch/a.launch": '<node name="a" pkg="lamina" type="a"/>\n', "tools/demo": "roslaunch a.launch\n"}
        self.assertEqual(self.found(launch), [])
        launch["launch/a.launch"] += '<node name="b" pkg="rviz" type="rviz"/>\n'
        self.assertEqual(len(self.found(launch)), 1)
        launch["launch/a.launch"] += '<env name="ROS_IP" value="127.0.0.1"/>\n'
        self.assertEqual(self.found(launch), [])

    def test_a_launch_file_passes_texts_on_as_texts(self):
        files = {"config/a.yaml": "# Of a.\ndisk:\n  # Which?\n  least_gib: 2\n  folder: .\nport: 1e-3\nname: \"\"\n", "tools/demo": "a.launch\n",
                 "launch/a.launch": '<arg name="b" default=""/>\n<param name="a/disk/folder" value="$(arg b)"/>\n<node name="a" pkg="lamina" type="a">\n'
                                    '<param name="disk/least_gib" value="$(arg b)"/>\n<param name="port" value="$(arg b)"/>\n'
                                    '<param if="$(eval b)" name="name" value="$(arg b)"/>\n</node>\n'}
        self.assertEqual(len(self.found(files)), 2)
        files["launch/a.launch"] = files["launch/a.launch"].replace(' value="$(', ' type="str" value="$(')
        self.assertEqual(self.found(files), [])

    def test_a_topic_has_a_node_and_a_test(self):
        topic = {"src/ros_adapters/names.hpp": 'inline constexpr char kHeat[] = "heat";\n'}
        self.assertEqual(len(self.found(topic)), 2)
        self.assertEqual(self.found({**topic, "src/nodes/a.cpp": "names::kHeat", "test/ros/a.cpp": '"heat"'}), [])

    def test_a_field_is_filled_and_read(self):
        field = {"msg/A.msg": "uint8 OFF=0\nfloat64 heat  # [J]\n", "src/nodes/a.cpp": "a.heat = 1;\n"}
        self.assertEqual(len(self.found(field)), 1)
        self.assertEqual(self.found({**field, "test/ros/a.cpp": "EXPECT_EQ(a->heat, 1);\n"}), [])

    def test_a_gap_that_is_closed_is_named(self):
        self.assertEqual(len(self.found({}, {"kHeat": "no test"})), 1)


class OneDefinition(unittest.TestCase):
    def test_two_types_of_one_name_are_refused(self):
        found = one_definition.faults(tree({"include/a.hpp": "struct Place {\n};\n", "src/b.hpp": "class Place final {\n};\n"}))
        self.assertEqual(len(list(found)), 1)

    def test_a_type_of_one_line_is_a_type(self):
        found = one_definition.faults(tree({"include/a.hpp": "enum class Ends { Open, Closed };\n",
                                            "src/b.hpp": "enum class Ends : std::uint8_t { Joined };\n"}))
        self.assertEqual(len(list(found)), 1)

    def test_a_type_may_be_announced_and_have_parts_elsewhere(self):
        found = one_definition.faults(tree({"include/a.hpp": "class Place {\n};\n",
                                            "src/b.hpp": "class Place;\nenum class Place : int;\nclass Place::State {\n};\n"}))
        self.assertEqual(list(found), [])


class EqualFunctions(unittest.TestCase):
    FIRST = "bool isNear(double a, double b) {\n  const double off = a - b;\n  return off * off < 1e-6;  // mm2\n}\n"

    def found(self, second, name="src/cli/b.cpp"):
        return list(equal_functions.faults(tree({"src/core/base/a.cpp": self.FIRST, name: second})))

    def test_a_function_under_other_names_is_refused(self):
        other = self.FIRST.replace("isNear", "areClose").replace("off", "gap").replace("double b", "const double& c").replace("- b", "- c")
        found = self.found("namespace {\n" + other.replace("  // mm2", "") + "}\n")
        self.assertEqual(len(found), 1)
        self.assertIn("src/cli/b.cpp:2 as areClose and src/core/base/a.cpp:1 as isNear", found[0])

    def test_other_types_numbers_texts_and_members_make_another_function(self):
        for old, new in (("double", "float"), ("1e-6", "1e-7"), ("off * off", "off.off * off"), ("bool is", "int is")):
            self.assertEqual(self.found(self.FIRST.replace(old, new)), [], new)
        self.assertEqual(self.found(self.FIRST.replace("isNear", "Range::isNear")), [])

    def test_a_few_words_may_stand_twice(self):
        few = "bool isWall(PathRole role) { return kindOf(role) == RoleKind::Wall; }\n"
        self.assertEqual(list(equal_functions.faults(tree({"src/core/base/a.cpp": few, "src/cli/b.cpp": few}))), [])

    def test_tests_may_repeat_a_function(self):
        self.assertEqual(self.found(self.FIRST, "test/base/a_test.cpp"), [])


class OneSource(unittest.TestCase):
    FIRST = "Press::Press(int size) : size_(size) {}\n\nint Press::size() const { return Sheet::area(size_); }\n"

    def found(self, second, name="src/core/base/b.cpp"):
        return list(one_source.faults(tree({"src/core/base/a.cpp": self.FIRST, name: second})))

    def test_a_class_in_two_sources_is_refused(self):
        for second in ("void Press::stop() {}\n", "const std::string&\nPress::name() const {\n", "Press::~Press() = default;\n",
                       "bool Press::operator<(const Press& b) const {\n", "std::map<int, Sheet> Press::all(\n    int least) {\n"):
            found = self.found(second)
            self.assertEqual(len(found), 1, second)
            self.assertIn("Press stand in src/core/base/a.cpp and src/core/base/b.cpp", found[0])

    def test_calls_and_types_are_no_definitions(self):
        for second in ("int two() { return Press::size(); }\n", "Press::Kind kind(int a) {\n", "const int kTwo = Press::size();\n",
                       "void run() {\n  Press::stop();\n}\n", "class Press;\nSheet::Sheet() : press(Press::of(2)) {}\n"):
            self.assertEqual(self.found(second), [], second)

    def test_classes_of_a_source_alone_may_share_a_name(self):
        self.assertEqual(self.found("class Press final : public Tool {\n};\nvoid Press::stop() {}\n"), [])
        self.assertEqual(self.found("struct Press::Impl {\n};\nvoid Press::Impl::stop() {}\n"), [])
        self.assertEqual(len(self.found("struct Press::Impl {\n};\nvoid Press::stop() {}\n")), 1)


class DocsLinks(unittest.TestCase):
    def found(self, files):
        return list(docs_links.faults(repository(files)))

    def test_pages_are_reached_through_each_other(self):
        self.assertEqual(self.found({"docs/README.md": "[a](a.md)\n", "docs/a.md": "[b](nodes/b.md#c), [web](https://x.org/y.md)\n",
                                     "docs/nodes/b.md": "[c](#c)\n", "README.md": "![p](docs/a.md)\n"}), [])

    def test_a_page_out_of_reach_is_named(self):
        found = self.found({"docs/README.md": "\n", "docs/nodes/a.md": "[b](../README.md)\n"})
        self.assertEqual(len(found), 1)
        self.assertIn("docs/nodes/a.md", found[0])

    def test_a_link_to_nothing_is_named_with_its_line(self):
        found = self.found({"docs/README.md": "\n[a](gone.md#b)\n"})
        self.assertEqual(len(found), 1)
        self.assertTrue(found[0].startswith("docs/README.md:2: "), found[0])
        self.assertIn("gone.md", found[0])

    def test_code_has_no_links(self):
        self.assertEqual(self.found({"docs/README.md": "```cpp\n[a](b) {}\n```\n`[a](b)`\n"}), [])

    ARCHITECTURE = {"docs/README.md": "[a](architecture.md)\n", "src/core/mesh/repair/hole.cpp": "", "cmake/a.cmake": ""}

    def test_paths_of_the_architecture_may_be_of_the_core_and_without_suffix(self):
        page = "| Folder | In it |\n|---|---|\n| `mesh` | `repair/`, `Hole`, `lamina slice` |\n\n`mesh/repair/hole`, `cmake/a.cmake`\n"
        self.assertEqual(self.found({**self.ARCHITECTURE, "docs/architecture.md": page}), [])

    def test_a_path_of_the_architecture_that_is_not_there_is_named_with_its_line(self):
        for page, path in (("\n| Folder | In it |\n| `mesh` | `report/` |\n", "mesh/report"), ("\n\n`mesh/repair/edge`\n", "mesh/repair/edge"),
                           ("\n| Folder | In it |\n| `voids` | gaps |\n", "voids")):
            found = self.found({**self.ARCHITECTURE, "docs/architecture.md": page})
            self.assertEqual(found, [f"docs/architecture.md:3: names {path}, which is not there"])


class References(unittest.TestCase):
    def found(self, files):
        return list(references.faults(repository(files)))

    def test_a_citation_with_an_entry_is_taken(self):
        self.assertEqual(self.found({"docs/references.md": "- **[Deb2002]** K. Deb\n", "a.cpp": "// [Deb2002, eq. 1]\n"}), [])

    def test_a_citation_without_an_entry_is_named_with_its_line(self):
        for citation in ("[Nobody1999]", "[Nobody1999,", "[Nobody1999, table 3]"):
            found = self.found({"docs/references.md": "- **[Deb2002]** K. Deb\n", "a.hpp": f"\n/// {citation}\n"})
            self.assertEqual(len(found), 1, citation)
            self.assertIn("a.hpp:2: cites [Nobody1999]", found[0])

    def test_two_entries_of_one_key_are_refused(self):
        self.assertEqual(len(self.found({"docs/references.md": "- **[Deb2002]** a\n- **[Deb2002]** b\n"})), 1)

    def test_other_brackets_are_no_citations(self):
        self.assertEqual(self.found({"a.cpp": "double a[kCount]; // [mm], [0, 1000], [N m]\n"}), [])


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


class ScratchFiles(unittest.TestCase):
    SOURCE = 'const auto path = testing::TempDir() + "a.stl";\nconst auto folder = fs::temp_directory_path() / "a";\n'

    def test_the_systems_folder_is_refused_line_by_line(self):
        found = list(scratch_files.faults(tree({"test/base/a_test.cpp": self.SOURCE})))
        self.assertEqual([fault.split(": ")[0] for fault in found], ["test/base/a_test.cpp:1", "test/base/a_test.cpp:2"])

    def test_the_scratch_folder_is_made_there(self):
        self.assertEqual(list(scratch_files.faults(tree({"test/support/scratch_folder.hpp": self.SOURCE}))), [])


class SuitesOfRostests(unittest.TestCase):
    def found(self, args):
        return [fault.split()[2] for fault in suites_of_rostests.faults(tree({
            "test/ros/CMakeLists.txt": "lamina_batch_sources(lamina_rostests loop/a_test.cpp\n  b_test.cpp ${SRC}/c.cpp)\n",
            "test/ros/loop/a_test.cpp": "TEST(Cell, A) {}\nTEST(Cell, B) {}\n", "test/ros/b_test.cpp": "TEST_P(Wall, A) {}\n",
            "test/ros/loop/a.test": f'<test type="lamina_rostests" args="{args}"/>\n'}))]

    def test_one_that_no_file_runs_is_named(self):
        self.assertEqual(self.found("Cell"), ["Wall;"])

    def test_several_of_one_file_are_run(self):
        self.assertEqual(self.found("Cell Wall"), [])


class SettingsCoverage(unittest.TestCase):
    CORE = "test/job/settings/covered_schemas.cpp"
    JOB = ("struct JobSettings {\n  FillSettings fill;\n  std::optional<SeamSettings> seam;\n};\n"
           "void describe(SettingsSchema& schema, JobSettings& job) {\n  describe(schema, job.fill);\n"
           "  describe(schema, job.seam, \"of walls\");\n}\n")
    FILL = "void describe(SettingsSchema& schema, FillSettings& fill) {\n  schema.flag(\"a\", fill.a, \"\");\n}\n"
    SEAM = ("void describe(SettingsSchema& schema, SeamSettings& seam, const std::string& of) {\n"
            "  schema.flag(\"b\", seam.b, of);\n}\n")

    def found(self, files, exceptions=None):
        return [fault.split()[0] for fault in settings_coverage.faults(tree(files), exceptions or {})]

    def sources(self, *texts):
        return {f"src/core/{number}.cpp": text for number, text in enumerate(texts)}

    def test_a_type_of_no_list_is_named(self):
        self.assertEqual(self.found(self.sources(self.FILL, self.SEAM)), ["FillSettings", "SeamSettings"])

    def test_what_is_part_of_a_listed_type_is_covered_with_it(self):
        listed = {self.CORE: "return keysOfAll<PlanSettings, JobSettings>();\n"}
        self.assertEqual(self.found({**self.sources(self.JOB, self.FILL, self.SEAM), **listed}), [])

    def test_a_type_of_nothing_but_listed_ones_is_covered(self):
        listed = {self.CORE: "return keysOfAll<FillSettings, SeamSettings>();\n"}
        self.assertEqual(self.found({**self.sources(self.JOB, self.FILL, self.SEAM), **listed}), [])
        listed = {self.CORE: "return keysOfAll<FillSettings>();\n"}
        self.assertEqual(self.found({**self.sources(self.JOB, self.FILL, self.SEAM), **listed}), ["JobSettings", "SeamSettings"])

    def test_an_exception_is_needed(self):
        self.assertEqual(self.found(self.sources(self.FILL), {"FillSettings": "why"}), [])
        self.assertEqual(self.found({}, {"FillSettings": "why"}), ["FillSettings"])


class AnonymousNames(unittest.TestCase):
    SOURCE = "namespace lamina {\nnamespace {\n\nconstexpr double kSmall = 1.0;\nint half(int a) { return a / 2; }\n\n}  // namespace\n}\n"

    def found(self, *names):
        return list(anonymous_names.faults(tree({name: self.SOURCE for name in names})))

    def test_a_name_in_two_sources_of_a_folder_is_refused(self):
        found = self.found("src/core/base/a.cpp", "src/core/base/b.cpp")
        self.assertEqual([fault.split(": ")[1].split()[0] for fault in found], ["half", "kSmall"])

    def test_other_folders_may_use_it(self):
        self.assertEqual(self.found("src/core/base/a.cpp", "src/core/geometry/a.cpp"), [])

    def test_folders_that_are_compiled_together_may_not(self):
        together = "lamina_batch_sources(lamina_core\n  flow/a.cpp\n  lift/b.cpp)\n"
        files = {"src/core/planning/flow/a.cpp": self.SOURCE, "src/core/planning/lift/b.cpp": self.SOURCE}
        found = list(anonymous_names.faults(tree({**files, "src/core/planning/CMakeLists.txt": together})))
        self.assertEqual([fault.split("; ")[0] for fault in found], [
            f"src/core/planning: {name} stands in flow/a.cpp and in lift/b.cpp" for name in ("half", "kSmall")])

    def test_tests_of_a_core_folder_are_one_folder(self):
        self.assertEqual(len(self.found("test/geometry/mesh/a_test.cpp", "test/geometry/polygon/b_test.cpp")), 2)

    def test_functions_of_the_command_may_overload(self):
        self.assertEqual(len(self.found("src/cli/a.cpp", "src/cli/b.cpp")), 1)


class Budgets(unittest.TestCase):
    def test_function_length_counts_from_signature_to_brace(self):
        lines = ["int f(int a) {", "  return a;", "}", "", "void g() {", "}"]
        self.assertEqual(list(budgets.function_lengths(lines)), [(1, 3), (5, 2)])

    def full(self, count, exceptions):
        root = repository({f"a/b/{number}.yaml": "" for number in range(count)})
        return [fault.split(": ")[0] for fault in budgets.full_folders(root, exceptions)]

    def test_every_file_of_a_folder_counts(self):
        self.assertEqual(self.full(40, {}), [])
        self.assertEqual(self.full(41, {}), ["a/b"])

    def test_a_full_folder_is_an_exception_by_name(self):
        self.assertEqual(self.full(41, {"a/b": "why"}), [])
        self.assertEqual(self.full(40, {"a/b": "why"}), ["a/b"])


if __name__ == "__main__":
    unittest.main()
