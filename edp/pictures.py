#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the files of contactpicture as the paper shows such results: meshes, deformed body, map of eps_E, contact pressures; solids
by solid_pictures.py.

usage: pictures.py FOLDER    (that contactpicture named; the pictures go there too)
"""
import io
import pathlib
import re
import sys
import xml.etree.ElementTree

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.ticker import FuncFormatter
from PIL import Image

INK, GREY, BLUE, RED = "#1a1a1a", "#8c8c8c", "#2b5c8a", "#b5342b"
WIDTH = 6.8  # inches
MOST_LINES = 8

plt.rcParams.update({
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 11, "axes.titlesize": 11,
    "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.direction": "in",
    "ytick.direction": "in", "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK,
    "ytick.color": INK, "legend.frameon": False, "legend.fontsize": 10})


class Step:
    """What one call of contactpicture wrote."""

    def __init__(self, folder, number):
        bodies = [read_body(file) for file in files_of_bodies(folder, number)]
        first = np.cumsum([0] + [len(body["points"]) for body in bodies])
        self.points = np.vstack([body["points"] for body in bodies])
        self.triangles = np.vstack([body["triangles"] + start for body, start in zip(bodies, first)])
        self.displacement = np.vstack([body["displacement"] for body in bodies])
        self.on_foundation = pieces_of(self.triangles).max() == 0
        head, self.nodes = read_nodes(folder / f"contact{number}.txt")
        self.line = self.nodes.get("line", np.ones(len(self.nodes["x"]))).astype(int)
        self.facing = np.column_stack([self.nodes["facingx"], self.nodes["facingy"]])
        self.is_coulomb, self.is_bonded = head["law"] == "coulomb", head["law"] == "bonded"
        self.is_judged = "eps" in head
        if self.is_judged:
            self.eps = float(head["eps"])
            self.error = np.hstack([body["eps_E"] for body in bodies])
            edges = np.loadtxt(folder / f"tractions{number}.txt", ndmin=2)
            self.edges = edges[:, :6].reshape(-1, 2, 3)
            self.line_of_edge = edges[:, 6].astype(int) if edges.shape[1] > 6 else np.ones(len(edges), int)
        largest = np.linalg.norm(self.displacement, axis=1).max()
        self.scale = round_down(0.08 * np.ptp(self.points, axis=0).max() / largest) if largest > 0 else 1
        self.moved = self.points + self.scale * self.displacement

    def limits(self):
        """Lower left and upper right corner of the body before and after its deformation."""
        all_points = np.vstack([self.points, self.moved, self.facing])
        low, high = all_points.min(axis=0), all_points.max(axis=0)
        pad = 0.02 * (high - low).max()
        return low - pad, high + pad

    def lines(self):
        """The numbers of the contact lines, those with the largest pressures where there are too many to draw."""
        numbers = np.unique(self.line)
        largest = [np.abs(self.nodes["pn"][self.line == k]).max() for k in numbers]
        return np.sort(numbers[np.argsort(largest)[::-1][:MOST_LINES]])

    def boundary(self):
        edges = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        unique, count = np.unique(edges, axis=0, return_counts=True)
        return unique[count == 1]


def pieces_of(cells):
    """The piece of each cell, from 0 on; pieces share no vertex."""
    lowest = np.arange(cells.max() + 1)
    while True:
        before = lowest.copy()
        np.minimum.at(lowest, cells, lowest[cells].min(axis=1, keepdims=True))
        lowest = lowest[lowest]
        if (lowest == before).all():
            return np.unique(lowest[cells[:, 0]], return_inverse=True)[1]


def read_body(path):
    """Points, triangles, displacements and, if it was judged, contributions to the error of one body."""
    arrays = {}
    for node in xml.etree.ElementTree.parse(path).iter("DataArray"):
        values = np.array(node.text.split(), int if node.get("type").startswith("Int") else float)
        components = int(node.get("NumberOfComponents"))
        arrays[node.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return {**arrays, "points": arrays["points"][:, :2], "displacement": arrays["displacement"][:, :2],
            "triangles": arrays["connectivity"]}


def read_nodes(path):
    """The words of the first line and the columns by name."""
    with open(path) as file:
        words, names = file.readline().split()[1:], file.readline().split()[1:]
    return dict(zip(words[::2], words[1::2])), dict(zip(names, np.loadtxt(path, ndmin=2).T))


def round_down(value):
    """The largest 1, 2 or 5 times a power of ten that is at most `value`."""
    power = 10.0 ** np.floor(np.log10(value))
    return power * max(digit for digit in (1, 2, 5) if digit * power <= value)


def files_of_bodies(folder, number):
    """Those of step 1 are not those of step 10."""
    return [file for file in sorted(folder.glob(f"step{number}*.vtu")) if re.fullmatch(rf"step{number}[a-z]?\.vtu", file.name)]


def steps_in(folder):
    """The numbers of the steps in a folder, ascending."""
    names = (re.fullmatch(r"contact(\d+)\.txt", file.name) for file in folder.iterdir())
    return sorted(int(name[1]) for name in names if name)


def is_of_solids(folder):
    with open(folder / f"contact{steps_in(folder)[0]}.txt") as file:
        file.readline()
        return file.readline().startswith("# x y z ")


def finish(axes, title):
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, pad=2)


def outline(points, edges, **style):
    return LineCollection(points[edges], **{"colors": INK, "linewidths": 0.9, "capstyle": "round", **style})


def fine_line(step, usual):
    """The width of lines that leaves some white between many triangles."""
    return usual * min(1, np.sqrt(5000 / len(step.triangles)))


def draw_mesh(axes, step, name):
    axes.add_collection(PolyCollection(step.points[step.triangles], facecolors="none", edgecolors=INK, linewidths=fine_line(step, 0.35)))
    axes.add_collection(outline(step.points, step.boundary()))
    percent = 100 * step.eps if step.is_judged else 0
    error = f", $\\epsilon$ = {percent:{'.2f' if percent > 0.005 else '.0e'}} %" if step.is_judged else ""
    finish(axes, f"{name}: {len(step.triangles)} triangles{error}")


def draw_foundation(axes, line):
    """What the contact line faces, hatched on its outer side."""
    length = np.insert(np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum(), 0, 0)
    places = np.linspace(0.02, 1, 50) * length[-1]
    ends = np.column_stack([np.interp(places, length, coordinate) for coordinate in line.T])
    before = np.column_stack([np.interp(places - 0.02 * length[-1], length, coordinate) for coordinate in line.T])
    along = (ends - before) / 0.02
    slanted = 0.018 * (np.column_stack([along[:, 1], -along[:, 0]]) - along)
    axes.plot(*line.T, color=INK, linewidth=1.2, solid_capstyle="butt")
    axes.add_collection(LineCollection(np.stack([ends, ends + slanted], 1), colors=GREY, linewidths=0.7, clip_on=False))


def draw_deformed(axes, step):
    shapes = step.moved[step.triangles]
    axes.add_collection(PolyCollection(shapes, facecolors="#e6ecf2", edgecolors=INK, linewidths=fine_line(step, 0.3)))
    axes.add_collection(outline(step.moved, step.boundary()))
    axes.add_collection(outline(step.points, step.boundary(), colors=RED, linewidths=0.8, linestyles=(0, (5, 3))))
    for k in step.lines():
        if step.on_foundation:
            draw_foundation(axes, step.facing[step.line == k])
    number_lines(axes, step)
    finish(axes, f"Deformed {'body' if step.on_foundation else 'bodies'}, displacement × {step.scale:g}")


def number_lines(axes, step):
    """The numbers of several lines beside them, where they are in the deformed body."""
    if len(step.lines()) < 2:
        return
    places = np.column_stack([step.nodes[name] for name in ("x", "y")])
    moves = np.column_stack([step.nodes[name] for name in ("ux", "uy")])
    for k in step.lines():
        of_line = (places + step.scale * moves)[step.line == k]
        x, y = of_line[len(of_line) // 2]
        axes.annotate(str(k), (x, y), ha="center", va="center", fontsize=8, color="white",
                      bbox={"boxstyle": "circle,pad=0.2", "facecolor": BLUE, "edgecolor": "white", "linewidth": 0.6})


def draw_error(axes, step):
    percent = 100 * step.error
    scale = LogNorm(percent.max() / 300, percent.max(), clip=True)
    colours = axes.tripcolor(*step.points.T, step.triangles, facecolors=percent, cmap="YlOrRd", norm=scale,
                             edgecolors="face", linewidth=0.4)
    axes.add_collection(outline(step.points, step.boundary()))
    finish(axes, "Contributions to the error")
    low, high = step.points.min(axis=0), step.points.max(axis=0)
    bottom, height = low[1], (high - low)[1]
    if height < 0.1 * (high - low)[0]:  # a flat body
        bottom, height = axes.get_ylim()[0], np.ptp(axes.get_ylim())
    place = [high[0] + 0.02 * (high - low)[0], bottom, 0.03 * min(np.ptp(axes.get_xlim()), 8 * height), height]
    bar = axes.figure.colorbar(colours, cax=axes.inset_axes(place, transform=axes.transData))
    bar.set_label(r"$\epsilon_E$  [%]", labelpad=1)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(which="both", length=2)


def draw_line(axes, step, k, single):
    """Pressures and tractions along one contact line."""
    nodes = {name: values[step.line == k] for name, values in step.nodes.items()}
    abscissa, friction, limit = nodes["abscissa"], nodes["friction"], nodes["limit"]
    bound = np.minimum(friction * np.abs(nodes["pn"]), limit) if step.is_coulomb else limit
    dots = {"linewidth": 1.1, "marker": "o", "markersize": 2.4 if single else 1.8}
    name = r"$\pm\mu|\lambda_{hn}|$" if step.is_coulomb else r"$\pm k$"
    if not step.is_bonded:
        axes.fill_between(abscissa, -bound, bound, color="#e2e2e2", linewidth=0, label=name)
    axes.axhline(0, color=GREY, linewidth=0.5)
    axes.plot(abscissa, -nodes["pn"], color=INK, label=r"$-\lambda_{hn}$", **dots)
    axes.plot(abscissa, -nodes["pt"], color=BLUE, label=r"$-\lambda_{ht}$", **dots)
    if step.is_judged:
        draw_tractions(axes, step, k, nodes)
    axes.set(xlim=shown_part(abscissa, nodes["pn"]))
    pressed = abscissa[nodes["pn"] < 0]
    force = abs(np.sum(0.5 * (nodes["pn"][1:] + nodes["pn"][:-1]) * np.diff(abscissa)))
    mean = force / np.ptp(pressed) if pressed.size > 1 else 0
    if -nodes["pn"].min() > 20 * mean > 0:  # an infinite pressure at an end would hide the others
        axes.set(ylim=(-mean, 6 * mean))
    axes.spines[["top", "right"]].set_visible(False)


def shown_part(abscissa, pressure):
    """All of a line, or the part about its pressures where these are on a small one."""
    low, high = abscissa.min(), abscissa.max()
    pressed = abscissa[pressure < 0] if (pressure < 0).any() else abscissa
    if np.ptp(pressed) < 0.2 * (high - low):
        pad = max(np.ptp(pressed), 0.05 * (high - low))
        low, high = max(low, pressed.min() - pad), min(high, pressed.max() + pad)
    return (low, high) if high > low else (low - 1, high + 1)


def draw_tractions(axes, step, k, nodes):
    broken = np.insert(step.edges[step.line_of_edge == k], 2, np.nan, axis=1).reshape(-1, 3)  # a gap after each edge
    if step.is_coulomb:
        order = np.argsort(nodes["abscissa"])  # of the second body it falls
        friction, limit = (np.interp(broken[:, 0], nodes["abscissa"][order], nodes[name][order]) for name in ("friction", "limit"))
        bound = np.minimum(friction * np.abs(broken[:, 1]), limit)
        for side in (1, -1):
            axes.plot(broken[:, 0], side * bound, color=RED, linewidth=0.7, linestyle=(0, (2, 2)),
                      label=r"$\pm\mu|r_n|$" if side > 0 else None)
    axes.plot(broken[:, 0], -broken[:, 2], color=RED, linewidth=1.3, label=r"$-r_t$")


LINE_HEIGHT = 1.55  # inches, of one of several lines


def step_of_pressures(first, last):
    """The first one, as in the paper, where its lines have enough nodes to tell."""
    enough = len(first.line) > 8 * len(first.lines())
    return first if enough or len(last.triangles) == len(first.triangles) else last


def height_of_pressures(step):
    """Of draw_pressures [inches]."""
    rows = (len(step.lines()) + 1) // 2
    return 3.1 if len(step.lines()) == 1 else 0.7 + rows * (LINE_HEIGHT + 0.35)


def draw_pressures(figure, top, step, where):
    """Every contact line on axes of its own."""
    lines = step.lines()
    title = "computed $\\lambda_h$" + (", admissible $r$" if step.is_judged else "")
    if len(lines) == 1:
        panels = [new_axes(figure, 0.7, top + 0.62, WIDTH - 0.85, 1.95)]
    else:
        width = (WIDTH - 0.6) / 2
        panels = [new_axes(figure, 0.5 + i % 2 * (width + 0.1), top + 0.72 + i // 2 * (LINE_HEIGHT + 0.35), width - 0.4, LINE_HEIGHT - 0.2)
                  for i in range(len(lines))]
    for axes, k in zip(panels, lines):
        draw_line(axes, step, k, len(lines) == 1)
        if len(lines) > 1:
            axes.annotate(str(k), (0.5, 1.04), xycoords="axes fraction", ha="center", va="center", fontsize=8, color="white",
                          bbox={"boxstyle": "circle,pad=0.2", "facecolor": BLUE, "edgecolor": "white", "linewidth": 0.6})
            axes.tick_params(labelsize=8)
    if len(lines) == 1:
        panels[0].set(xlabel="contact line  [mm]", ylabel="pressure  [MPa]")
    down = figure.get_size_inches()[1]
    several = f" along the {len(lines)} contact lines  [mm, MPa]" if len(lines) > 1 else ""
    figure.text(0.5, 1 - (top + 0.2) / down, f"Contact pressures{several}{where}: {title}", ha="center", va="center", fontsize=11)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="center", bbox_to_anchor=(0.5, 1 - (top + 0.45) / down), ncols=5, handlelength=1.8,
                  columnspacing=1.8, borderaxespad=0.2)


def new_axes(figure, left, top, width, height):
    """Axes placed in inches from the upper left corner."""
    across, down = figure.get_size_inches()
    return figure.add_axes([left / across, 1 - (top + height) / down, width / across, height / down])


def body_axes(figure, left, top, width, step):
    """Axes for a body, as high as its shape asks for."""
    low, high = step.limits()
    axes = new_axes(figure, left, top, width, width * (high - low)[1] / (high - low)[0])
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    return axes


def save(figure, path, dpi):
    """A PNG of at most 256 colours, a third of the size."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=dpi, facecolor="white")
    plt.close(figure)
    picture = Image.open(buffer).convert("RGB")
    picture = picture.quantize(256, method=Image.Quantize.MAXCOVERAGE, kmeans=3, dither=Image.Dither.NONE)
    picture.save(path, optimize=True)
    print(path)


