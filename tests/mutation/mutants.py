"""The mutants of a C++ source: copies with one small fault each, made systematically from its syntax tree.

Every class of faults is one function below. It looks at one node of the tree and yields edits of the text. Nothing here
knows what the code is for. An edit may give a mutant that does not compile, or one that does the same as the original;
the callers find that out."""

import collections
import dataclasses
import hashlib
import re

KINDS = ("relational", "arithmetic", "logical", "constant", "condition", "statement", "arguments", "index", "sign",
         "rounding", "early return")

RELATIONAL = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="], "==": ["!="], "!=": ["=="]}
ARITHMETIC = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["/"], "<<": [">>"], ">>": ["<<"], "&": ["|"],
              "|": ["&"], "^": ["&"], "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="], "|=": ["&="],
              "&=": ["|="], "<<=": [">>="], ">>=": ["<<="]}
LOGICAL = {"&&": ["||"], "||": ["&&"]}
BINARY = {**{op: ("relational", new) for op, new in RELATIONAL.items()},
          **{op: ("arithmetic", new) for op, new in ARITHMETIC.items()},
          **{op: ("logical", new) for op, new in LOGICAL.items()}}

# Names that stand for a direction: the wrong one of a pair is a fault.
OPPOSITES = [("floor", "ceil"), ("lo", "hi"), ("lo_", "hi_"), ("lower", "upper"), ("min", "max"), ("inf", "sup"),
             ("up", "down"), ("rounded_up", "rounded_down"), ("above", "below"), ("lower_bound", "upper_bound"),
             ("minCoeff", "maxCoeff"), ("cwiseMin", "cwiseMax"), ("min_element", "max_element"),
             ("MPFR_RNDD", "MPFR_RNDU"), ("FE_DOWNWARD", "FE_UPWARD"), ("round", "floor")]
OPPOSITE = {**{b: a for a, b in OPPOSITES if a != "round"}, **dict(OPPOSITES)}

SYMMETRIC = {"min", "max", "hypot", "swap", "minmax"}  # to exchange their arguments changes nothing

FUNCTIONS = {"FUNCTION_DECL", "CXX_METHOD", "CONSTRUCTOR", "DESTRUCTOR", "FUNCTION_TEMPLATE", "CONVERSION_FUNCTION"}
NAMED = {"NAMESPACE", "CLASS_DECL", "STRUCT_DECL", "CLASS_TEMPLATE", "CLASS_TEMPLATE_PARTIAL_SPECIALIZATION"}
# What these contain is text for readers, or checked when it is compiled. Whole throw statements may be dropped.
PASSED_OVER = {"STATIC_ASSERT", "CXX_THROW_EXPR", "STRING_LITERAL", "ENUM_DECL"}
FLOATING = {"FLOAT", "DOUBLE", "LONGDOUBLE"}
INTEGRAL = {"BOOL", "CHAR_S", "CHAR_U", "SCHAR", "UCHAR", "SHORT", "USHORT", "INT", "UINT", "LONG", "ULONG", "LONGLONG",
            "ULONGLONG"}


@dataclasses.dataclass(frozen=True)
class Mutant:
    path: str        # of the file, relative to the root of the source
    line: int
    function: str    # the function around the fault
    kind: str        # one of KINDS
    before: str      # the text that is replaced ...
    after: str       # ... and by what, on one line
    begin: int       # the bytes of the file that are replaced
    end: int
    text: str        # what replaces them
    id: str = ""     # the same as long as the line and its function keep their text

    def apply(self, source):
        """The mutated file; `source`: the bytes of the original."""
        return source[:self.begin] + self.text.encode() + source[self.end:]


@dataclasses.dataclass(frozen=True)
class Node:
    """A cursor of libclang, with its text in the file."""
    cursor: object
    begin: int
    end: int
    text: str

    @property
    def kind(self):
        return self.cursor.kind.name

    def type_kind(self):
        return self.cursor.type.get_canonical().kind.name

    def type_name(self):
        spelled = self.cursor.type.get_canonical().spelling
        return re.sub(r"\bconst\b|&|\s", "", spelled)


