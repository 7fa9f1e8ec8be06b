"""Small valid scenes of every kind, from which the mutations start."""

NO_TURN = {"w": 1, "x": 0, "y": 0, "z": 0}
TURNED = {"w": 0.5, "x": -0.25, "y": 1, "z": 0.125}
TETRAHEDRON = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
TETRAHEDRON_FACES = [[0, 1, 3], [0, 2, 1], [0, 3, 2], [1, 2, 3]]
CUBE = [[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
CUBE_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
PYRAMID = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 0, 0], [1, 1, 1.5]]  # one vertex in the middle of an edge


def sphere(radius=1):
    return {"type": "sphere", "radius": radius}


def box(x=1, y=0.5, z=0.75):
    return {"type": "box", "half_extents": [x, y, z]}


def hull(vertices, faces=None):
    return {"type": "polytope", "vertices": vertices, **({"faces": faces} if faces else {})}


def compound(*shapes):
    return {"type": "compound",
            "parts": [{"X_BP": {"p": [i, 0, 0.5 * i], "q": TURNED}, "shape": shape} for i, shape in enumerate(shapes)]}


SHAPES = [sphere(), box(), hull(TETRAHEDRON), hull(TETRAHEDRON, TETRAHEDRON_FACES), hull(CUBE, CUBE_FACES), hull(PYRAMID),
          compound(sphere(0.5), box()), compound(hull(TETRAHEDRON, TETRAHEDRON_FACES), hull(PYRAMID))]
GIVEN = {"type": "given", "mass": 2, "p_BBcm": [0.25, 0, 0], "I_BBcm_B": [[1, 0, 0], [0, 1.5, 0.125], [0, 0.125, 1]]}


def body(shape, p=(0, 0, 0), q=None, v=(0, 0, 0), w=(0, 0, 0), mass=None):
    return {"shape": shape, "X_WB": {"p": list(p), "q": q or NO_TURN}, "velocity": {"v_WBcm": list(v), "w_WB": list(w)},
            "material": {"restitution": 0.5, "friction": 0.25}, "mass": mass or {"type": "density", "density": 1}}


def scene(*bodies, **rest):
    return {"touchstone": "scene/1", "gravity": [0, 0, 0], "bodies": list(bodies), **rest}


def pair(a, b, **rest):
    return scene(body(a, q=TURNED, v=(0.5, 0, 0), w=(0, 0.5, 0.25)), body(b, (4, 0.25, 0.125), v=(-1, 0, 0), mass=GIVEN), **rest)


def contact(law):
    return {"p_WC": [1, 0, 0], "nhat_BA_W": [-1, 0, 0], "law": law, "restitution": 0.5, "friction": 0.25}


RASTER = {"x": -2, "y": -2, "pixel": 0.5, "columns": 9, "rows": 8, "shift": [1, -1]}
FRAMES = [[{"body": 0, "X_WB": {"p": [0, 0, 0], "q": NO_TURN}}, {"body": 1, "X_WB": {"p": [1, 0, 0], "q": TURNED}}],
          [{"body": 0, "X_WB": {"p": [5, 0, 0], "q": TURNED}}], [{"body": 1, "X_WB": None}]]
MOTION = {"sample_times": [0.5, 1.5], "start_times": [0, 0], "envelope": 1e-6, "law": "poisson", "force_bound": 1,
          "forces": [{"time": 0.25, "body": 0, "force_W": [0.5, 0, 0]}]}
TABLE = body(box(10, 10, 1), (0, 0, -1), mass={"type": "fixed"})


def questions():
    """Yields (query, scene): each kind of shape, and what each query needs."""
    pairs = [(a, b) for i, a in enumerate(SHAPES) for b in SHAPES[i % 3::3]]
    for a, b in pairs:
        for query in ("mass", "bounds", "broad_phase", "distance", "penetration"):
            yield query, pair(a, b)
        yield "pair_history", pair(a, b, frames=FRAMES)
        for law in ("poisson", "stronge", "newton"):
            yield "impulse", pair(a, b, contact=contact(law))
        yield "pixel", pair(a, b, raster=RASTER)
        yield "time_of_impact", pair(a, b, motion={"sample_times": [2]})
        yield "simulation", pair(a, b, motion={"sample_times": [2]})
        yield "simulation", pair(a, b, motion=MOTION)
    ball = body(sphere(0.5), (0, 0, 0.5), v=(1, 0, 0))
    yield "constraint", {**scene(ball, TABLE, motion={"sample_times": [0.5, 1]}), "gravity": [0, 0, -9.75]}
    yield "simulation", {**scene(body(sphere(0.5), (0, 0, 2)), TABLE, motion={"sample_times": [0.5, 1]}), "gravity": [0, 0, -9.75]}
