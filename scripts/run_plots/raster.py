"""Particles as discs in a picture of pixels: the cost is that of the pixels, whatever the number,
the size and the overlap of the discs."""
import numpy as np

PIXELS = 1000  # along the longer side
NOBODY = -1


class Raster:
    """A window onto a plane, in pixels."""

    def __init__(self, lower, upper):
        size = np.maximum(np.subtract(upper, lower), 1e-300)
        self.lower, self.pixel = np.asarray(lower), size.max() / PIXELS
        self.columns, self.rows = np.maximum(np.ceil(size / self.pixel), 1).astype(int)
        self.extent = (lower[0], lower[0] + self.columns * self.pixel,
                       lower[1], lower[1] + self.rows * self.pixel)

    def discs(self, places, values, radius, depth=None):
        """The values as an image, NaN where there is no disc; the least depth is in front. A disc
        whose centre is outside of the window is not shown."""
        order = np.arange(len(values)) if depth is None else np.argsort(-depth, kind="stable")
        front = self.spread(self.centres(places[order]), radius / self.pixel)
        return np.where(front == NOBODY, np.nan, np.append(values[order], np.nan)[front])

    def centres(self, places):
        """An image of the last of the particles in every pixel, NOBODY where there is none."""
        image = np.full((self.rows, self.columns), NOBODY, dtype=np.int32)
        column, row = np.floor((places - self.lower) / self.pixel).T
        inside = np.flatnonzero((column >= 0) & (column < self.columns)
                                & (row >= 0) & (row < self.rows))
        np.maximum.at(image, (row[inside].astype(int), column[inside].astype(int)), inside)
        return image

    @staticmethod
    def spread(centres, radius):
        """The last of the particles whose discs cover a pixel. Rows of a disc are gone through from
        its ends to its middle, where they are longer and longer."""
        covered, row = centres.copy(), centres.copy()  # row: the last within `half` pixels sideways
        half = 0
        for up in range(min(int(radius), len(row) - 1), -1, -1):
            while (half + 1) ** 2 + up ** 2 <= radius ** 2:
                half += 1
                np.maximum(row[:, half:], centres[:, :-half], out=row[:, half:])
                np.maximum(row[:, :-half], centres[:, half:], out=row[:, :-half])
            np.maximum(covered[up:], row[:len(row) - up], out=covered[up:])
            np.maximum(covered[:len(row) - up], row[up:], out=covered[:len(row) - up])
        return covered