class Tree:
    """The nodes of one file that stand in its text as they are: nothing that a macro made, and nothing implicit."""

    def __init__(self, source, file):
        self.source, self.file = source, file

    def node(self, cursor):
        start, end = cursor.extent.start, cursor.extent.end
        if start.file is None or start.file.name != self.file or end.offset <= start.offset:
            return None
        text = self.source[start.offset:end.offset].decode(errors="replace")
        return Node(cursor, start.offset, end.offset, text)

    def children(self, cursor):
        return [node for node in map(self.node, cursor.get_children()) if node]

    def between(self, left, right):
        """(begin, end, text) of what stands between two nodes, without white space."""
        text = self.source[left.end:right.begin].decode(errors="replace")
        begin = left.end + len(text[:len(text) - len(text.lstrip())].encode())
        return begin, begin + len(text.strip().encode()), text.strip()


def replaced(kind, node, text):
    return kind, node.begin, node.end, text


def is_of_library(node):
    """Types for which another operator does not compile, or only prints."""
    return any(name in node.type_name() for name in ("basic_string", "ostream", "Eigen::"))


def operands(tree, node):
    """The operands of a binary operator, built in or overloaded, and (begin, end, text) of the operator."""
    if node.kind not in ("BINARY_OPERATOR", "COMPOUND_ASSIGNMENT_OPERATOR") and not (
            node.kind == "CALL_EXPR" and node.cursor.spelling.startswith("operator")):
        return None
    parts = tree.children(node.cursor)
    if len(parts) < 2 or parts[0].end > parts[-1].begin:
        return None
    return parts[0], parts[-1], tree.between(parts[0], parts[-1])


def other_operators(tree, node):
    found = operands(tree, node)
    if not found:
        return
    left, right, (begin, end, text) = found
    kind, others = BINARY.get(text, ("", []))
    if text in ("*", "/", "*=", "/=") and (is_of_library(left) or is_of_library(right)):
        others = []
    if text in ("<<", ">>") and left.type_kind() not in INTEGRAL:
        others = []
    if "basic_string" in left.type_name() + right.type_name() and kind == "arithmetic":
        others = []
    for other in others:
        yield kind, begin, end, other


def other_steps(tree, node):
    """++ and --."""
    if node.kind == "UNARY_OPERATOR" and (match := re.match(r"\+\+|--", node.text)):
        yield "arithmetic", node.begin, node.begin + 2, "--" if match.group() == "++" else "++"
    if node.kind == "UNARY_OPERATOR" and (match := re.search(r"(\+\+|--)$", node.text)):
        yield "arithmetic", node.end - 2, node.end, "--" if match.group() == "++" else "++"


def exchanged_operands(tree, node):
    found = operands(tree, node)
    if found and found[2][2] in ("-", "/") and found[0].text != found[1].text:
        left, right, (_, _, text) = found
        yield "arguments", left.begin, right.end, f"({right.text}) {text} ({left.text})"


def exchanged_arguments(tree, node):
    """Neighbouring arguments of one type."""
    if node.kind == "CALL_EXPR" and not node.cursor.spelling.startswith("operator"):
        arguments = [a for a in map(tree.node, node.cursor.get_arguments()) if a]
    elif node.kind == "INIT_LIST_EXPR":
        arguments = tree.children(node.cursor)
    else:
        return
    if node.cursor.spelling in SYMMETRIC:
        return
    for left, right in zip(arguments, arguments[1:]):
        between = tree.source[left.end:right.begin].decode()  # operands in a template have no comma between them
        if "," in between and left.text != right.text and left.type_name() == right.type_name():
            yield "arguments", left.begin, right.end, f"{right.text}{between}{left.text}"


def whole_number(text):
    return int(re.sub(r"['uUlLzZ]", "", text), 0) if not re.match(r"0\d", text) else int(text, 8)


