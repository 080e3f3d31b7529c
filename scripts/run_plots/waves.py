"""The wave functions of a solved model against the exact ones."""
import matplotlib.pyplot as plt

from run_plots.reading import read_columns

MOST_STATES = 8


def shown_states(columns):
    """Pairs of a state's number and the name of its column, the lowest first."""
    names = [name for name in columns if name.startswith("psi_")]
    return [(name.removeprefix("psi_"), name) for name in names][:MOST_STATES]


def draw_waves(folder):
    columns = read_columns(folder / "wave_functions.csv")
    energies = read_columns(folder / "eigenvalues.csv")["energy"]
    figure, axes = plt.subplots(figsize=(8, 5))
    has_exact = "exact_1" in columns
    for k, (number, name) in enumerate(shown_states(columns)):
        if has_exact:
            axes.plot(columns["x"], columns[f"exact_{number}"], color="0.25", linewidth=1,
                      linestyle="--", zorder=3, label=None if k else "exact")
        axes.plot(columns["x"], columns[name], color=f"C{k}", linewidth=2.5, alpha=0.7,
                  label=f"state {number}, E = {energies[k]:.6g}")
    axes.axhline(0, color="0.8", linewidth=0.8, zorder=0)
    axes.set_xlabel("x [units with $\\hbar^2/2m = 1$]")
    axes.set_ylabel("wave function $\\psi$ (normalised)")
    axes.grid(color="0.93")
    axes.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    return figure
