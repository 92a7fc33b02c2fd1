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

plt.rcParams.update({
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 11, "axes.titlesize": 11,
    "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.direction": "in",
    "ytick.direction": "in", "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK,
    "ytick.color": INK, "legend.frameon": False, "legend.fontsize": 10})


class Step:
    """What one call of contactpicture wrote."""

    def __init__(self, folder, number):
        bodies = [read_body(file) for file in sorted(folder.glob(f"step{number}*.vtu"))
                  if re.fullmatch(f"step{number}[a-z]?.vtu", file.name)]
        self.on_foundation = len(bodies) == 1
        first = np.cumsum([0] + [len(body["points"]) for body in bodies])
        self.points = np.vstack([body["points"] for body in bodies])
        self.triangles = np.vstack([body["triangles"] + start for body, start in zip(bodies, first)])
        self.displacement = np.vstack([body["displacement"] for body in bodies])
        head, self.nodes = read_nodes(folder / f"contact{number}.txt")
        self.facing = np.column_stack([self.nodes["facingx"], self.nodes["facingy"]])
        self.is_coulomb = head["law"] == "coulomb"
        self.is_judged = "eps" in head
        if self.is_judged:
            self.eps = float(head["eps"])
            self.error = np.hstack([body["eps_E"] for body in bodies])
            self.edges = np.loadtxt(folder / f"tractions{number}.txt", ndmin=2).reshape(-1, 2, 3)
        largest = np.linalg.norm(self.displacement, axis=1).max()
        self.scale = round_down(0.08 * np.ptp(self.points, axis=0).max() / largest) if largest > 0 else 1
        self.moved = self.points + self.scale * self.displacement

    def limits(self):
        """Lower left and upper right corner of the body before and after its deformation."""
        all_points = np.vstack([self.points, self.moved, self.facing])
        low, high = all_points.min(axis=0), all_points.max(axis=0)
        pad = 0.02 * (high - low).max()
        return low - pad, high + pad

    def boundary(self):
        edges = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        unique, count = np.unique(edges, axis=0, return_counts=True)
        return unique[count == 1]


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


def draw_mesh(axes, step, name):
    axes.add_collection(PolyCollection(step.points[step.triangles], facecolors="none", edgecolors=INK, linewidths=0.35))
    axes.add_collection(outline(step.points, step.boundary()))
    error = f", $\\epsilon$ = {100 * step.eps:.2f} %" if step.is_judged else ""
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
    axes.add_collection(PolyCollection(shapes, facecolors="#e6ecf2", edgecolors=INK, linewidths=0.3))
    axes.add_collection(outline(step.moved, step.boundary()))
    axes.add_collection(outline(step.points, step.boundary(), colors=RED, linewidths=0.8, linestyles=(0, (5, 3))))
    if step.on_foundation:
        draw_foundation(axes, step.facing)
    finish(axes, f"Deformed {'body' if step.on_foundation else 'bodies'}, displacement × {step.scale:g}")


def draw_error(axes, step):
    percent = 100 * step.error
    scale = LogNorm(percent.max() / 300, percent.max(), clip=True)
    colours = axes.tripcolor(*step.points.T, step.triangles, facecolors=percent, cmap="YlOrRd", norm=scale,
                             edgecolors="face", linewidth=0.4)
    axes.add_collection(outline(step.points, step.boundary()))
    finish(axes, "Contributions to the error")
    low, high = step.points.min(axis=0), step.points.max(axis=0)
    place = [high[0] + 0.02 * (high - low)[0], low[1], 0.03 * (high - low)[0], (high - low)[1]]
    bar = axes.figure.colorbar(colours, cax=axes.inset_axes(place, transform=axes.transData))
    bar.set_label(r"$\epsilon_E$  [%]", labelpad=1)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(which="both", length=2)