def other_constants(tree, node):
    """A flag turned over; a whole number that is one more or less; a number twice or half as great, or, if it is small
    and so a tolerance, a thousand times."""
    if node.kind == "CXX_BOOL_LITERAL_EXPR" and node.text in ("true", "false"):
        yield replaced("constant", node, "false" if node.text == "true" else "true")
    if node.kind == "INTEGER_LITERAL" and re.match(r"\d", node.text):
        value = whole_number(node.text)
        for other in {0: ["1"], 1: ["0", "2"]}.get(value, [f"({node.text} + 1)", f"({node.text} - 1)"]):
            yield replaced("constant", node, other)
    if node.kind == "FLOATING_LITERAL" and re.match(r"[\d.]", node.text):
        digits = re.sub(r"[fFlL]$", "", node.text.replace("'", ""))
        value = float.fromhex(digits) if digits.startswith("0x") else float(digits)
        factor = 2 if value > 1e-3 else 1000
        for other in ["1.0"] if value == 0 else [f"({factor} * {node.text})", f"({node.text} / {factor})"]:
            yield replaced("constant", node, other)


def index_of(tree, node):
    """The index in a[i], and in p(i) of a matrix."""
    parts = tree.children(node.cursor)
    if len(parts) < 2:
        return None
    if node.kind == "ARRAY_SUBSCRIPT_EXPR" or (
            node.kind == "CALL_EXPR" and node.cursor.spelling in ("operator[]", "operator()")):
        return parts[-1] if parts[-1].begin >= parts[0].end else None
    return None


def other_indices(tree, node):
    """The neighbour of an element. It exists, so that the fault is a wrong answer and not only a wild access."""
    index = index_of(tree, node)
    if not index or index.type_kind() not in INTEGRAL:
        return
    if re.fullmatch(r"\d+", index.text):
        value = int(index.text)
        yield replaced("index", index, str(value - 1 if value > 0 else 1))
    elif not re.search(r"\+\+|--|=", index.text):
        yield replaced("index", index, f"({index.text}) > 0 ? ({index.text}) - 1 : ({index.text})")


def condition_of(tree, node):
    """The condition of a statement or of ?:, unless it declares a variable."""
    parts = tree.children(node.cursor)
    if node.kind in ("IF_STMT", "WHILE_STMT", "FOR_STMT"):
        parts = [p for p in parts if p.cursor.kind.is_expression()]
        if node.kind == "FOR_STMT":
            parts = [p for p in parts if p.type_kind() == "BOOL"]
        return parts[0] if parts and not node.text.startswith("if constexpr") else None
    if node.kind == "DO_STMT" and len(parts) == 2:
        return parts[1]
    if node.kind == "CONDITIONAL_OPERATOR" and len(parts) == 3:
        return parts[0]
    if node.kind == "RETURN_STMT" and parts and parts[0].type_kind() == "BOOL":
        return parts[0] if parts[0].text not in ("true", "false") else None
    return None


def negated_conditions(tree, node):
    if condition := condition_of(tree, node):
        yield replaced("condition", condition, f"!({condition.text})")


def is_droppable(node):
    if node.kind in ("BREAK_STMT", "CONTINUE_STMT"):
        return True
    if node.kind == "RETURN_STMT":
        return node.text == "return"
    return node.cursor.kind.is_expression() and not node.text.startswith("(void)")


def dropped_statements(tree, node):
    """A statement by itself or in a branch; and a branch that is never taken."""
    if node.kind == "COMPOUND_STMT":
        parts = tree.children(node.cursor)
    elif node.kind in ("IF_STMT", "FOR_STMT", "WHILE_STMT", "CXX_FOR_RANGE_STMT"):
        parts = tree.children(node.cursor)[-1:]
    else:
        return
    for part in parts:
        if is_droppable(part) and tree.source[part.end:].lstrip()[:1] == b";":
            yield replaced("statement", part, "")
        condition = condition_of(tree, part) if part.kind == "IF_STMT" else None
        if condition and not re.search(r"\}\s*else\b", part.text):
            yield replaced("statement", condition, f"false && ({condition.text})")


