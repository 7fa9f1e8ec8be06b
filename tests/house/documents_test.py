"""Usage: documents_test.py ROOT. Every link in the documents has a target, every cited source is in the list, and the
README of a folder links to every page beside it."""

import pathlib
import re
import sys

SURNAME = r"[A-Z][\w'-]+(?: [A-Z][\w'-]+)?"
CITATION = re.compile(rf"({SURNAME})(?:, {SURNAME})*(?: & {SURNAME})? ((?:19|20)\d\d)\b")


def links(text):
    """The targets of [text](target), except in code."""
    prose = re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)
    return re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", prose)


def anchors(text):
    """The anchors of the headings, as the usual renderers make them."""
    prose = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    titles = re.findall(r"^#+ (.*)$", prose, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def cited(text):
    """The keys, as in docs/sources.bib: the first author, without an apostrophe, and the year."""
    return {author.split()[-1].lower().replace("'", "") + year for author, year in CITATION.findall(text)}


def broken_links(root, documents):
    for document, text in documents.items():
        for link in links(text):
            path, _, anchor = link.partition("#")
            target = (document.parent / path).resolve() if path else document
            if re.match(r"[a-z]+:", link):
                continue
            if not target.exists():
                yield f"{document.relative_to(root)}: {link} leads nowhere"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
                yield f"{document.relative_to(root)}: no heading for {link}"


def pages_left_out(root, documents):
    for document, text in documents.items():
        if document.name != "README.md" or document.parent == root:
            continue
        for page in sorted(document.parent.glob("*.md")):
            if page != document and page.name not in links(text):
                yield f"{document.relative_to(root)}: does not link to {page.name}"


def broken_sources(root, documents):
    listed = set(re.findall(r"^@\w+\{(\w+),", (root / "docs/sources.bib").read_text(), re.MULTILINE))
    for document, text in documents.items():
        if document.parent.name != "spec":
            continue
        for key in sorted(cited("\n".join(re.findall(r"\*\*Source\*\*.*", text))) - listed):
            yield f"{document.relative_to(root)}: {key} is not in docs/sources.bib"
    code = [p for folder in ("model", "reference", "fast", "oracle", "properties", "tests") for p in (root / folder).rglob("*.*")
            if p.suffix in {".h", ".cpp"}]
    everywhere = set().union(*map(cited, documents.values()), *(cited(p.read_text()) for p in code))
    for key in sorted(listed - everywhere):
        yield f"docs/sources.bib: nothing cites {key}"


def main(root):
    assert links("[a](b.md) `[c](d)` ```\n[e](f)\n```") == ["b.md"]
    assert cited("Gilbert, Johnson & Keerthi 1988; van den Bergen 2001") == {"gilbert1988", "bergen2001"}
    assert cited("O'Donoghue & Candès 2015") == {"odonoghue2015"}
    ours = (p for p in sorted(root.rglob("*.md")) if not p.relative_to(root).parts[0].startswith(("build", "."))
            and "node_modules" not in p.parts)
    documents = {p: p.read_text() for p in ours}
    assert documents, "no documents found"
    sys.exit("\n".join([*broken_links(root, documents), *pages_left_out(root, documents), *broken_sources(root, documents)]) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
