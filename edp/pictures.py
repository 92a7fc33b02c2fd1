#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the result files of an example as the paper shows them: meshes, deformed body, map of eps_E, contact pressures.

usage: pictures.py FOLDER    (what -out named; the pictures go there too)
"""
import base64
import io
import pathlib
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
    """One mesh of a run, or the meshes of both bodies."""

    def __init__(self, folder, row):
        number = row["step"]
        files = [folder / f"step{number}{suffix}.vtu" for suffix in ("", "b")]
        bodies = [read_body(file) for file in files if file.is_file()]
        self.on_foundation = len(bodies) == 1
        first = np.cumsum([0] + [len(body["points"]) for body in bodies])
        self.points = np.vstack([body["points"] for body in bodies])
        self.triangles = np.vstack([body["triangles"] + start for body, start in zip(bodies, first)])
        self.displacement = np.vstack([body["displacement"] for body in bodies])
        self.error = np.hstack([body["error"] for body in bodies])
        self.nodes = np.loadtxt(folder / f"contact{number}.txt", ndmin=2)
        self.edges = np.loadtxt(folder / f"tractions{number}.txt", ndmin=2).reshape(-1, 2, 3)
        self.eps, self.friction = float(row["eps"]), float(row["friction"])
        largest = np.linalg.norm(self.displacement, axis=1).max()
        self.scale = round_down(0.08 * np.ptp(self.points, axis=0).max() / largest)
        self.moved = self.points + self.scale * self.displacement

    def limits(self):
        """Lower left and upper right corner of the body before and after its deformation."""
        low, high = np.minimum(self.points, self.moved).min(axis=0), np.maximum(self.points, self.moved).max(axis=0)
        pad = 0.02 * (high - low).max()
        return low - pad, high + pad

    def boundary(self):
        edges = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        unique, count = np.unique(edges, axis=0, return_counts=True)
        return unique[count == 1]


def read_vtu(path):
    """Arrays of a VTK file by name; its data are in base64 after their length, as FreeFEM's savevtk writes them."""
    types = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "<u1"}
    arrays = {}
    for node in xml.etree.ElementTree.parse(path).iter("DataArray"):
        values = np.frombuffer(base64.b64decode(node.text)[4:], types[node.get("type")])
        components = int(node.get("NumberOfComponents", 1))
        arrays[node.get("Name") or "points"] = values.reshape(-1, components) if components > 1 else values
    return arrays


def read_body(path):
    """Points, triangles, displacements and contributions to the error of one body."""
    arrays = read_vtu(path)
    is_triangle = arrays["types"] == 5
    return {"points": arrays["points"][:, :2], "displacement": arrays["displacement"][:, :2],
            "triangles": arrays["connectivity"][:3 * is_triangle.sum()].reshape(-1, 3),
            "error": arrays["eps_E"][is_triangle]}


def round_down(value):
    """The largest 1, 2 or 5 times a power of ten that is at most `value`."""
    power = 10.0 ** np.floor(np.log10(value))
    return power * max(digit for digit in (1, 2, 5) if digit * power <= value)


def read_rows(folder):
    """The result lines of a run, one a step."""
    lines = (folder / "results.txt").read_text().splitlines()
    return [dict(word.split("=", 1) for word in line.split()[1:]) for line in lines]


def finish(axes, title):
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, pad=2)


def outline(points, edges, **style):
    return LineCollection(points[edges], **{"colors": INK, "linewidths": 0.9, "capstyle": "round", **style})


def draw_mesh(axes, step, name):
    axes.add_collection(PolyCollection(step.points[step.triangles], facecolors="none", edgecolors=INK, linewidths=0.35))
    axes.add_collection(outline(step.points, step.boundary()))
    finish(axes, f"{name}: {len(step.triangles)} triangles, $\\epsilon$ = {100 * step.eps:.2f} %")


def draw_foundation(axes, line):
    """The contact line, hatched on its outer side."""
    length = np.linalg.norm(line[-1] - line[0])
    along = (line[-1] - line[0]) / length
    slanted = 0.018 * length * (np.array([along[1], -along[0]]) - along)
    ends = line[0] + np.linspace(0.02, 1, 50)[:, None] * (line[-1] - line[0])
    axes.plot(*line[[0, -1]].T, color=INK, linewidth=1.2, solid_capstyle="butt")
    axes.add_collection(LineCollection([(p, p + slanted) for p in ends], colors=GREY, linewidths=0.7, clip_on=False))


def draw_deformed(axes, step):
    shapes = step.moved[step.triangles]
    axes.add_collection(PolyCollection(shapes, facecolors="#e6ecf2", edgecolors=INK, linewidths=0.3))
    axes.add_collection(outline(step.moved, step.boundary()))
    axes.add_collection(outline(step.points, step.boundary(), colors=RED, linewidths=0.8, linestyles=(0, (5, 3))))
    if step.on_foundation:
        draw_foundation(axes, step.nodes[:, 6:8])
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
    abscissa, normal, tangential = step.nodes[:, 0], -step.nodes[:, 1], -step.nodes[:, 2]
    cone = step.friction * np.abs(normal)
    broken = np.insert(step.edges, 2, np.nan, axis=1).reshape(-1, 3)  # a gap after each edge
    dots = {"linewidth": 1.1, "marker": "o", "markersize": 2.4}
    axes.fill_between(abscissa, -cone, cone, color="#e2e2e2", linewidth=0, label=r"$\pm\mu|\lambda_{hn}|$")
    axes.axhline(0, color=GREY, linewidth=0.5)
    axes.plot(abscissa, normal, color=INK, label=r"$-\lambda_{hn}$", **dots)
    axes.plot(abscissa, tangential, color=BLUE, label=r"$-\lambda_{ht}$", **dots)
    for side in (1, -1):
        axes.plot(broken[:, 0], side * step.friction * broken[:, 1], color=RED, linewidth=0.7, linestyle=(0, (2, 2)),
                  label=r"$\pm\mu|r_n|$" if side > 0 else None)
    axes.plot(broken[:, 0], -broken[:, 2], color=RED, linewidth=1.3, label=r"$-r_t$")
    axes.set(xlim=(abscissa.min(), abscissa.max()), xlabel="contact line  [mm]", ylabel="pressure  [MPa]")
    axes.set_title("Contact pressures on the first mesh: computed $\\lambda_h$, admissible $r$", pad=22)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 0.985), ncols=5, handlelength=1.8, columnspacing=1.8,
                borderaxespad=0.2)
    axes.spines[["top", "right"]].set_visible(False)


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
    rows = read_rows(folder)
    first, last = Step(folder, rows[0]), Step(folder, rows[-1])
    low, high = first.limits()
    aspect = (high - low)[1] / (high - low)[0]
    panels = {
        "mesh_first": lambda axes: draw_mesh(axes, first, "First mesh"),
        "error": lambda axes: draw_error(axes, first),
        "deformed": lambda axes: draw_deformed(axes, first),
    }
    if len(rows) > 1:
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
    if len(sys.argv) != 2 or not (pathlib.Path(sys.argv[1]) / "results.txt").is_file():
        sys.exit(__doc__ + "\nno results.txt there: run the example with -out FOLDER first")
    draw(pathlib.Path(sys.argv[1]))
