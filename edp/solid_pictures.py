# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what contactpicture wrote of solids: surface meshes coloured by eps_E, a cut, the deformed bodies, contact pressures and cone."""
import xml.etree.ElementTree

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import FuncFormatter

from pictures import INK, RED, WIDTH, files_of_bodies, new_axes, pieces_of, read_nodes, round_down, save, steps_in

MOST_SHEETS, SHEET_HEIGHT = 6, 2.3  # inches
FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])  # of a tetrahedron, outward
MAP = plt.get_cmap("YlOrRd")


def read_cells(path):
    """The arrays of a .vtu file by name, a row each point or cell; connectivity as corners of cells."""
    arrays = {}
    for node in xml.etree.ElementTree.parse(path).iter("DataArray"):
        values = np.array(node.text.split(), int if node.get("type").startswith("Int") else float)
        components = int(node.get("NumberOfComponents"))
        arrays[node.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return arrays


class SolidStep:
    """What one call of contactpicture wrote of solids."""

    def __init__(self, folder, number):
        bodies = [read_cells(file) for file in files_of_bodies(folder, number)]
        first = np.cumsum([0] + [len(body["points"]) for body in bodies])
        self.points = np.vstack([body["points"] for body in bodies])
        self.cells = np.vstack([body["connectivity"] + start for body, start in zip(bodies, first)])
        self.displacement = np.vstack([body["displacement"] for body in bodies])
        head, self.nodes = read_nodes(folder / f"contact{number}.txt")
        self.surface = read_cells(folder / f"surface{number}.vtu")
        self.is_coulomb = head["law"] == "coulomb"
        self.is_judged = "eps" in head
        if self.is_judged:
            self.eps = float(head["eps"])
            self.error = np.hstack([body["eps_E"] for body in bodies])
        largest = np.linalg.norm(self.displacement, axis=1).max()
        self.scale = round_down(0.08 * np.ptp(self.points, axis=0).max() / largest) if largest > 0 else 1
        self.moved = self.points + self.scale * self.displacement

    def pressure_name(self):
        return "rn" if self.is_judged else "pn"

    def normal(self):
        """Of the contact surface in the mean."""
        normal = np.array([self.nodes[name].mean() for name in ("nx", "ny", "nz")])
        return normal / np.linalg.norm(normal)

    def centre(self):
        """Of the contact forces; of the contact nodes where there are none."""
        places = np.column_stack([self.nodes[name] for name in "xyz"])
        forces = -self.nodes["fn"]
        return places.T @ forces / forces.sum() if forces.sum() > 0 else places.mean(axis=0)


class Camera:
    """Parallel projection towards a place, with the contact surface in view at the lower side."""

    def __init__(self, normal):
        axes = [axis for axis in np.eye(3) if abs(axis @ normal) < 0.8]
        side = axes[-1] - (axes[-1] @ normal) * normal
        self.side = -side / np.linalg.norm(side)
        self.along = np.cross(normal, self.side)
        self.towards = self.side + 0.45 * normal - 0.5 * self.along  # the eye
        self.towards /= np.linalg.norm(self.towards)
        up = -normal - (-normal @ self.towards) * self.towards
        self.up = up / np.linalg.norm(up)
        self.right = np.cross(self.up, self.towards)

    def flat(self, points):
        return np.stack([points @ self.right, points @ self.up], -1)


def outer_faces(cells):
    """Faces of one tetrahedron only, outward, and these tetrahedra."""
    faces = cells[:, FACES].reshape(-1, 3)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    own = first[count == 1]
    return faces[own], own // 4


def draw_faces(axes, camera, points, faces, colours):
    """Faces towards the eye, the nearest last."""
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.maximum(np.linalg.norm(normals, axis=1), 1e-300) / 2
    normals /= 2 * areas[:, None]
    cosine = normals @ camera.towards
    order = np.argsort(corners.mean(axis=1) @ camera.towards)
    order = order[cosine[order] > 0]
    shade = 0.62 + 0.38 * np.clip(normals @ (camera.towards + 0.4 * camera.right + 0.3 * camera.up), 0, 1)
    colours = np.clip(colours[:, :3] * shade[:, None], 0, 1)
    sizes = np.sqrt(np.abs(normals[order] @ camera.towards) * areas[order])
    # edges of small faces would hide them
    dark = np.clip(30 * sizes / np.ptp(points, axis=0).max(), 0, 1)[:, None]
    axes.add_collection(PolyCollection(camera.flat(corners[order]), facecolors=colours[order], linewidths=0.3,
                                       edgecolors=(1 - 0.85 * dark) * colours[order]))
    axes.set_aspect("equal")
    axes.axis("off")
    axes.autoscale_view()


def scale_of(step):
    percent = 100 * step.error
    return LogNorm(max(percent.max() / 300, 1e-12), max(percent.max(), 1e-11), clip=True)


def colours_of(step):
    """Of each tetrahedron: its error where it is known."""
    return MAP(scale_of(step)(100 * step.error)) if step.is_judged else np.tile([0.9, 0.93, 0.95, 1], (len(step.cells), 1))


def draw_bar(axes, step):
    scalar = plt.cm.ScalarMappable(norm=scale_of(step), cmap=MAP)
    bar = axes.figure.colorbar(scalar, cax=axes.inset_axes([1.0, 0.1, 0.025, 0.75]))
    bar.set_label(r"$\epsilon_E$  [%]", labelpad=1)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(which="both", length=2, labelsize=9)


def draw_surface(axes, step, camera, name):
    faces, cells = outer_faces(step.cells)
    draw_faces(axes, camera, step.points, faces, colours_of(step)[cells])
    error = f", $\\epsilon$ = {100 * step.eps:.2f} %" if step.is_judged else ""
    axes.set_title(f"{name}: {len(step.cells)} tetrahedra{error}", pad=2)
    if step.is_judged:
        draw_bar(axes, step)


def draw_cut(axes, step, camera, name):
    """Tetrahedra beyond the plane through the centre of the contact forces."""
    beyond = (step.points[step.cells].mean(axis=1) - step.centre()) @ camera.side <= 0
    faces, cells = outer_faces(step.cells[beyond])
    draw_faces(axes, camera, step.points, faces, colours_of(step)[beyond][cells])
    axes.set_title(f"{name}, cut", pad=2)


def draw_deformed(axes, step, camera):
    faces, _ = outer_faces(step.cells)
    draw_faces(axes, camera, step.moved, faces, np.tile([0.9, 0.93, 0.95, 1], (len(faces), 1)))
    axes.set_title(f"Deformed, displacement × {step.scale:g}", pad=2)


class Sheet:
    """A piece of the contact surface, seen from outside along its normal where it carries the most."""

    def __init__(self, step, triangles):
        nodes = np.unique(triangles)
        normals = np.column_stack([step.nodes[name] for name in ("nx", "ny", "nz")])
        self.force = -step.nodes["fn"][nodes].sum()
        weights = -step.nodes["fn"][nodes] if self.force > 0 else np.ones(len(nodes))
        towards = weights @ normals[nodes]
        if np.linalg.norm(towards) < 1e-6 * weights.sum():
            towards = normals[nodes[0]]
        self.camera = Camera(towards / np.linalg.norm(towards))
        self.towards = towards / np.linalg.norm(towards)
        # what is beyond the rim lies behind the rest
        in_sight = (normals[triangles] @ self.towards).mean(axis=1) > 0.15
        self.triangles = triangles[in_sight]

    def flat(self, points):
        """Coordinates to the right and up, the eye at the side that n points to."""
        camera = self.camera
        right = np.sign(camera.along @ camera.right) * camera.along
        return np.column_stack([points @ right, points @ np.cross(self.towards, right)])


def sheets_of(step):
    """The sheets that carry forces, those with the largest first; all of them where none does."""
    triangles = step.surface["connectivity"]
    piece = pieces_of(triangles)
    sheets = [Sheet(step, triangles[piece == k]) for k in range(piece.max() + 1)]
    sheets.sort(key=lambda sheet: -sheet.force)
    return [sheet for sheet in sheets if sheet.force > 1e-6 * sheets[0].force][:MOST_SHEETS] or sheets[:MOST_SHEETS]


def shown_part(corners, pressure):
    """Lower left and upper right corner of a sheet, or of the part about its pressures where these are on a small one."""
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    pad = 0.02 * (high - low).max()
    pressed = corners[pressure.max(axis=1) > 0.01 * pressure.max()] if pressure.max() > 0 else corners
    inner_low, inner_high = pressed.min(axis=(0, 1)), pressed.max(axis=(0, 1))
    around = 0.4 * (inner_high - inner_low).max()
    if 2 * around < 0.3 * (high - low).max():
        low, high = np.maximum(low, inner_low - around), np.minimum(high, inner_high + around)
    return low - pad, high + pad


def draw_pressure_map(axes, step, sheet, title):
    """-r_n, or -p_n where nothing is judged, on a sheet of the contact surface."""
    triangles = sheet.triangles
    pressure = -step.surface[step.pressure_name()]
    flat = sheet.flat(step.surface["points"])
    colours = axes.tripcolor(*flat.T, triangles, pressure, shading="gouraud", cmap="Blues", norm=Normalize(0, max(pressure[triangles].max(), 1e-300)))
    axes.add_collection(PolyCollection(flat[triangles], facecolors="none", edgecolors=INK, linewidths=0.12))
    low, high = shown_part(flat[triangles], pressure[triangles])
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, pad=4)
    return colours


