#!/usr/bin/python3
"""Draws the validation book: the pages that tests wrote (tests/book/page.h) become one HTML file.

make_book.py PAGES OUT.html [--expected FILE]

PAGES     folder of *.json, one file a test or, of a TEST_P, one an instance
--expected  file ("-": standard input) with a test's name a line; one that has no page is told in the book
Ends with 0 if all tests passed, with 1 if one failed or is missing (the book is written all the same), with 2 if a
page cannot be read. Needs Debian's python3-matplotlib; ends with 77 without it.
"""
import argparse
import base64
import datetime
import html
import io
import itertools
import json
import math
import os
import platform
import re
import subprocess
import sys

try:
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    from matplotlib import mathtext
    from matplotlib.font_manager import FontProperties
    from matplotlib.lines import Line2D
except ImportError:
    sys.stderr.write("error: drawing the book needs python3-matplotlib (packages.txt, section [book])\n")
    sys.exit(77)

# Colours that are told apart by colour-blind readers too [Okabe, Ito 2008].
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#444444"]
MARKS = ["o", "s", "^", "D", "v", "P", "X", "<", ">"]
LEGEND_AT_MOST = 12


class BadPage(Exception):
    """A page that says something else than tests/book/page.h writes."""


# ---------------------------------------------------------------------------------------------- reading

FIELDS = {"test": str, "variant": str, "file": str, "line": int, "chapter": str, "chapter_number": int, "claim": str,
          "formula": str, "source": str, "symbols": list, "x": dict, "y": dict, "passed": bool, "series": list,
          "largest": dict}
SERIES = ["x", "found", "theory", "tolerance"]


def number(value):
    return math.nan if value is None else float(value)


def read_page(path):
    try:
        with open(path, encoding="utf-8") as file:
            page = json.load(file)
    except json.JSONDecodeError as error:
        raise BadPage(f"{path}:{error.lineno}:{error.colno}: error: no JSON: {error.msg}") from error
    if not isinstance(page, dict):
        raise BadPage(f"{path}: error: found a {type(page).__name__}, expected an object")
    for name, kind in FIELDS.items():
        if name not in page:
            raise BadPage(f'{path}: error: "{name}" is missing')
        if not isinstance(page[name], kind):
            raise BadPage(f'{path}: error: "{name}" is {page[name]!r}, expected {kind.__name__}')
    for axis in ("x", "y"):
        if not {"name", "unit", "logarithmic"} <= page[axis].keys():
            raise BadPage(f'{path}: error: axis "{axis}" needs "name", "unit" and "logarithmic"')
    for series in page["series"]:
        read_series(path, series)
    page["largest"] = {name: number(page["largest"].get(name)) for name in ("deviation", "tolerance", "share")}
    return page


def read_series(path, series):
    try:
        for name in SERIES + ["curve_x", "curve_y"]:
            series[name] = [number(value) for value in series[name]]
    except (KeyError, TypeError, ValueError) as error:
        raise BadPage(f"{path}: error: a series without numbers: {error!r}") from error
    if len({len(series[name]) for name in SERIES}) != 1:
        raise BadPage(f'{path}: error: "x", "found", "theory" and "tolerance" of a series differ in length')


def read_tests(folder):
    """One page a test: instances of a TEST_P become series of one."""
    paths = sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".json"))
    if not paths:
        raise BadPage(f"{folder}: error: no page in this folder")
    tests = {}
    for path in paths:
        page = read_page(path)
        for series in page["series"]:
            series["name"] = ", ".join(word for word in (page["variant"], series["name"]) if word)
        first = tests.setdefault(page["test"], page)
        if first is page:
            continue
        first["series"] += page["series"]
        first["passed"] = first["passed"] and page["passed"]
        if not math.isnan(first["largest"]["share"]) and not page["largest"]["share"] <= first["largest"]["share"]:
            first["largest"] = page["largest"]
    return sorted(tests.values(), key=lambda page: (page["chapter_number"], page["file"], page["line"]))


# ---------------------------------------------------------------------------------------------- drawing

def embedded(svg, alt, extra=""):
    data = base64.b64encode(svg).decode("ascii")
    return f'<img src="data:image/svg+xml;base64,{data}" alt="{html.escape(alt, quote=True)}"{extra}>'


