"""Usage: classes_test.py ROOT. No class has more than 20 member functions or 12 fields of its own, so that a reader can
keep one in mind. Those of DEFENDED may have as many as it says, for the reason that it gives.

Constructors, operators, static and private functions count as member functions, overloads one by one; friends do not,
nor do static fields, types and what a base class has. The count reads the text, laid out as clang-format does: what has
parentheses before its initial value is a function. (libclang, asked once, counted the same in all headers.)"""

import pathlib
import re
import sys

LAYERS = ["model", "reference", "fast", "oracle", "properties", "app", "tests"]
FUNCTIONS, FIELDS = 20, 12

# file and class -> (member functions, fields, why it is not cut). The numbers are the exact ones, so that a class that
# was cut leaves the list.
DEFENDED = {
    "app/commands/command_line.cpp: Options": (
        0, 22, "has one member for each command of the program, into which the parser writes; nothing reads two."),
    "oracle/finding.h: Finding": (
        1, 14, "is the record of one verdict, field by field as case files and reports have it."),
    "oracle/subjects/canaries/lie.h: Lies": (
        0, 16, "has one lie for each of the eleven queries, three for all of them, and two claims of the card."),
    "oracle/subject.h: Card": (
        0, 18, "is what a subject declares, field by field as the protocol has it."),
    "oracle/process/pipe.h: PipeSubject": (
        21, 7, "has one function for each of the eleven queries, as every subject has."),
    "app/fuzz/fuzz_command.h: FuzzCommand": (
        0, 13, "has one member for each option of the command, into which the parser writes."),
    "tests/properties/fixed_subject.h: FixedSubject": (
        15, 13, "has one answer for each of the eleven queries."),
    "reference/rational.h: Rational": (
        21, 1, "is a number: nine functions make, copy and destroy it, five are operators, and GMP stays hidden."),
}

DEFINITION = re.compile(
    r"(?<!enum )\b(?:class|struct|union)(?: alignas\(\w+\))?(?: (\w[\w:]*))?(?: final)?(?: :[^;{}()]*)? \{")
NO_MEMBER = re.compile(r"(using|typedef|friend|static_assert|enum|class|struct|union)\b")


def code_of(text):
    """The text without comments and preprocessor lines, and with empty strings."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL)
    text = re.sub(r"""//[^\n]*|"(\\.|[^"\\\n])*"|(?<!\w)'(\\.|[^'\\\n])+'""",
                  lambda found: "" if found[0].startswith("//") else '""', text)
    return re.sub(r"^#(.*\\\n)*.*", "", text, flags=re.MULTILINE)


def end_of_block(code, begin):
    """Where the brace that is closed matches the one before `begin`."""
    depth = 1
    for brace in re.compile("[{}]").finditer(code, begin):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return brace.start()
    raise ValueError("a brace is not closed")


def ends_body(code, at):
    """Whether the brace at `at` closes the body of a function or of a class, and not an initial value."""
    return code[at + 1:at + 200].lstrip()[:1] not in tuple(",{;=(<>+-*/.?&|")


def statements(code):
    """The declarations of a class, without what stands in their parentheses, brackets and braces. A body ends one."""
    depth, text = 0, ""
    for at, c in enumerate(code):
        depth -= c in ")}]"
        if depth == 0:
            text += c
        depth += c in "({["
        if depth == 0 and (c == ";" or (c == "}" and ends_body(code, at))):
            yield " ".join(text.split())
            text = ""


def members(declaration):
    """(functions, fields) that it declares."""
    declaration = re.sub(r"^((public|protected|private) ?: |\[\] |alignas\(\) )+", "", declaration)
    while re.match("template <", declaration):
        declaration = declaration.split("> ", 1)[1]
    if NO_MEMBER.match(declaration):
        return 0, 0
    if re.search(r"\boperator\b", declaration):
        return 1, 0
    while re.search("<[^<>]*>", declaration):
        declaration = re.sub("<[^<>]*>", "", declaration)
    head = re.split("[={]", declaration)[0]
    if "(" in head and not re.search(r" \(\)\(\)", head):  # unless it is a pointer to a function: bool (*f)()
        return 1, 0
    return 0, 0 if re.match(r"(inline )?static\b", declaration) else 1 + declaration.count(",")


