"""Counts long sentences in Markdown pages, and finds wording that reads as if translated; in C# files the wording of texts in quotes
and of comments.

    python3 english.py [--all] FILE[#HEADING]...   FILE#HEADING: only that section of the page

Prints the share of sentences of more than 30 words. With --all, or if the share is above the limit, prints each of them with file and
line; always prints each sentence with a pattern of PATTERNS. Ends with 1 if the share is above the limit or a pattern was found.
"""
import pathlib
import re
import sys

LONGEST = 30          # words
LIMIT = 0.03          # of all sentences may be longer
FORMULA = 5           # so many pieces with operators: a formula, not a sentence
SHORTEST = 3          # words: what has fewer is a label or a cell, not a sentence

FENCE = re.compile(r"^(```|~~~).*?^\1[^\n]*$", re.MULTILINE | re.DOTALL)
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
CODE = re.compile(r"(`+)[^`]+?\1")
IMAGE = re.compile(r"!\[([^\]]*)\]\([^)]*\)")
LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")
MATHS = re.compile(r"\S*[=<>^*/+]\S*?(?=[.,;:)]*(\s|$))")
QUANTITY = re.compile(r"(?<![\w.])[-+]?\d[\d.,]*( to | x )?([\d.,]*\d)? (px|m|km|mm|nm|s|ms|h|us|MB|GB|TB|kB|bytes|degrees|%|bits?|levels)\b")
SHORTENED = re.compile(r"\b(e\.g|i\.e|etc|cf|vs|al|Fig|fig|eq|Eq|No|no|St|Dr|R|approx)\.(?= )")
END = re.compile(r"(?<=[^.][.!?])[)\"'*]*\s+(?=\S)")

# What a reader stumbles over, and what to write. Words in code do not count.
PATTERNS = [
    (re.compile(r"^\W*Of (?!course)"), "begin with the subject, not with 'Of ...'"),
    (re.compile(r"(?<![Tt]here )(?<![Hh]ere )\b(is|was|are|were) no (?!longer|more than|less than|fewer than|one |data)\w"), "'is not a ...'"),
    (re.compile(r"^(1|bytes|s|deg|rad|([mk]?m|px|1)(/\w+)?): of "), "begin with the quantity, not with 'm: of ...'"),
    (re.compile(r"\bbelongs? to no\b"), "'does not belong to any'"),
    (re.compile(r"(?<!thing )(?<!where )(?<!one )(?<!body )(?<!hat )(?<!ho )(?<!here )\belse\b(?!')", re.IGNORECASE), "'otherwise'"),
    (re.compile(r"\b(stands?|stood)\b(?! (for|out|alone|up|still|in for))"), "'is'"),
    (re.compile(r"\b(is|are|was|were) told\b"), "say who tells, or 'a note says'"),
    (re.compile(r"\bwhat there is of\b", re.IGNORECASE), "name the thing"),
    (re.compile(r"\btak(es?|ing) (it|them) away\b"), "'removes'"),
    (re.compile(r"\bas many on each\b"), "'uniform'"),
    (re.compile(r"\bso that\b.*\bso that\b"), "one 'so that' in a sentence"),
    (re.compile(r"\b(it is|its \w+ is) so\b(?=[.,;]| from| on )"), "say what is so"),
    (re.compile(r"\bis by far missed\b|\bby far missed\b"), "'is far from'"),
    (re.compile(r"\bwhat an? \w+ is of\b"), "name the thing"),
    (re.compile(r"^\W*(Written|Drawn|Calibrated|Measured|Compared|Left out|Checked|Not tried|Kept) (is|are|was|were)\b"), "begin with the subject"),
]


# A text in quotes, and where two are joined; what is inserted is one word.
LITERAL = re.compile(r'\$?@?"((?:[^"\\\n]|\\.)*)"')
JOINT = re.compile(r'"\s*\)?\s*\+\s*(?:Invariant\()?\$?"')
INSERTED = re.compile(r"\{[^{}]*\}")

# A comment of C#, what in it is one word, where a text of it ends, and a sentence.
REMARK = re.compile(r'^((?:[^"\n/]|"(?:[^"\\\n]|\\.)*"|/(?!/))*)///?(?!/)(.*)')
NAMED = re.compile(r"<(?:see|paramref|typeparamref)\b[^>]*/>|<c>.*?</c>", re.DOTALL)
ELEMENT = re.compile(r"</?\w[^<>]*>")
SENTENCE = re.compile(r"[^\0\s](?:(?<![.;])\s|[^\0\s])*")
LINE_COMMENT = re.compile(r"^\s*//.*$", re.MULTILINE)
SHORTEST_TEXT = 4     # words: what has fewer is a name or a format


def blank(match):
    """The lines of what is left out stay, so that line numbers are right."""
    return re.sub(r"[^\n]", " ", match.group())