def draw_pressure_bar(figure, place, colours):
    bar = figure.colorbar(colours, cax=new_axes(figure, *place), orientation="horizontal")
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(length=2, labelsize=9)


def draw_cone(axes, step):
    """Tangential against normal pressure at the nodes, with what the law allows."""
    nodes = step.nodes
    pairs = [("computed $\\lambda_h$", "p", INK)] + ([("admissible $r$", "r", RED)] if step.is_judged else [])
    most = max(max(-nodes["pn"].min(), -nodes["rn"].min() if step.is_judged else 0), 1e-300)
    normal = np.linspace(0, 1.05 * most, 50)
    bound = np.minimum(nodes["friction"].max() * normal, nodes["limit"].max()) if step.is_coulomb else np.full(50, nodes["limit"].max())
    axes.fill_between(normal, 0, bound, color="#e2e2e2", linewidth=0, label=r"$\mu|p_n|$" if step.is_coulomb else "$k$")
    for (name, letter, colour), marker in zip(pairs, "ox"):
        axes.plot(-nodes[letter + "n"], np.hypot(nodes[letter + "t1"], nodes[letter + "t2"]), linestyle="none", marker=marker,
                  markersize=3 if marker == "o" else 4, markerfacecolor="none", markeredgewidth=0.7, color=colour, label=name)
    axes.set(xlim=(0, 1.05 * most), xlabel="normal pressure  [MPa]", ylabel="tangential  [MPa]")
    axes.set_ylim(bottom=0)
    if bound.max() == 0:
        axes.set_ylim(top=max(1e-300, 0.1 * most))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, handlelength=1.4, columnspacing=1.2, borderaxespad=0.2)
    axes.spines[["top", "right"]].set_visible(False)


