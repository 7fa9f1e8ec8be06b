"""The masks of each body, and their overlap; not where the bodies meet."""

from fractions import Fraction

from proofs.exact import *
from proofs.verdict import InPart, demand


def hull_2d(points):
    """Counter-clockwise, by Andrew's chains."""
    points = sorted(set(points))
    chains = []
    for order in (points, points[::-1]):
        chain = []
        for p in order:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1])
                                      - (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])) <= 0:
                chain.pop()
            chain.append(p)
        chains += chain[:-1]
    return chains


def meets_square(hull, x, y, half):
    """Does a convex polygon meet the closed square with this centre? By separating axes."""
    if max(p[0] for p in hull) < x - half or min(p[0] for p in hull) > x + half:
        return False
    if max(p[1] for p in hull) < y - half or min(p[1] for p in hull) > y + half:
        return False
    for p, q in zip(hull, hull[1:] + hull[:1]):
        nx, ny = q[1] - p[1], p[0] - q[0]
        if nx * (x - p[0]) + ny * (y - p[1]) > half * (abs(nx) + abs(ny)):
            return False
    return True


def check_pixel(scene, answer):
    raster = scene["raster"]
    size, left, below = (Fraction(raster[k]) for k in ("pixel", "x", "y"))
    masks = []
    for body, kinds in zip(scene["bodies"][:2], zip(answer["sampled"], answer["conservative"])):
        pictures = [([p[:2] for p in points], radius) for points, _, radius in parts_in_world(body)]
        pictures = [(points if radius else hull_2d(points), radius) for points, radius in pictures]
        for half, rows in zip((Fraction(0), size / 2), kinds):
            demand(len(rows) == raster["rows"], "rows of a mask")
            for j, row in enumerate(rows):
                demand(len(row) == raster["columns"], "columns of a mask")
                for i, bit in enumerate(row):
                    x, y = left + size * (i + Fraction(1, 2)), below + size * (j + Fraction(1, 2))
                    covered = any(
                        max(abs(x - shown[0][0]) - half, 0) ** 2 + max(abs(y - shown[0][1]) - half, 0) ** 2 <= radius**2
                        if radius else meets_square(shown, x, y, half) for shown, radius in pictures)
                    demand(bit == "01"[covered], f"pixel ({i}, {j})")
        masks.append(kinds[0])
    if len(masks) == 2:
        dx, dy = raster.get("shift", [0, 0])
        both = [(j, i) for j, row in enumerate(masks[0]) for i, bit in enumerate(row)
                if bit == "1" and 0 <= j - dy < raster["rows"] and 0 <= i - dx < raster["columns"]
                and masks[1][j - dy][i - dx] == "1"]
        demand(answer["overlap"]["count"] == len(both), "count of common pixels")
    raise InPart
