"""Prints the share of lines that tests cover, for each crate: coverage.py COVERAGE.json (of cargo llvm-cov)."""

import json
import re
import sys

counts = {}
for file in json.load(open(sys.argv[1]))["data"][0]["files"]:
    crate = re.search(r"crates/([^/]+)/src/", file["filename"])
    if crate:
        lines = file["summary"]["lines"]
        count, covered = counts.get(crate[1], (0, 0))
        counts[crate[1]] = count + lines["count"], covered + lines["covered"]
for crate, (count, covered) in sorted(counts.items()):
    print(f"{crate:12} {covered:5} of {count:5} lines: {100 * covered / count:.1f} %")