def height_of_pressures(step):
    """Of draw_pressures [inches]."""
    return 3.1 if len(sheets_of(step)) == 1 else 3.0 + (len(sheets_of(step)) + 1) // 2 * SHEET_HEIGHT


def draw_pressures(figure, top, step):
    """Maps of the sheets, then the cone."""
    sheets = sheets_of(step)
    name = "$-r_n$" if step.is_judged else "$-\\lambda_{hn}$"
    if len(sheets) == 1:
        axes = new_axes(figure, 0.1, top + 0.45, 3.2, 1.9)
        colours = draw_pressure_map(axes, step, sheets[0], f"Pressure {name} on the contact surface  [MPa]")
        draw_pressure_bar(figure, (0.5, top + 2.45, 2.4, 0.1), colours)
        draw_cone(new_axes(figure, 4.05, top + 0.5, WIDTH - 4.25, 1.95), step)
        return
    down = figure.get_size_inches()[1]
    figure.text(0.5, 1 - (top + 0.15) / down, f"Pressure {name} on the {len(sheets)} sheets of the contact surface that carry the most  [MPa]",
                ha="center", va="center", fontsize=11)
    width = (WIDTH - 0.3) / 2
    for i, sheet in enumerate(sheets):
        left, down = 0.1 + i % 2 * (width + 0.1), top + 0.6 + i // 2 * SHEET_HEIGHT
        axes = new_axes(figure, left, down, width, SHEET_HEIGHT - 0.8)
        normal = ", ".join(f"{x:.2g}" for x in np.round(sheet.towards, 2) + 0.0)
        colours = draw_pressure_map(axes, step, sheet, f"n = ({normal}): {sheet.force:.4g} N")
        draw_pressure_bar(figure, (left + width / 2 - 1.1, down + SHEET_HEIGHT - 0.72, 2.2, 0.08), colours)
    draw_cone(new_axes(figure, 1.9, top + 0.75 + (len(sheets) + 1) // 2 * SHEET_HEIGHT, WIDTH - 3.8, 1.7), step)


def aspect_of(step, camera):
    flat = camera.flat(np.vstack([step.points, step.moved]))
    width, height = np.ptp(flat, axis=0)
    return height / width


def draw(folder):
    numbers = steps_in(folder)
    first, last = SolidStep(folder, numbers[0]), SolidStep(folder, numbers[-1])
    camera = Camera(first.normal())
    aspect = aspect_of(first, camera)
    is_adapted = len(last.cells) != len(first.cells)
    panels = {"surface_first": lambda axes: draw_surface(axes, first, camera, "First mesh" if is_adapted else "Mesh")}
    if is_adapted:
        panels["surface_last"] = lambda axes: draw_surface(axes, last, camera, "Optimised mesh")
    panels["deformed"] = lambda axes: draw_deformed(axes, last, camera)
    panels["cut"] = lambda axes: draw_cut(axes, last, camera, "Optimised mesh" if is_adapted else "Mesh")
    title, bar, gap = 0.32, 0.7, 0.1  # inches

    width = min(WIDTH - bar - gap, 4.2 / aspect)
    for name, paint in panels.items():
        figure = plt.figure(figsize=(width + bar + gap, width * aspect + title + gap))
        paint(new_axes(figure, gap, title, width, width * aspect))
        save(figure, folder / f"{name}.png", 200)
    figure = plt.figure(figsize=(WIDTH, height_of_pressures(last)))
    draw_pressures(figure, 0, last)
    save(figure, folder / "pressures.png", 200)

    columns = 2 if is_adapted or aspect < 1 else len(panels)
    left = gap if columns == 2 else 5 * gap  # titles are wider than narrow panels
    width = (WIDTH - columns * bar - left) / columns
    height = width * aspect + title
    rows = -(-len(panels) // columns)
    figure = plt.figure(figsize=(WIDTH, rows * height + height_of_pressures(last) + 0.1))
    for k, paint in enumerate(panels.values()):
        paint(new_axes(figure, left + k % columns * (width + bar), title + k // columns * height, width, width * aspect))
    draw_pressures(figure, rows * height + 0.1, last)
    save(figure, folder / "overview.png", 150)
