"""Each kind of fault, on a few lines of C++: the mutants that are expected, written by hand."""

import sys
import unittest

try:
    import clang.cindex
    clang.cindex.Index.create()
except Exception as error:  # an old or a missing libclang raises many kinds
    print(f"SKIPPED: libclang for Python: {error} (Debian: apt-get install python3-clang)")
    sys.exit(77)

import mutants

HEAD = "double floor(double); double abs(double); double mix(double, double, int);\n"


def mutants_of(code):
    source = (HEAD + code).encode()
    unit = clang.cindex.Index.create().parse("a.cpp", ["-std=c++20"], unsaved_files=[("a.cpp", source.decode())])
    assert not list(unit.diagnostics), [d.spelling for d in unit.diagnostics]
    return mutants.in_file(unit, "fast/a.cpp", source, "a.cpp"), source


class Mutants(unittest.TestCase):
    def expect(self, code, *kinds_and_lines):
        """Exactly these mutants of these kinds."""
        kinds = {kind for kind, _ in kinds_and_lines}
        found = [(mutant.kind, mutant.after) for mutant in mutants_of(code)[0] if mutant.kind in kinds]
        self.assertEqual(sorted(found), sorted(kinds_and_lines))

    def test_relational_operators(self):
        self.expect("bool f(int a, int b) { return a < b; }",
                    ("relational", "bool f(int a, int b) { return a <= b; }"),
                    ("relational", "bool f(int a, int b) { return a > b; }"))
        self.expect("bool f(int a) { return a == 1; }", ("relational", "bool f(int a) { return a != 1; }"))

    def test_overloaded_operators(self):
        self.expect("struct V { V operator-(V) const; V operator+(V) const; };\nV f(V a, V b) { return a - b; }",
                    ("arithmetic", "V f(V a, V b) { return a + b; }"))

    def test_arithmetic_operators(self):
        self.expect("int f(int a) { a += 2 * a; return a; }",
                    ("arithmetic", "int f(int a) { a -= 2 * a; return a; }"),
                    ("arithmetic", "int f(int a) { a += 2 / a; return a; }"))
        self.expect("int f(int a) { return a + 1; }", ("arithmetic", "int f(int a) { return a - 1; }"))
        self.expect("void f(int a) { ++a; a--; }",
                    ("arithmetic", "void f(int a) { --a; a--; }"), ("arithmetic", "void f(int a) { ++a; a++; }"))

    def test_logical_operators(self):
        self.expect("bool f(bool a, bool b) { return a && b; }", ("logical", "bool f(bool a, bool b) { return a || b; }"))

    def test_constants(self):
        self.expect("constexpr int n = 7;", ("constant", "constexpr int n = (7 + 1);"),
                    ("constant", "constexpr int n = (7 - 1);"))
        self.expect("bool b = true;", ("constant", "bool b = false;"))
        self.expect("double x = 0.5;", ("constant", "double x = (2 * 0.5);"), ("constant", "double x = (0.5 / 2);"))
        self.expect("double x = 0.0;", ("constant", "double x = 1.0;"))
        self.expect("double x = 0x1p-40;", ("constant", "double x = (1000 * 0x1p-40);"),
                    ("constant", "double x = (0x1p-40 / 1000);"))
        self.expect("long double x = 0x1'0p4L;", ("constant", "long double x = (2 * 0x1'0p4L);"),
                    ("constant", "long double x = (0x1'0p4L / 2);"))

    def test_conditions(self):
        self.expect("int f(int a) { if (a) return 1; return 2; }",
                    ("condition", "int f(int a) { if (!(a)) return 1; return 2; }"))
        self.expect("int f(int a) { return a ? 1 : 2; }", ("condition", "int f(int a) { return !(a) ? 1 : 2; }"))
        self.expect("void f(int a) { for (int i = 0; i < a; ++i) a = 3; }",
                    ("condition", "void f(int a) { for (int i = 0; !(i < a); ++i) a = 3; }"))
        self.expect("void f(int a) { while (a) --a; }", ("condition", "void f(int a) { while (!(a)) --a; }"))

    def test_statements(self):
        self.expect("void f(int& a) { a = 1; }", ("statement", "void f(int& a) { ; }"))
        self.expect("void f(int a) { while (a) { if (a) break; } }",
                    ("statement", "void f(int a) { while (a) { if (false && (a)) break; } }"),
                    ("statement", "void f(int a) { while (a) { if (a) ; } }"))

    def test_arguments(self):
        self.expect("double f(double a, double b) { return mix(a, b, 1); }",
                    ("arguments", "double f(double a, double b) { return mix(b, a, 1); }"))
        self.expect("double f(double a, double b) { return a - b; }",
                    ("arguments", "double f(double a, double b) { return (b) - (a); }"))
        in_a_template = ("struct I {};\nI operator*(const I&, const I&);\n"
                         "template <class E> double f(E a) { return mix(E(a * E(2)), 1, 0); }")
        self.assertEqual([m.after for m in mutants_of(in_a_template)[0] if m.kind == "arguments"],
                         ["template <class E> double f(E a) { return mix(E(a * E(2)), 0, 1); }"])

    def test_indices(self):
        self.expect("double f(double* a) { return a[2]; }", ("index", "double f(double* a) { return a[1]; }"))
        self.expect("double f(double* a, int i) { return a[i]; }",
                    ("index", "double f(double* a, int i) { return a[(i) > 0 ? (i) - 1 : (i)]; }"))
        self.expect("struct V { double& operator()(int); };\nvoid f(V v) { v(0) = 1; }",
                    ("index", "void f(V v) { v(1) = 1; }"))
        self.expect("struct V { double& operator[](unsigned long); };\nvoid f(V v) { v[2] = true; }",
                    ("index", "void f(V v) { v[1] = true; }"), ("constant", "void f(V v) { v[2] = false; }"))

    def test_signs(self):
        self.expect("int f(int a) { return -a; }", ("sign", "int f(int a) { return a; }"))
        self.expect("double f(double a) { return abs(a); }", ("sign", "double f(double a) { return (a); }"),
                    ("sign", "double f(double a) { return -(abs(a)); }"))
        self.expect("void f(double a) { double b = a; }", ("sign", "void f(double a) { double b = -(a); }"))

    def test_rounding(self):
        self.expect("double f(double a) { return floor(a); }", ("rounding", "double f(double a) { return ceil(a); }"))
        self.expect("struct I { double lo, hi; };\ndouble f(I i) { return i.lo; }",
                    ("rounding", "double f(I i) { return i.hi; }"))

    def test_early_returns(self):
        self.expect("void f(int& a) { a = 1; a = 2; }",
                    ("early return", "void f(int& a) { return; a = 1; a = 2; }"),
                    ("early return", "void f(int& a) { a = 1; return; a = 2; }"))
        self.expect("int f() { return 3; }", ("early return", "int f() { return {}; return 3; }"))

    def test_what_is_left_alone(self):
        self.assertEqual(mutants_of('static_assert(1 < 2, "x");\n#define A 3 + 4\nvoid f();')[0], [])
        self.expect("int f() { throw 1 + 2; }", ("early return", "int f() { return {}; throw 1 + 2; }"),
                    ("statement", "int f() { ; }"))

    def test_each_kind_is_tested_and_each_mutant_is_one_edit(self):
        found, source = mutants_of("double f(double* a, int n) {\n  double sum = -1.5;\n  for (int i = 0; i < n && a; ++i) {\n"
                                   "    sum += floor(a[i]) * mix(a[0], sum, 2);\n  }\n  return sum;\n}")
        self.assertEqual({mutant.kind for mutant in found}, set(mutants.KINDS))
        for mutant in found:
            changed = mutant.apply(source)
            self.assertEqual((changed[:mutant.begin], changed[len(changed) - len(source) + mutant.end:]),
                             (source[:mutant.begin], source[mutant.end:]))
            self.assertNotEqual(changed, source)

    def test_an_id_stays_while_its_line_and_function_stay(self):
        line = "bool f(int a, int b) { return a < b; }"
        ids = lambda code: {mutant.id for mutant in mutants_of(code)[0] if mutant.function == "f"}  # noqa: E731
        self.assertEqual(ids(line), ids("int other;\n\n" + line))
        self.assertFalse(ids(line) & ids(line.replace("a < b", "a < b + 0")))
        twice = [mutant.id for mutant in mutants_of("void f(int a) {\n  ++a;\n  ++a;\n}")[0]]
        self.assertEqual(len(twice), len(set(twice)))


unittest.main()
