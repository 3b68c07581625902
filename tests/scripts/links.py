"""Checks the links and images of Markdown pages: prints one line for each that leads nowhere.

    python3 links.py ROOT PAGE...       pages relative to ROOT; ends with 1 if a line was printed
"""
import pathlib
import re
import sys

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)|<img src=\"([^\"]+)\"")
FENCE = re.compile(r"^(```|~~~).*?^\1\s*$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")


def anchors(page):
    """The anchors of a page's headings, as GitHub makes them."""
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    headings = re.findall(r"^#+ +(.*?)\s*$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def targets(text):
    return [link or image for link, image in LINK.findall(text)]


def faults(root, name):
    """Each link of a page that leads nowhere."""
    page = root / name
    text = CODE.sub("", FENCE.sub("", page.read_text(encoding="utf-8")))
    for target in targets(text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            yield f"{name}: {target}: there is no such file"
        elif anchor and anchor not in anchors(file):
            yield f"{name}: {target}: there is no such heading"


def reached(root, name):
    """The pages that can be reached by links from a page, itself included."""
    seen, waiting = set(), [(root / name).resolve()]
    while waiting:
        page = waiting.pop()
        if page in seen or not page.is_file():
            continue
        seen.add(page)
        text = FENCE.sub("", page.read_text(encoding="utf-8"))
        waiting += [(page.parent / target.partition("#")[0]).resolve() for target in targets(text) if target.partition("#")[0].endswith(".md")]
    return seen


def main():
    root, names = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    found = [fault for name in names for fault in faults(root, name)]
    linked = reached(root, "README.md")
    found += [f"{name}: no link leads here from README.md" for name in names if (root / name).resolve() not in linked]
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