def section(text, heading):
    """A page with everything but one section of it blank."""
    lines, inside, depth, is_there = text.split("\n"), False, 0, False
    for index, line in enumerate(lines):
        found = re.match(r"(#+) +(.*)", line)
        if found and (not inside or len(found.group(1)) <= depth):
            inside, depth = found.group(2).strip() == heading, len(found.group(1))
            is_there |= inside
        if not inside:
            lines[index] = ""
    if not is_there:
        raise SystemExit(f"english.py: there is no heading \"{heading}\"")
    return "\n".join(lines)


def passages(text):
    """(line, text) of each paragraph, list item, heading and table cell, without code and links' targets."""
    text = COMMENT.sub(blank, FENCE.sub(blank, text))
    start, words = 0, []
    for number, line in enumerate([*text.split("\n"), ""], 1):
        stripped = line.strip()
        starts_anew = not stripped or re.match(r"([-*+]|\d+\.) |#|\||>", stripped) or line.startswith("    ") and not words
        if starts_anew and words:
            yield start, " ".join(words)
            words = []
        if stripped.startswith("#"):
            yield number, stripped.lstrip("# ")
        elif stripped.startswith("|"):
            yield from ((number, cell.strip()) for cell in re.split(r"(?<!\\)\|", stripped.strip("|")))
        elif stripped and not line.startswith("    ") or words and stripped:
            if not words:
                start = number
            words.append(re.sub(r"^([-*+]|\d+\.|>) +", "", stripped) if not words else stripped)


def sentences(text):
    """(line, sentence) of a page, each piece of code, each formula and each quantity with its unit one word."""
    for line, passage in passages(text):
        passage = passage.replace(" (default: ", ". (Default: ")  # in tables of options
        plain = LINK.sub(r"\1", IMAGE.sub(r"\1", CODE.sub("CODE", passage))).replace("**", "")
        plain = QUANTITY.sub("QUANTITY", SHORTENED.sub(r"\1", MATHS.sub("X", plain)))
        start = 0
        for end in [*END.finditer(plain), None]:
            yield line, plain[start:end.start() if end else None].strip()
            start = end.end() if end else 0


def texts(code):
    """(line, sentence) of the texts in quotes of C# code."""
    code = LINE_COMMENT.sub(blank, code)
    joined = JOINT.sub(lambda match: "\0" * match.group().count("\n"), code)  # keeps the lines' numbers
    for match in LITERAL.finditer(joined):
        text = INSERTED.sub("X", match.group(1).replace("\0", ""))
        if len(text.split()) >= SHORTEST_TEXT:
            line = 1 + joined.count("\n", 0, match.start()) + joined.count("\0", 0, match.start())
            yield from ((line, sentence) for sentence in re.split(r"(?<=[.;])\s+", text))


def remarks(code):
    """(line, sentence) of the comments of C# code, each element of a doc comment a text of its own."""
    start, words = 0, []
    for number, line in enumerate([*code.split("\n"), ""], 1):
        found = REMARK.search(line)
        if words and (not found or found.group(1).strip()):
            text = ELEMENT.sub("\0", NAMED.sub("X", "\n".join(words)))
            for sentence in SENTENCE.finditer(text):
                yield start + text.count("\n", 0, sentence.start()), " ".join(sentence.group().split())
            words = []
        if found:
            start = start if words else number
            words.append(found.group(2))


def main():
    shows_all = "--all" in sys.argv
    count, long, wrong = 0, [], []
    for name in (argument for argument in sys.argv[1:] if argument != "--all"):
        path, _, heading = name.partition("#")
        text = pathlib.Path(path).read_text(encoding="utf-8-sig")
        if path.endswith(".cs"):
            wrong += [f"{path}:{line}: {advice}: {sentence}" for line, sentence in [*texts(text), *remarks(text)]
                      if len(sentence.split()) >= SHORTEST
                      for pattern, advice in PATTERNS if pattern.search(sentence)]
            continue
        for line, sentence in sentences(section(text, heading) if heading else text):
            words = len([word for word in sentence.split() if re.search(r"\w", word)])
            if words < SHORTEST:
                continue
            count += 1
            if words > LONGEST and sentence.count(" X ") < FORMULA:
                long.append(f"{path}:{line}: {words} words: {sentence}")
            wrong += [f"{path}:{line}: {advice}: {sentence}" for pattern, advice in PATTERNS if pattern.search(sentence)]
    is_above = len(long) > LIMIT * count
    if is_above or shows_all:
        print(*long, sep="\n", end="\n" if long else "")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    print(f"{len(long)} of {count} sentences have more than {LONGEST} words ({100 * len(long) / max(count, 1):.1f} %, at most {100 * LIMIT:.0f} %)")
    sys.exit(1 if is_above or wrong else 0)


if __name__ == "__main__":
    main()
