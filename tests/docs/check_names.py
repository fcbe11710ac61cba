#!/usr/bin/env python3
"""check_names.py ROOT: the functions that docs/design.md lists as steps of a triangle, and the files that
docs/contributing.md lists for a new effect, exist."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
core = root / "core/zstrip"
failed = False


def complain(text):
    global failed
    failed = True
    print(text)


def rows(page, heading):
    """The cells of each row of the table that follows this text."""
    text = (root / page).read_text().split(heading, 1)[1]
    table = re.search(r"\n(\|.*\n)+", text).group(0)
    return [line.strip("|").split("|") for line in table.strip().splitlines()[2:]]


source = "".join(path.read_text() for path in sorted(core.rglob("*.hpp")))
steps = [re.search(r"`([\w:]+)`", cells[1]).group(1) for cells in rows("docs/design.md", "from `draw_strip` to the kernel")]
if not 2 <= len(steps) <= 12:
    complain(f"docs/design.md: {len(steps)} steps of a triangle; 12 are allowed")
for step in steps:
    *owner, function = step.split("::")
    if not re.search(rf"\b{function}\b[(<; ]", source) or (owner and not re.search(rf"(class|struct) {owner[0]}\b", source)):
        complain(f"docs/design.md: {step} is a step of a triangle, but core has no such name")


def expand(name):
    """`{a,b}.hpp` as a.hpp and b.hpp; may be nested."""
    brace = re.search(r"\{([^{}]*)\}", name)
    if not brace:
        return [name]
    return [one for part in brace.group(1).split(",") for one in expand(name[: brace.start()] + part + name[brace.end() :])]


count = 0
for cells in rows("docs/contributing.md", "## Add an effect"):
    for name in re.findall(r"`([^`]+)`", cells[1]):
        if "<name>" in name or "*" in name or not re.fullmatch(r"[\w./{},-]+", name) or not re.search(r"[/.]", name):
            continue
        for path in expand(name):
            count += 1
            base = root if re.match(r"(core|docs|firmware|hal|host-sim|tests)/|CHANGELOG", path) else core
            if not (base / path).exists():
                complain(f"docs/contributing.md: an effect's table names {name}, but {(base / path).relative_to(root)} is missing")
if count < 20:
    complain(f"docs/contributing.md: only {count} files of a new effect were found in its table")
sys.exit(failed)