def changed_signs(tree, node):
    """A sign or a negation removed, an absolute value that keeps its sign, a result or a variable negated."""
    parts = [p for p in tree.children(node.cursor) if p.text not in ("-", "!")]
    is_unary = node.kind == "UNARY_OPERATOR" or node.cursor.spelling in ("operator-", "operator!")
    if is_unary and len(parts) == 1 and node.text[0] in "-!" and not node.text.startswith("--"):
        yield "sign", node.begin, node.begin + 1, ""
    if node.kind == "CALL_EXPR" and node.cursor.spelling in ("abs", "fabs"):
        arguments = [a for a in map(tree.node, node.cursor.get_arguments()) if a]
        if len(arguments) == 1:
            yield replaced("sign", node, f"({arguments[0].text})")
    if node.kind in ("RETURN_STMT", "VAR_DECL") and parts:
        value = parts[-1]
        is_literal = value.kind in ("FLOATING_LITERAL", "INTEGER_LITERAL")
        if value.cursor.kind.is_expression() and value.type_kind() in FLOATING and not is_literal:
            yield replaced("sign", value, f"-({value.text})")


def other_directions(tree, node):
    if node.kind not in ("DECL_REF_EXPR", "MEMBER_REF_EXPR", "OVERLOADED_DECL_REF"):
        return
    name, place = node.cursor.spelling, node.cursor.location.offset
    if name in OPPOSITE and tree.source[place:place + len(name)] == name.encode():
        yield "rounding", place, place + len(name), OPPOSITE[name]


def early_returns(tree, node):
    """A function that ends before its first statement, or half way."""
    if node.kind not in FUNCTIONS or node.kind in ("CONSTRUCTOR", "DESTRUCTOR"):
        return
    bodies = [part for part in tree.children(node.cursor) if part.kind == "COMPOUND_STMT"]
    statements = tree.children(bodies[-1].cursor) if bodies else []
    is_void = node.cursor.result_type.spelling == "void"
    for place in sorted({0, len(statements) // 2} if statements else ()):
        begin = statements[place].begin
        yield "early return", begin, begin, "return; " if is_void else "return {}; "


FAULTS = (other_operators, other_steps, exchanged_operands, exchanged_arguments, other_constants, other_indices,
          negated_conditions, dropped_statements, changed_signs, other_directions, early_returns)


def edits(tree, cursor, function=(), index=None):
    """(kind, begin, end, text, function) of each fault below a cursor; `index`: the place of an index around it."""
    if cursor.kind.name in PASSED_OVER:
        return
    if cursor.kind.name in FUNCTIONS | NAMED and cursor.spelling:
        function = () if cursor.kind.name == "NAMESPACE" else (*function, cursor.spelling)
    node = tree.node(cursor)
    if node and not (node.kind == "INTEGER_LITERAL" and (node.begin, node.end) == index):  # its faults are an index's
        for fault in FAULTS:
            for edit in fault(tree, node):
                yield *edit, "::".join(function)
    found = index_of(tree, node) if node else None
    index = (found.begin, found.end) if found else index
    for child in cursor.get_children():
        yield from edits(tree, child, function, index)


def on_one_line(text):
    return re.sub(r"\s+", " ", text).strip()


def named(path, source, kind, begin, end, text, function):
    line_begin, line_end = source.rfind(b"\n", 0, begin) + 1, source.find(b"\n", max(begin, end - 1))
    line_end = len(source) if line_end < 0 else line_end
    before = on_one_line(source[line_begin:line_end].decode())
    after = on_one_line((source[line_begin:begin] + text.encode() + source[end:line_end]).decode())
    return Mutant(path, source.count(b"\n", 0, begin) + 1, function, kind, before, after, begin, end, text)


def in_file(unit, path, source, file):
    """The mutants of a file, in the order of its text; `unit`: a translation unit of libclang that contains it."""
    tree, found = Tree(source, file), {}
    for cursor in unit.cursor.get_children():
        if cursor.location.file and cursor.location.file.name == file:
            for kind, begin, end, text, function in edits(tree, cursor):
                found.setdefault((begin, end, text), named(path, source, kind, begin, end, text, function))
    counts, mutants = collections.Counter(), []
    for place in sorted(found):
        mutant = found[place]
        key = "\n".join([mutant.path, mutant.function, mutant.kind, mutant.before, mutant.after])
        counts[key] += 1
        digest = hashlib.sha256(f"{key}\n{counts[key]}".encode()).hexdigest()[:8]
        mutants.append(dataclasses.replace(mutant, id=digest))
    return mutants