def draw_bounds(folder, files):
    """Intervals of quantities by the number of triangles. A file has a value to compare with and a title, then the triangles, lower and
    upper bound of each mesh."""
    figure, panels = plt.subplots(1, len(files), figsize=(WIDTH, 2.6), squeeze=False, layout="constrained")
    for axes, file in zip(panels[0], files):
        value, title = file.read_text().split("\n")[0].split(maxsplit=1)
        triangles, lower, upper = np.loadtxt(file, skiprows=1, ndmin=2).T
        axes.vlines(triangles, lower, upper, color=BLUE, linewidth=2.5)
        axes.plot(triangles, (lower + upper) / 2, ".", color=BLUE, markersize=4)
        axes.axhline(float(value), color=RED, linewidth=0.8, zorder=0)
        axes.set(xscale="log", xlabel="triangles", title=title)
        axes.set_xticks(triangles[[0, 1, -1]], [f"{n:.0f}" for n in triangles[[0, 1, -1]]])
        axes.minorticks_off()
    save(figure, folder / "bounds.png", 150)


def draw(folder):
    numbers = steps_in(folder)
    first, last = Step(folder, numbers[0]), Step(folder, numbers[-1])
    low, high = first.limits()
    aspect = (high - low)[1] / (high - low)[0]
    is_adapted = len(last.triangles) != len(first.triangles)
    panels = {"mesh_first": lambda axes: draw_mesh(axes, first, "First mesh" if is_adapted else "Mesh")}
    if first.is_judged:
        panels["error"] = lambda axes: draw_error(axes, first)
    panels["deformed"] = lambda axes: draw_deformed(axes, first)
    if is_adapted:
        panels["mesh_last"] = lambda axes: draw_mesh(axes, last, "Last mesh")
    title, bar, gap = 0.32, 0.62, 0.1  # inches

    width = min(WIDTH - bar - gap, 4.2 / aspect)
    for name, paint in panels.items():
        figure = plt.figure(figsize=(width + (bar if name == "error" else gap) + gap, width * aspect + title + gap))
        paint(body_axes(figure, gap, title, width, first))
        save(figure, folder / f"{name}.png", 200)
    of_pressures = step_of_pressures(first, last)
    where = "" if not is_adapted else f" on the {'first' if of_pressures is first else 'last'} mesh"
    figure = plt.figure(figsize=(WIDTH, height_of_pressures(of_pressures)))
    draw_pressures(figure, 0, of_pressures, where)
    save(figure, folder / "pressures.png", 200)

    across = 2 if aspect > 0.2 else 1  # flat bodies one below the other
    width = (WIDTH - bar - gap) / across
    height = width * aspect + title
    bodies = (len(panels) + across - 1) // across * height
    figure = plt.figure(figsize=(WIDTH, bodies + height_of_pressures(of_pressures)))
    for k, paint in enumerate(panels.values()):
        paint(body_axes(figure, k % across * (width + gap), title + k // across * height, width, first))
    draw_pressures(figure, bodies, of_pressures, where)
    save(figure, folder / "overview.png", 150)
    if files := sorted(folder.glob("bounds*.txt")):
        draw_bounds(folder, files)


if __name__ == "__main__":
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir() or not steps_in(pathlib.Path(sys.argv[1])):
        sys.exit(__doc__ + "\nno contactN.txt there: call contactpicture first (examples: -out FOLDER)")
    if is_of_solids(pathlib.Path(sys.argv[1])):
        import solid_pictures

        solid_pictures.draw(pathlib.Path(sys.argv[1]))
    else:
        draw(pathlib.Path(sys.argv[1]))
