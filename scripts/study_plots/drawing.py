"""What all pictures of a study share: styles, axes, legends, files."""
import math

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "xtick.labelsize": 8, "ytick.labelsize": 8})
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = "osD^vPX<>*hp"  # 7 colours and 12 markers: 84 different pairs
TALLEST = 40  # inches


def plain(name):
    """A name that matplotlib takes as it is: no formula, and not hidden from legends."""
    name = name.replace("$", r"\$")
    return "\u200b" + name if name.startswith("_") else name


def style(k, count, largest=6.5, smallest=4.5):
    """Colour and marker of operator k: later markers are smaller, and do not hide earlier ones."""
    return {"color": COLOURS[k % len(COLOURS)], "marker": MARKERS[k % len(MARKERS)],
            "markersize": largest - (largest - smallest) * k / max(1, count - 1)}


def hollow(k, count):
    """The same for many points on a curve."""
    return {**style(k, count, 6.5, 3.0), "markerfacecolor": "none", "markeredgewidth": 0.9}


def label(name, units, power=0):
    """A coordinate or a derivative with its unit; the field's own unit is not known."""
    per = ("m", "field/m", "field/m²")[power]
    return f"{name} [{per if units == 'SI' else 'own units'}]"


def make_grid(rows, columns):
    return plt.subplots(rows, columns, squeeze=False)


def arrange(figure, grid, size, gap):
    """Panels of that size and gaps between them, in inches; lower ones in a figure too tall.

    The panels fill the figure. Titles and legends lie outside, and `save` makes room for them.
    """
    (rows, columns), (width, height) = grid.shape, size
    height = max(min(height, TALLEST / rows - gap[1]), 0.8)
    figure.set_size_inches(columns * (width + gap[0]) - gap[0], rows * (height + gap[1]) - gap[1])
    figure.subplots_adjust(0, 0, 1, 1, gap[0] / width, gap[1] / height)


def add_legend(figure, handles):
    """A legend of the whole figure, below it."""
    longest = max(len(handle.get_label()) for handle in handles)
    columns = max(1, int((figure.get_figwidth() + 1) / (0.068 * longest + 0.5)))
    rows = math.ceil(len(handles) / columns)
    figure.legend(handles=handles, loc="upper center", fontsize=8, frameon=False,
                  bbox_to_anchor=(0.5, -0.5 / figure.get_figheight()),
                  ncol=math.ceil(len(handles) / rows))


def add_bar(figure, points, panels, text, extend="neither"):
    """The colours of a block of panels, on its right."""
    width, height = figure.get_size_inches()
    low, high = panels.flat[-1].get_position().y0, panels.flat[0].get_position().y1
    axes = figure.add_axes([1 + 0.2 / width, low, 0.14 / width, high - low])
    bar = figure.colorbar(points, cax=axes, extend=extend, extendfrac=0.1 / (high - low) / height)
    bar.set_label(text, fontsize=8)
    axes.tick_params(which="both", labelsize=7)


def stroke(k, width):
    """The line of operator k: broken once the colours come again."""
    pattern = "--" if k // len(COLOURS) % 2 else "-"
    return {"linewidth": width, "linestyle": pattern if width else "none"}


def operator_handles(operators, of=style, linewidth=0.0):
    return [Line2D([], [], label=plain(name), **stroke(k, linewidth),
                   **of(k, len(operators))) for k, name in enumerate(operators)]


def save(figure, title, path, above=0.35):
    """Writes the figure with its title that many inches above the panels."""
    figure.suptitle(plain(title), fontsize=11, va="bottom", y=1 + above / figure.get_figheight())
    figure.savefig(path, dpi=130, bbox_inches="tight")
    plt.close(figure)