def draw_pressures(axes, step):
    nodes = step.nodes
    abscissa, friction, limit = nodes["abscissa"], nodes["friction"], nodes["limit"]
    bound = np.minimum(friction * np.abs(nodes["pn"]), limit) if step.is_coulomb else limit
    dots = {"linewidth": 1.1, "marker": "o", "markersize": 2.4}
    name = r"$\pm\mu|\lambda_{hn}|$" if step.is_coulomb else r"$\pm k$"
    axes.fill_between(abscissa, -bound, bound, color="#e2e2e2", linewidth=0, label=name)
    axes.axhline(0, color=GREY, linewidth=0.5)
    axes.plot(abscissa, -nodes["pn"], color=INK, label=r"$-\lambda_{hn}$", **dots)
    axes.plot(abscissa, -nodes["pt"], color=BLUE, label=r"$-\lambda_{ht}$", **dots)
    title = "computed $\\lambda_h$"
    if step.is_judged:
        draw_tractions(axes, step)
        title += ", admissible $r$"
    axes.set(xlim=(abscissa.min(), abscissa.max()), xlabel="contact line  [mm]", ylabel="pressure  [MPa]")
    axes.set_title(f"Contact pressures on the first mesh: {title}", pad=22)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 0.985), ncols=5, handlelength=1.8, columnspacing=1.8,
                borderaxespad=0.2)
    axes.spines[["top", "right"]].set_visible(False)


def draw_tractions(axes, step):
    broken = np.insert(step.edges, 2, np.nan, axis=1).reshape(-1, 3)  # a gap after each edge
    if step.is_coulomb:
        bound = np.minimum(np.interp(broken[:, 0], step.nodes["abscissa"], step.nodes["friction"]) * np.abs(broken[:, 1]),
                           np.interp(broken[:, 0], step.nodes["abscissa"], step.nodes["limit"]))
        for side in (1, -1):
            axes.plot(broken[:, 0], side * bound, color=RED, linewidth=0.7, linestyle=(0, (2, 2)),
                      label=r"$\pm\mu|r_n|$" if side > 0 else None)
    axes.plot(broken[:, 0], -broken[:, 2], color=RED, linewidth=1.3, label=r"$-r_t$")


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


def draw(folder):
    numbers = steps_in(folder)
    first, last = Step(folder, numbers[0]), Step(folder, numbers[-1])
    low, high = first.limits()
    aspect = (high - low)[1] / (high - low)[0]
    panels = {"mesh_first": lambda axes: draw_mesh(axes, first, "First mesh")}
    if first.is_judged:
        panels["error"] = lambda axes: draw_error(axes, first)
    panels["deformed"] = lambda axes: draw_deformed(axes, first)
    if len(last.triangles) != len(first.triangles):
        panels["mesh_last"] = lambda axes: draw_mesh(axes, last, "Optimised mesh")
    title, bar, gap = 0.32, 0.62, 0.1  # inches

    width = min(WIDTH - bar - gap, 4.2 / aspect)
    for name, paint in panels.items():
        figure = plt.figure(figsize=(width + (bar if name == "error" else gap) + gap, width * aspect + title + gap))
        paint(body_axes(figure, gap, title, width, first))
        save(figure, folder / f"{name}.png", 200)
    figure = plt.figure(figsize=(WIDTH, 3.2))
    draw_pressures(new_axes(figure, 0.6, 0.62, WIDTH - 0.75, 2.05), first)
    save(figure, folder / "pressures.png", 200)

    width = (WIDTH - bar - gap) / 2
    height = width * aspect + title
    figure = plt.figure(figsize=(WIDTH, 2 * height + 3.1))
    for k, paint in enumerate(panels.values()):
        paint(body_axes(figure, k % 2 * (width + gap), title + k // 2 * height, width, first))
    draw_pressures(new_axes(figure, 0.6, 2 * height + 0.62, WIDTH - 0.75, 1.95), first)
    save(figure, folder / "overview.png", 150)


if __name__ == "__main__":
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir() or not steps_in(pathlib.Path(sys.argv[1])):
        sys.exit(__doc__ + "\nno contactN.txt there: call contactpicture first (examples: -out FOLDER)")
    if is_of_solids(pathlib.Path(sys.argv[1])):
        import solid_pictures

        solid_pictures.draw(pathlib.Path(sys.argv[1]))
    else:
        draw(pathlib.Path(sys.argv[1]))
