"""Usage: documents_test.py ROOT. Every link in our documents leads to a file, and every cited source is in the list."""

import pathlib
import re
import sys


def links(text):
    """Targets of [text](target), code blocks left out."""
    prose = re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)
    return re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", prose)


def headings(text):
    """Anchors as the usual renderers make them."""
    prose = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    titles = re.findall(r"^#+ (.*)$", prose, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def main(root):
    assert links("[a](b.md) `[c](d)` ```\n[e](f)\n```") == ["b.md"]
    wrong = []
    documents = [p for p in sorted(root.rglob("*.md")) if not p.relative_to(root).parts[0].startswith(("build", "."))]
    assert documents, "no documents found"
    for document in documents:
        for link in links(document.read_text()):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (document.parent / path).resolve() if path else document
            if not target.exists():
                wrong.append(f"{document.relative_to(root)}: {link} leads nowhere")
            elif anchor and target.suffix == ".md" and anchor not in headings(target.read_text()):
                wrong.append(f"{document.relative_to(root)}: no heading for {link}")
    sys.exit("\n".join(wrong) or 0)


main(pathlib.Path(sys.argv[1]).resolve())
