"""Particles as discs in a picture of pixels: as fast for a million as for a hundred."""
import numpy as np

PIXELS = 1000  # along the longer side


class Raster:
    """A window onto a plane, in pixels."""

    def __init__(self, lower, upper):
        size = np.maximum(np.subtract(upper, lower), 1e-300)
        self.lower, self.pixel = np.asarray(lower), size.max() / PIXELS
        self.columns, self.rows = np.maximum(np.ceil(size / self.pixel), 1).astype(int)
        self.extent = (lower[0], lower[0] + self.columns * self.pixel,
                       lower[1], lower[1] + self.rows * self.pixel)

    def stamp(self, radius):
        """The pixels of a disc around its centre; at least the one in the middle."""
        reach = int(radius / self.pixel)
        steps = np.arange(-reach, reach + 1)
        right, up = np.meshgrid(steps, steps)
        inside = np.hypot(right, up) * self.pixel <= max(radius, self.pixel / 2)
        return zip(right[inside], up[inside])

    def discs(self, places, values, radius, depth=None):
        """The values as an image, NaN where there is no disc; the least depth is in front."""
        depth = np.zeros(len(values)) if depth is None else depth
        order = np.argsort(-depth, kind="stable")
        cells = ((places[order] - self.lower) / self.pixel).astype(int)
        values, depth = values[order], depth[order]
        image = np.full(self.rows * self.columns, np.nan)
        front = np.full(image.shape, np.inf)
        for right, up in self.stamp(radius):
            column, row = cells[:, 0] + right, cells[:, 1] + up
            inside = (column >= 0) & (column < self.columns) & (row >= 0) & (row < self.rows)
            cell = row[inside] * self.columns + column[inside]
            self.paint(image, front, cell, values[inside], depth[inside])
        return image.reshape(self.rows, self.columns)

    @staticmethod
    def paint(image, front, cell, values, depth):
        """One pixel of every disc; of those in the same cell the last, which is in front."""
        nearest = np.full(image.shape, -1)
        nearest[cell] = np.arange(len(cell))
        hit = np.flatnonzero(nearest >= 0)
        chosen = nearest[hit]
        closer = depth[chosen] < front[hit]
        image[hit[closer]] = values[chosen[closer]]
        front[hit[closer]] = depth[chosen[closer]]