def formula_picture(tex, size=15):
    svg = io.BytesIO()
    try:
        mathtext.math_to_image(f"${tex}$", svg, prop=FontProperties(size=size), format="svg", dpi=72)
    except ValueError as error:
        raise BadPage(f'formula "{tex}": error: not understood: {str(error).strip().splitlines()[-1]}') from error
    return embedded(svg.getvalue(), tex)


def label(axis):
    return axis["name"] + (f" [{unit_text(axis['unit'])}]" if axis["unit"] else "")


def unit_text(unit):
    """m/s^2 with its exponent raised."""
    return re.sub(r"\^(-?\d+)", r"$^{\1}$", unit)


def draw(page):
    """Theory and points above, deviation in shares of the tolerance below."""
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7.6, 5.2), sharex=True, height_ratios=[3, 1])
    names = list(dict.fromkeys(series["name"] for series in page["series"]))
    styles = {name: (COLOURS[i % len(COLOURS)], MARKS[i % len(MARKS)]) for i, name in enumerate(names)}
    size = 3 if sum(len(series["x"]) for series in page["series"]) > 60 else 5
    for series in page["series"]:
        draw_series(upper, lower, series, *styles[series["name"]], size)
    lower.axhspan(-1, 1, color="#000000", alpha=0.06, linewidth=0)
    lower.axhline(0, color="#888888", linewidth=0.6)
    largest = page["largest"]["share"]
    limit = 1.15 if not largest > 1.1 else min(largest, 20) * 1.1
    lower.set_ylim(-limit if any(not s["bounded"] for s in page["series"]) else 0, limit)
    lower.set_ylabel("deviation /\ntolerance")
    if page["x"]["logarithmic"]:
        lower.set_xscale("log")
    if page["y"]["logarithmic"]:
        upper.set_yscale("log")
    upper.set_ylabel(label(page["y"]))
    lower.set_xlabel(label(page["x"]))
    for axes in (upper, lower):
        axes.grid(True, alpha=0.25)
        axes.margins(x=0.04)
    legend(upper, page, styles)
    figure.align_ylabels()
    figure.tight_layout()
    svg = io.BytesIO()
    figure.savefig(svg, format="svg", metadata={"Date": None})
    plt.close(figure)
    return embedded(svg.getvalue(), f"plot: {page['claim']}", ' class="plot"')


def draw_series(upper, lower, series, colour, mark, size):
    x, found, theory, tolerance = (series[key] for key in SERIES)
    if series["curve_x"]:
        upper.plot(series["curve_x"], series["curve_y"], color=colour, linewidth=1.2)
    if not x:
        return
    style = {"color": colour, "markersize": size, "markerfacecolor": "none", "linestyle": "none", "marker": mark}
    upper.plot(x, found, zorder=3, **style)
    if series["bounded"]:
        bounds = sorted(zip(x, tolerance))
        upper.plot(*zip(*bounds), "--" if len(set(tolerance)) == 1 < len(set(x)) else "_", color=colour, linewidth=1, markersize=14)
    else:
        upper.errorbar(x, theory, yerr=tolerance, fmt="none", color=colour, capsize=3, linewidth=1, alpha=0.6)
        if not series["curve_x"]:
            upper.plot(x, theory, "+", color=colour, markersize=9)
    parts = [(f - y) / t if t > 0 else (0 if f == y else math.inf) for f, y, t in zip(found, theory, tolerance)]
    lower.plot(x, parts, **style)


def legend(axes, page, styles):
    """What marks and lines mean once, in grey, and a line a series; no more lines than leave room for the plot."""
    def key(text, **style):
        return Line2D([], [], **{"color": "#555555", "linestyle": "none", "markerfacecolor": "none", "markersize": 5,
                                 "label": text, **style})
    curves, points = any(s["curve_x"] for s in page["series"]), [s for s in page["series"] if s["x"]]
    keys = [key("simulated", marker="o")] if points else []
    keys += [key("theory", linestyle="-")] if curves else []
    keys += [key("theory", marker="+")] if any(not s["bounded"] and not s["curve_x"] for s in points) and not curves else []
    keys += [key("allowed", linestyle="--")] if any(s["bounded"] for s in points) else []
    keys += [key("allowed", marker="_", markersize=7)] if any(not s["bounded"] for s in points) else []
    named = [(name, style) for name, style in styles.items() if name]
    if len(named) <= LEGEND_AT_MOST:
        for name, (colour, mark) in named:
            line = any(s["curve_x"] for s in page["series"] if s["name"] == name)
            mark = mark if any(s["x"] for s in page["series"] if s["name"] == name) else ""
            keys.append(key(name, color=colour, marker=mark, linestyle="-" if line else "none"))
    axes.legend(handles=keys, loc="upper center", bbox_to_anchor=(0.5, 1.0 + 0.075 * math.ceil(len(keys) / 4) + 0.03),
                fontsize=8, frameon=False, ncols=4)