def classes(text):
    """(name, functions, fields) of each class, struct and union that the text defines, also inside others."""
    code = code_of(text)
    for found in DEFINITION.finditer(code):
        counts = [members(one) for one in statements(code[found.end():end_of_block(code, found.end())])]
        yield found[1] or "unnamed", sum(f for f, _ in counts), sum(f for _, f in counts)


def faults(file, text, defended):
    """What is too wide, or defended without need. Takes those that are defended out of `defended`."""
    for name, functions, fields in classes(text):
        key = f"{file}: {name}"
        if key in defended:
            were = defended.pop(key)[:2]
            if were != (functions, fields):
                yield f"{key}: {functions} member functions and {fields} fields, defended with {were[0]} and {were[1]}"
        elif functions > FUNCTIONS:
            yield f"{key}: {functions} member functions, at most {FUNCTIONS}: cut it where its ideas part, or defend it"
        elif fields > FIELDS:
            yield f"{key}: {fields} fields, at most {FIELDS}: cut it where its ideas part, or defend it"


def test_the_test():
    """Each kind of member is counted, and a wide class is reported, or defended."""
    for body, functions, fields in [
        ("int x = 0;\n  double y, z = 1;\n  Vec3 a[2];\n", 0, 4),
        ("explicit A(int x) : x_(x), y_{1} {}\n  ~A() = default;\n  A(const A&) = delete;\n", 3, 0),
        ("std::map<int, std::vector<int>> m, n;\n  std::function<int(int, int)> f;\n", 0, 3),
        ("int f() const { return x < 1 ? g(2) : 3; }\n  virtual void g() = 0;\n  static int h(int = f(1));\n", 3, 0),
        ("bool operator==(const A&) const = default;\n  bool operator<(const A& a) const { return x < a.x; }\n", 2, 0),
        ("friend bool operator<(A a, A b) { return true; }\n  friend class B;\n  using C = int;\n", 0, 0),
        ("template <class T, class U = std::pair<T, T>>\n  T f(U u);\n  static constexpr int n = 1;\n", 1, 0),
        (" private:\n  // int f();\n  int x = f(1, 2);  ///< }\n  char c = '}';\n  std::string s = \"};\";\n", 0, 3),
        ("std::size_t n = std::size_t{64} << 20;\n  int m = A{}.x;\n", 0, 2),
        ("bool (*f)() = nullptr;\n  void (*g)(int, double);\n  int operator()(int x);\n", 1, 2),
        ("enum class E { a, b };\n  E e = E::a;\n  class B;\n  std::unique_ptr<B> b;\n", 0, 2),
        ("void f() {\n    struct In {\n      int x = 0;\n    };\n  }\n", 1, 0),
        ("alignas(64) std::array<int, 4> a{};\n  [[nodiscard]] int f();\n#if 1\n  int y{1};\n#endif\n", 1, 2),
    ]:
        found = next(classes("template <class T>\nclass A final : public B<T> {\n  " + body + "};\n"))
        assert found == ("A", functions, fields), (body, found)
    inside = "struct A {\n  struct B {\n    int x;\n  } b;\n};\nenum class C { a };\n"
    assert [name for name, _, _ in classes(inside)] == ["A", "B"]
    wide = "struct A {\n" + "  int x;\n" * (FIELDS + 1) + "};\n"
    assert len(list(faults("a.h", wide, {}))) == 1
    assert len(list(faults("a.h", "struct A {\n" + "  int f();\n" * (FUNCTIONS + 1) + "};\n", {}))) == 1
    assert not list(faults("a.h", "struct A {\n" + "  int f();\n" * FUNCTIONS + "  int x;\n" * FIELDS + "};\n", {}))
    assert not list(faults("a.h", wide, {"a.h: A": (0, FIELDS + 1, "why")}))
    assert len(list(faults("a.h", wide, {"a.h: A": (0, FIELDS + 2, "why")}))) == 1


def main(root):
    test_the_test()
    defended, wrong, seen = dict(DEFENDED), [], 0
    for layer in LAYERS:
        for path in sorted((root / layer).rglob("*")):
            if path.suffix in {".h", ".cpp"}:
                text = path.read_text()
                seen += sum(1 for _ in classes(text))
                wrong += faults(path.relative_to(root).as_posix(), text, defended)
    wrong += [f"{key}: is defended, but is not there" for key in defended]
    print(f"{seen} classes read")
    assert seen > 500, "the tree was not found"
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
