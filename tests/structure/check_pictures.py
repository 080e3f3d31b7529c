#!/usr/bin/python3
"""Discs of the pictures are those found pixel by pixel, and few large ones cost no more than many;
what is observed stands on axes of its own.

    check_pictures.py SCRIPTS
"""
import sys
import time

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
from run_plots import flow, raster

LONGEST = 20  # seconds for the two pictures below; once minutes


def pixel_by_pixel(window, places, values, radius, depth):
    image = np.full((window.rows, window.columns), np.nan)
    front = np.full(image.shape, np.inf)
    rows, columns = np.mgrid[:window.rows, :window.columns]
    for place, value, away in zip(places, values, depth):
        column, row = np.floor((place - window.lower) / window.pixel)
        distance = np.hypot(columns - column, rows - row) * window.pixel
        hit = ((distance <= radius) | (distance == 0)) & (away <= front)
        image[hit], front[hit] = value, away
    return image


def check_discs():
    raster.PIXELS = 120
    random = np.random.default_rng(1)
    for count, radius in ((1, 0.5), (5, 0.2), (60, 0.1), (60, 1e-5)):
        places, depth = random.random((count, 2)) * (1, 0.6), random.integers(0, 5, count) * 1.0
        values = np.arange(count) * 1.0
        window = raster.Raster(places.min(axis=0) - radius, places.max(axis=0) + radius)
        expected = pixel_by_pixel(window, places, values, radius, depth)
        assert np.isfinite(expected).sum() >= min(count, 40)
        assert np.array_equal(window.discs(places, values, radius, depth), expected, equal_nan=True)


def check_cost():
    raster.PIXELS = 1000
    start = time.perf_counter()
    for places in (np.zeros((1, 2)), np.random.default_rng(1).random((100000, 2)) * 1e-3):
        image = raster.Raster((-1, -1), (1, 1)).discs(places, places[:, 0], 1.0)
        assert 0.7 < np.isfinite(image).mean() < 0.85  # a disc in a square
    assert time.perf_counter() - start < LONGEST


def check_windows():
    """All of a panel far away at one place along an axis."""
    for lower, upper in (((1e200, 0), (1e200, 1)), ((0, 0), (1e-3, 1)), ((3, 3), (3, 3))):
        corners = flow.widened(np.array(lower), np.array(upper), flow.SLIMMEST)
        width, height = np.subtract(corners[1], corners[0])
        assert flow.SLIMMEST <= width / height * 1.001 and 1.001 * height / width >= flow.SLIMMEST


def check_histories():
    history = flow.with_errors({"time": [0, 1], "step": [0, 1], "crossings": [0, 80],
                                "courant_number": [0, 95], "share_inside": [1, 1],
                                "radius_kept": [1, 1 - 2 ** -20]})
    kinds = flow.observed(history, {"conservation": {}})
    assert kinds == {"crossings": ["crossings"], "courant_number": ["courant_number"],
                     flow.ERROR: ["radius_error"]}
    assert history["radius_error"] == [0, 2 ** -20]
    assert "share_inside" in flow.with_errors({"share_inside": [1, 0.5]})
    for kind in ("crossings", "courant_number", "share_inside"):
        assert flow.unit_of(kind, 2) == "1"


check_discs()
check_cost()
check_windows()
check_histories()
