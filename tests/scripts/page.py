"""Runs the sh and python blocks of a Markdown page in order, and compares what they print with the text block that follows.

    python3 page.py PAGE CLONE       CLONE is the folder in which blocks marked "sh clone" run, all others run in this one

In a text block lines that begin with "msis: " are lines of standard error, of which a page shows the ones that matter; "exit code N" is
how the block ends; all others are standard output as it is. Prints what differs, and ends with 1 if anything does.
"""
import os
import pathlib
import re
import subprocess
import sys

FENCE = re.compile(r"^```(\w+)(?: (\w+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NOTE, CODE = "msis: ", "exit code "
LIMIT_SECONDS = 120


def steps(text):
    """Each block that runs: its line, its language, its mark, its text, and the lines that it prints by the page (None: not shown)."""
    blocks = [(text.count("\n", 0, match.start()) + 1, *match.groups()) for match in FENCE.finditer(text)]
    for index, (line, language, mark, body) in enumerate(blocks):
        if language in ("sh", "python"):
            after = blocks[index + 1] if index + 1 < len(blocks) else (0, None, None, None)
            yield line, language, mark, body, after[3].splitlines() if after[1] == "text" else None


def differences(run, expected):
    """What differs between a run and the lines of the page."""
    codes = [line for line in expected or [] if line.startswith(CODE)]
    if run.returncode != (int(codes[0].removeprefix(CODE)) if codes else 0):
        yield f"exit code {run.returncode}"
    if expected is None:
        return
    for note in (line for line in expected if line.startswith(NOTE)):
        if note not in run.stderr.splitlines():
            yield f"standard error has no line: {note}"
    output = [line for line in expected if not line.startswith((NOTE, CODE))]
    if output != run.stdout.splitlines():
        yield "standard output is not that of the page"


def main():
    page, clone = pathlib.Path(sys.argv[1]), sys.argv[2]
    count = 0
    for line, language, mark, body, expected in steps(page.read_text(encoding="utf-8")):
        command = [sys.executable, "-c", body] if language == "python" else ["bash", "-euo", "pipefail", "-c", body]
        run = subprocess.run(
            command, cwd=clone if mark == "clone" else None, env=os.environ, stdin=subprocess.DEVNULL, capture_output=True, text=True,
            timeout=LIMIT_SECONDS, check=False)
        found = list(differences(run, expected))
        if found:
            print(f"{page.name}, line {line}: {'; '.join(found)}\n--- output:\n{run.stdout}--- errors:\n{run.stderr}")
            sys.exit(1)
        count += 1
    print(f"{count} blocks")


if __name__ == "__main__":
    main()
