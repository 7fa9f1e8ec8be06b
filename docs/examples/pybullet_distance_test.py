"""Is PyBullet's distance of two bodies right? For pytest; see docs/how_to/ask_from_python.md."""
import itertools

import pytest

from touchstone_exact import box, exact, sphere

pybullet = pytest.importorskip("pybullet")

SHAPES = {"sphere": sphere(0.5), "cube": box(0.5, 0.5, 0.5), "rod": box(2, 0.125, 0.125)}
PLACES = [(5, 0, 0), (3, 4, 0), (3, 3, 3)]
TURNS = [(1, 0, 0, 0), (1, 0, 0, 1), (3, 1, 2, 0)]  # w, x, y, z
ALLOWED = 1e-3  # m; Bullet rounds a box's edges by its collision margin, which is 1 mm in PyBullet


@pytest.fixture(scope="module")
def world():
    world = pybullet.connect(pybullet.DIRECT)
    yield world
    pybullet.disconnect(world)


def in_bullet(body):
    shape, pose = body["shape"], body["X_WB"]
    if shape["type"] == "sphere":
        form = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=shape["radius"])
    else:
        form = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=shape["half_extents"])
    q = [pose["q"][axis] for axis in "xyzw"]
    length = sum(x * x for x in q) ** 0.5
    return pybullet.createMultiBody(baseCollisionShapeIndex=form, basePosition=pose["p"],
                                    baseOrientation=[x / length for x in q])


@pytest.mark.parametrize("a, b, p, q", itertools.product(SHAPES, SHAPES, PLACES, TURNS))
def test_distance(world, a, b, p, q):
    A, B = SHAPES[a], {**SHAPES[b], "X_WB": {"p": p, "q": dict(zip("wxyz", q))}}
    found = pybullet.getClosestPoints(in_bullet(A), in_bullet(B), distance=10)
    assert min(point[8] for point in found) == pytest.approx(exact.distance(A, B).distance, abs=ALLOWED)
