"""Writes what s_table measured as a page: engines_page.py ENGINES.csv PAGE.md README.md

In README.md it replaces what stands between the two lines `<!-- compare_engines -->` by a summary.
"""

import csv
import datetime
import pathlib
import platform
import subprocess
import sys

MARK = "<!-- compare_engines -->"
IN_SUMMARY = ("S1-64", "S1-1024", "S2", "S3-100", "S5-30", "S5m-25", "S6", "S7", "dolls", "S9", "S10")
WHAT = {
    "S1": "heap of boxes and balls", "S2": "wall, broken by three hulls", "S3": "heap of hulls and boxes",
    "S4": "20,000 particles", "S5": "pyramid", "S5m": "resting pyramids", "S6": "16 stacks of 40", "S7": "1,000 dominoes",
    "S8": "net of balls on joints", "dolls": "20 ragdolls of 33 boxes", "S9": "10,000 sleepers, 10 awake",
    "S10": "100,000 rays", "S11": "memory, bodies alone", "S11-piled": "memory, bodies in a heap",
}


def what(row):
    return WHAT.get(row) or WHAT.get(row.split("-")[0], "")


def number(line, name):
    return float(line[name]) if line[name] else None


def cost(line):
    value = number(line, "cost")
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def over_mean(line, name):
    value = number(line, name)
    return "-" if value is None or line["unit"] != "ms" else f"{value / number(line, 'cost'):.1f}"


def best_of(lines):
    """The peer whose own ratio is 1: s_table says which it is."""
    for line in lines:
        if line["is_carom"] == "0" and number(line, "of_best") == 1:
            return line
    return None


def short(engine):
    return engine.replace(" (float)", "").replace(" (double)", " f64")


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] +
                     ["| " + " | ".join(row) + " |" for row in rows])


def compared(by_row, with_steps):
    rows = []
    for row, lines in by_row.items():
        own = next((line for line in lines if line["is_carom"] == "1"), None)
        best = best_of(lines)
        if own is None:
            continue
        ratio = number(own, "of_best")
        aim = number(own, "aim")
        unit = own["unit"]
        is_bytes = unit == "bytes a body"
        met = aim and (number(own, "cost") <= aim if is_bytes else best and ratio <= aim)
        shown = f"{ratio:.2g}" if best else "-"
        cells = [row, what(row), cost(own) + (" B" if is_bytes else " ms"),
                 f"{cost(best)} ({short(best['engine'])})" if best else "none holds",
                 f"**{shown}**" if met else shown, (f"{aim:,g} B" if is_bytes else f"{aim:g}") if aim else "-"]
        if with_steps:
            for name in ("p99_ms", "worst_ms", "first_ms"):
                cells.append(f"{over_mean(own, name)} / {over_mean(best, name) if best else '-'}")
            for name in ("peak_penetration_mm", "peak_gap_mm"):
                a, b = number(own, name), number(best, name) if best else None
                cells.append("-" if not a and not b else f"{a:.3g} / " + ("-" if b is None else f"{b:.3g}"))
        rows.append(cells)
    return rows


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def git(*words):
    return subprocess.run(["git", *words], capture_output=True, text=True, check=False).stdout.strip()


def main(measured, page, readme):
    by_row, engines = {}, []
    with open(measured, newline="", encoding="utf-8") as file:
        for line in csv.DictReader(file):
            by_row.setdefault(line["row"], []).append(line)
            if line["engine"] not in engines:
                engines.append(line["engine"])
    when = (f"{datetime.date.today()}, {machine()}, one thread, commit {git('rev-parse', '--short', 'HEAD')}. "
            f"Engines: {', '.join(engines)}.")
    every = []
    for row, lines in by_row.items():
        of = {line["engine"]: line for line in lines}
        every.append([row] + [("-" if e not in of else cost(of[e]) + {"1": "", "0": " fails", "cut": " cut"}[of[e]["holds"]])
                              for e in engines])
    columns = ["row", "scene", "Carom", "best peer that holds", "Carom / it", "aim"]
    pathlib.Path(page).write_text(f"""# Carom beside other engines

`tests/bench/compare_engines` writes this page. How it is measured: [README.md](README.md), "How whole engines are compared".

{when}

A peer holds if no body is lost, what should stand stands, and its joints gape no farther than Carom's. A ratio in bold
meets its aim. Steps over the mean and quality are Carom's, then that peer's.

{table(columns + ["p99 / mean", "worst / mean", "first / mean", "deepest, mm", "joints, mm"], compared(by_row, True))}

![Time a step by row, over that of the best peer that holds](plots/engines.svg)

![Time of each step in four scenes](plots/engine_steps.svg)

All engines, ms a step (S10: ms of all rays; S11: bytes a body):

{table(["row"] + [short(e) for e in engines], every)}
""", encoding="utf-8")
    path = pathlib.Path(readme)
    parts = path.read_text(encoding="utf-8").split(MARK)
    if len(parts) != 3:
        sys.exit(f"{readme}: expected two lines '{MARK}'; put them where the summary shall stand")
    chosen = {row: lines for row, lines in by_row.items() if row in IN_SUMMARY}
    parts[1] = f"\n{when}\n\n{table(columns, compared(chosen, False))}\n"
    path.write_text(MARK.join(parts), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