# ---------------------------------------------------------------------------------------------- writing

STYLE = """
body { font: 16px/1.45 Georgia, 'DejaVu Serif', serif; max-width: 52em; margin: 2em auto; padding: 0 1em; color: #1a1a1a }
h1 { font-size: 2em } h2 { border-bottom: 2px solid #0072b2; padding-bottom: .2em; margin-top: 3em }
h3 { margin-bottom: .2em } code, .test { font: 13px 'DejaVu Sans Mono', monospace; overflow-wrap: anywhere }
table { border-collapse: collapse; font-size: 14px } td, th { padding: .2em .7em; text-align: left; vertical-align: top }
th { border-bottom: 1px solid #888 } td.n { text-align: right; white-space: nowrap } tr.f td { background: #fbdcd0 }
tr.chapter td { padding-top: 1em; font-weight: bold }
.formula { margin: 1em 0 1em 1.5em } .formula img { display: block; margin: .5em 0; max-width: 100% }
.plot { width: 100%; max-width: 760px } .failed { background: #d55e00; color: white; padding: .1em .6em; font-weight: bold }
.passed { color: #00714f } .bar { display: inline-block; height: .7em; background: #0072b2 } a { color: #005a8c }
section { margin-bottom: 3.5em } .series { font-size: 12px }
@media print { section { break-before: page; margin: 0 } h2.chapter { break-before: page } h2 + section { break-before: auto }
  body { font-size: 12px; margin: 0; max-width: none } a { color: inherit; text-decoration: none } }
"""


def prose(text):
    """Text of a page, with its exponents raised."""
    return re.sub(r"\^(-?\d+)", r"<sup>\1</sup>", html.escape(text))


def anchor(page):
    return page["test"].replace(".", "-")


def figure_of(value):
    return "no number" if math.isnan(value) else f"{value:.2g}"


def share_of(page):
    share = page["largest"]["share"]
    return "no number" if math.isnan(share) else f"{100 * share:.0f} %" if share >= 0.01 or share == 0 else "&lt; 1 %"


def verdict(page):
    return '<span class="passed">passed</span>' if page["passed"] else '<span class="failed">FAILED</span>'


def section_of(page):
    text = [f'<section id="{anchor(page)}"><h3>{prose(page["claim"])}</h3>',
            f'<div class="test">{html.escape(page["test"])} &middot; {html.escape(page["file"])}:{page["line"]}</div>',
            '<div class="formula">']
    text += [formula_picture(line.strip().replace(r"\frac", r"\dfrac")) for line in page["formula"].split("\n") if line.strip()]
    text.append("</div>")
    if page["symbols"]:
        text.append("<table>")
        for symbol in page["symbols"]:
            unit = f"[{prose(symbol['unit'])}]" if symbol["unit"] else ""
            text.append(f"<tr><td>{formula_picture(symbol['symbol'], 11)}</td><td>{prose(symbol['meaning'])}</td>"
                        f"<td>{unit}</td></tr>")
        text.append("</table>")
    if any(series["x"] or series["curve_x"] for series in page["series"]):
        try:
            text.append(draw(page))
        except (ValueError, OverflowError) as error:
            raise BadPage(f'{page["test"]}: error: cannot be plotted: {error}') from error
    names = list(dict.fromkeys(series["name"] for series in page["series"] if series["name"]))
    if len(names) > LEGEND_AT_MOST:
        text.append(f'<p class="series">{len(names)} series: {html.escape("; ".join(names))}.</p>')
    largest, count = page["largest"], sum(len(series["x"]) for series in page["series"])
    unit = prose(page["y"]["unit"])
    text.append(f"<p>{verdict(page)}: {count} comparison{'s' if count != 1 else ''}; the one nearest to its tolerance differs by "
                f"{figure_of(largest['deviation'])} {unit} where {figure_of(largest['tolerance'])} {unit} is allowed "
                f"({share_of(page)}).<br>Source: {prose(page['source'])}</p></section>")
    return "\n".join(text)


