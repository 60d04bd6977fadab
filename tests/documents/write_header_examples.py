"""Makes one source of the examples in public headers, so that the compiler reads them too.

    write_header_examples.py INCLUDE OUTPUT HEADER...      headers relative to INCLUDE

An example is what stands between \\code and \\endcode in a comment. It becomes a function that has a case `impact` and
`options`; its #include lines go to the top. Exit code 1 if a header has none.
"""

import pathlib
import sys


def examples_of(text):
    """Line number of the first line, and lines, of each example."""
    inside = None
    for number, line in enumerate(text.splitlines(), 1):
        words = line.strip().removeprefix("///")
        if words.strip() == "\\code":
            inside = (number + 1, [])
        elif words.strip() == "\\endcode" and inside:
            yield inside
            inside = None
        elif inside:
            inside[1].append(words.removeprefix(" "))


def main():
    include, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    includes = {f'#include "dashpad/impact/{name}.hpp"' for name in ("impact_case", "solution")}
    functions, without, number = [], [], 0
    for header in sys.argv[3:]:
        examples = list(examples_of((include / header).read_text(encoding="utf-8")))
        includes.add(f'#include "{header}"')
        if not examples:
            without.append(header)
        for first, lines in examples:
            includes.update(line for line in lines if line.startswith("#include"))
            number += 1
            functions += [f"void example_{number}([[maybe_unused]] dashpad::ImpactCase& impact,",
                          "    [[maybe_unused]] const dashpad::Options& options) {{",
                          f'#line {first} "{include / header}"',
                          *("" if line.startswith("#include") else line for line in lines), "}}"]
    text = ["#include <cstdio>", "#include <fstream>", *sorted(includes), "namespace dashpad_examples {", *functions, "}"]
    output.write_text("\n".join(text) + "\n", encoding="utf-8")
    for header in without:
        print(f"{header}: no example between \\code and \\endcode")
    return 1 if without else 0


if __name__ == "__main__":
    sys.exit(main())
