"""headers_test.py ROOT: what class diagrams read from headers is what the headers declare; nothing is left out."""

import pathlib
import re
import sys
import types
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "reports"))
import class_table  # noqa: E402
from figures import class_diagram, headers, room_diagram  # noqa: E402

TEXT = """
#pragma once
#include <vector>
#include "core/types.hpp"  // "not/this.hpp"
// struct Lost { int a; };
namespace a::b {
/// A box. { ;
struct Box {
  Vec3 lo = Vec3(0, 0, 1), hi;  ///< m
  std::vector<std::pair<int, double>> all{};
  static constexpr int most = 4;
  std::array<int, 3> of = {1, 2, 3};
  bool (*where)(bit::Kind) = nullptr;
  const Pose &from, &to;
  double size() const { return hi.x(); }
  friend bool operator==(const Box&, const Box&) = default;
  struct alignas(16) Corner { int i = -1, j; };
};
enum class Kind : std::uint8_t { face, chamfer = 3, count };
using Law = std::variant<A, B>;
class Tree : public Box {
 public:
  explicit Tree(int n);
  void visit(int n) const;
 private:
  std::vector<int> nodes_;
};
inline constexpr double tiny = std::numeric_limits<double>::min();
template <class T>
T twice(const T& x) { return x + x; }
Box around(std::span<const Vec3> points, double (*f)(double) = nullptr);
Box around(int n);
bool operator<(const Box& a, const Box& b);
}  // namespace a::b
"""


class Read(unittest.TestCase):
    def setUp(self):
        self.header = headers.read(TEXT)
        self.types = {t.name: t for t in self.header.types}

    def test_types_and_their_kinds(self):
        self.assertEqual({n: t.kind for n, t in self.types.items()},
                         {"Box": "struct", "Box::Corner": "struct", "Kind": "enum", "Law": "using", "Tree": "class"})

    def test_fields_with_types_and_no_functions_or_constants(self):
        self.assertEqual(self.types["Box"].fields, (("lo", "Vec3"), ("hi", "Vec3"), ("all", "vector<pair<int, double>>"), ("of", "array<int, 3>"),
                                                    ("where", "bool (bit::Kind)"), ("from", "const Pose&"), ("to", "const Pose&")))
        self.assertEqual(self.types["Box::Corner"].fields, (("i", "int"), ("j", "int")))
        self.assertEqual(self.types["Tree"].fields, (("nodes_", "vector<int>"),))
        self.assertEqual([n for n, _ in self.types["Kind"].fields], ["face", "chamfer", "count"])
        self.assertEqual(self.types["Law"].fields, (("", "variant<A, B>"),))

    def test_functions_once_and_includes(self):
        self.assertEqual(self.header.functions, ("twice", "around"))
        self.assertEqual(self.header.included, ("core/types.hpp",))


class Shipped(unittest.TestCase):
    def test_every_type_of_src_is_found(self):
        """Found independently: the name of a type is at the beginning of a line."""
        for path in sorted((ROOT / "src").rglob("*.hpp")):
            text = path.read_text(encoding="utf-8")
            declared = set(re.findall(r"^(?:struct|class|enum class) (?:alignas\(.*\) )?(\w+)(?: :.*)? \{", text, re.MULTILINE))
            self.assertEqual(declared - {t.name for t in headers.read(text).types}, set(), path)

    def test_every_type_and_function_of_the_class_table_is_found(self):
        for row in class_table.rows(ROOT):
            found = set()
            for file in row.files:
                header = headers.read((ROOT / "src" / file).read_text(encoding="utf-8"))
                found |= {t.name for t in header.types} | set(header.functions)
            self.assertEqual(set(row.names) - found, set(), row.figure)


class Drawn(unittest.TestCase):
    def test_a_folder_is_listed_above_those_that_it_includes(self):
        read = {p: types.SimpleNamespace(included=i) for p, i in
                {"a/low/x.hpp": (), "a/high/y.hpp": ("a/low/x.hpp", "a/mid/z.hpp"), "a/mid/z.hpp": ("a/low/x.hpp",)}.items()}
        order, used = class_diagram.folders(read)
        self.assertEqual(list(order), ["a/high", "a/mid", "a/low"])
        self.assertEqual(used["a/high"], {"a/low", "a/mid"})

    def test_arrows_that_follow_from_others_are_left_out(self):
        needs = room_diagram.needed({"a/a.cpp": '#include "b/b.hpp"\n#include "c/c.hpp"\n', "b/b.hpp": '#include "c/c.hpp"\n', "c/c.hpp": "#include <map>\n"})
        self.assertEqual(needs, {"a": {"b", "c"}, "b": {"c"}, "c": set()})
        self.assertEqual(room_diagram.direct(needs), {"a": {"b"}, "b": {"c"}, "c": set()})
        self.assertEqual([room_diagram.level(needs, r) for r in "abc"], [0, 1, 2])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