def summary_of(pages, missing):
    text = ["<table><tr><th>Test</th><th>deviation</th><th>tolerance</th><th>share</th><th></th></tr>"]
    for chapter, group in itertools.groupby(pages, key=lambda page: page["chapter"]):
        text.append(f'<tr class="chapter"><td colspan="5">{html.escape(chapter)}</td></tr>')
        for page in group:
            largest = page["largest"]
            width = 0 if math.isnan(largest["share"]) else 6 * min(1, largest["share"])
            text.append(f'<tr class="{"p" if page["passed"] else "f"}"><td><a href="#{anchor(page)}">'
                        f'{prose(page["claim"])}</a></td><td class="n">{figure_of(largest["deviation"])}</td>'
                        f'<td class="n">{figure_of(largest["tolerance"])}</td><td class="n">{share_of(page)}</td>'
                        f'<td>{"" if page["passed"] else verdict(page)}'
                        f'<span class="bar" style="width:{width:.2f}em"></span></td></tr>')
    text += [f'<tr class="f"><td class="test">{html.escape(name)}</td><td colspan="4"><span class="failed">NO PAGE</span>'
             " the test did not run to its end</td></tr>" for name in missing]
    return "\n".join(text + ["</table>"])


def run(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def document(pages, missing):
    chapters = [(name, list(group)) for name, group in itertools.groupby(pages, key=lambda page: page["chapter"])]
    failed = sum(not page["passed"] for page in pages) + len(missing)
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    text = ['<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>murosimf: validation book</title>',
            f"<style>{STYLE}</style></head><body><h1>murosimf: validation book</h1>",
            "<p>What the tests of this program compare with closed forms: formula, theory and simulated points, tolerance "
            "and source. A page is written by the test itself, with the numbers that it checks.</p>",
            f'<p>State of the code: <code>{html.escape(run("git", "describe", "--always", "--dirty", "--tags"))}</code>, '
            f'commit of {html.escape(run("git", "log", "-1", "--format=%cs"))}. Made {now} by <code>make book</code> on '
            f"{html.escape(platform.machine())}, matplotlib {html.escape(matplotlib.__version__)}.</p>",
            f"<p><b>{len(pages)} pages</b>, {failed} failed. In the plots: lines are theory, marks are what the simulator "
            "gave, bars what the test allows; below, the deviation in shares of the tolerance.</p><h2>Contents</h2><ol>"]
    text += [f'<li><a href="#chapter-{i}">{html.escape(name)}</a> ({len(group)})</li>'
             for i, (name, group) in enumerate(chapters, 1)]
    text += ["</ol><h2>Summary</h2>",
             "<p>Of each test the comparison that came nearest to its tolerance, in the unit of its page.</p>",
             summary_of(pages, missing)]
    for i, (name, group) in enumerate(chapters, 1):
        text.append(f'<h2 class="chapter" id="chapter-{i}">{i}. {html.escape(name)}</h2>')
        text += [section_of(page) for page in group]
    return "\n".join(text + ["</body></html>\n"]), failed


def main():
    parser = argparse.ArgumentParser(description="Draws the validation book of the pages that tests wrote.")
    parser.add_argument("pages", help="folder of the tests' *.json")
    parser.add_argument("out", help="the book, HTML")
    parser.add_argument("--expected", type=argparse.FileType("r"), help="names of tests that must have a page")
    options = parser.parse_args()
    plt.rcParams.update({"svg.hashsalt": "book", "font.size": 9, "axes.formatter.useoffset": False,
                         "axes.formatter.limits": (-4, 5), "axes.spines.top": False, "axes.spines.right": False})
    try:
        if not os.path.isdir(options.pages):
            raise BadPage(f"{options.pages}: error: no such folder")
        pages = read_tests(options.pages)
        names = {page["test"] for page in pages}
        expected = [line.strip() for line in options.expected or [] if line.strip()]
        missing = [name for name in expected if name not in names]
        text, failed = document(pages, missing)
    except BadPage as error:
        sys.stderr.write(f"{error}\n")
        return 2
    with open(options.out, "w", encoding="utf-8") as file:
        file.write(text)
    print(f"{options.out}: {len(pages)} pages, {failed} failed")
    for name in [page["test"] for page in pages if not page["passed"]] + missing:
        sys.stderr.write(f"error: failed: {name}\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
