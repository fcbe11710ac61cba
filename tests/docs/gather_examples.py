#!/usr/bin/env python3
"""gather_examples.py ROOT SOURCE: prints SOURCE with the examples of the pages in it.

A line `// PAGE: SECTION` of SOURCE stands for the next block of C++ of that section, whose compiler's messages then name
the page and its line. Exit status 1: an example is missing, or the pages have one that no test compiles. A comment above
a block says which test compiles it, or which file it is.
"""
import pathlib
import re
import sys

PLACE = re.compile(r" *// (\S+\.md): (.+)")
COMPILED = re.compile(r"<!-- (tests/\S+ compiles .*|\S+\.(cpp|hpp)) -->")


def examples(root, page):
    """Yields section, line number and lines of each block of C++ that no other test compiles."""
    section, block, before = "", None, ""
    for number, line in enumerate((root / page).read_text(encoding="utf-8").splitlines(), 1):
        if block is not None:
            if line.startswith("```"):
                yield section, first, block
                block = None
            else:
                block.append(line)
        elif line.startswith("#"):
            section = line.lstrip("# ")
        elif line == "```cpp" and not COMPILED.fullmatch(before):
            first, block = number + 1, []
        before = line


def main():
    root, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    pages = ["README.md", "host-sim/README.md", "host-sim/bench/README.md", "firmware/README.md"]
    pages += [f"docs/{path.name}" for path in sorted((root / "docs").glob("*.md"))]
    left = {}
    for page in pages:
        for section, first, block in examples(root, page):
            left.setdefault((page, section), []).append((first, block))
    wrong = False
    for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), 1):
        place = PLACE.fullmatch(line)
        if not place:
            print(line)
        elif not left.get(place.groups()):
            wrong = True
            print(f"{source}:{number}: no example is left in {place[1]}, {place[2]}", file=sys.stderr)
        else:
            first, block = left[place.groups()].pop(0)
            print(f'#line {first} "{root / place[1]}"', *block, f'#line {number + 1} "{source}"', sep="\n")
    for (page, section), blocks in left.items():
        for first, _ in blocks:
            wrong = True
            print(f"{page}:{first}: no test compiles this example of \"{section}\"", file=sys.stderr)
    return wrong


if __name__ == "__main__":
    sys.exit(main())
