"""Structural mutations of a scene: errors of a careless program, not random noise in the text."""

import copy
import json

# Written without quotes, although Python has no such JSON value: the text replaces the string.
BARE = {"@nan": "NaN", "@inf": "Infinity", "@1e999": "1e999", "@1e-400": "1e-400", "@big": "9" * 40, "@hex": "0x10", "@nothing": ""}
NUMBERS = [0, -0.0, 1, -1, 0.5, 2, 3, 1e308, -1e308, 5e-324, 1e-300, 1e-160, 1e160, 1e15, 2 ** 31 - 1, 2 ** 31, 2 ** 53 + 1,
           2 ** 63, 2 ** 64 - 1, 1e-9, 1 + 2 ** -52]
OTHERS = [None, True, False, "", "NaN", "1", "sphere", "\u0000", "\ud83d\ude00", [], {}, [[]], [[[[[]]]]], [0, 0, 0], [1, 2], "@nan",
          "@inf", "@1e999", "@1e-400", "@big", "@hex", "@nothing"]


def paths(value, path=()):
    yield path
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from paths(inner, path + (key,))
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from paths(inner, path + (i,))


def at(value, path):
    for step in path:
        value = value[step]
    return value


def put(value, path, new):
    if not path:
        return new
    try:
        at(value, path[:-1])[path[-1]] = new
    except (IndexError, KeyError, TypeError):
        pass  # an earlier mutation removed the place
    return value


def of_kind(value, kind):
    return [path for path in paths(value) if isinstance(at(value, path), kind) and not isinstance(at(value, path), bool)]


def replace_number(random, scene):
    path = random.choice(of_kind(scene, (int, float)) or [()])
    return put(scene, path, random.choice(NUMBERS))


def negate_number(random, scene):
    path = random.choice(of_kind(scene, (int, float)) or [()])
    number = at(scene, path)
    return put(scene, path, -number if isinstance(number, (int, float)) else 0)


def copy_number(random, scene):
    numbers = of_kind(scene, (int, float)) or [()]
    return put(scene, random.choice(numbers), copy.deepcopy(at(scene, random.choice(numbers))))


def replace_anything(random, scene):
    return put(scene, random.choice(list(paths(scene))), copy.deepcopy(random.choice(OTHERS)))


def drop_key(random, scene):
    objects = [path for path in of_kind(scene, dict) if at(scene, path)]
    if objects:
        chosen = at(scene, random.choice(objects))
        del chosen[random.choice(list(chosen))]
    return scene


def unknown_key(random, scene):
    objects = of_kind(scene, dict)
    if objects:
        at(scene, random.choice(objects))[random.choice(["", "x", "faces", "radius", "type", "q"])] = random.choice(NUMBERS)
    return scene


def swap_places(random, scene):
    """Swaps two values of any kind (or copies one over the other)."""
    a, b = (random.choice(list(paths(scene))) for _ in range(2))
    first, second = copy.deepcopy(at(scene, a)), copy.deepcopy(at(scene, b))
    if a[:len(b)] == b or b[:len(a)] == a:  # one contains the other
        return put(scene, a, second)
    return put(put(scene, a, second), b, first)


def change_list(random, scene):
    """Removes, repeats or moves an item; or shortens or reverses the list."""
    lists = [path for path in of_kind(scene, list) if at(scene, path)]
    if not lists:
        return scene
    chosen = at(scene, random.choice(lists))
    i = random.randrange(len(chosen))
    accident = random.randrange(5)
    if accident == 0:
        del chosen[i]
    elif accident == 1:
        chosen.insert(random.randrange(len(chosen) + 1), copy.deepcopy(chosen[i]))
    elif accident == 2:
        chosen[i] = copy.deepcopy(random.choice(chosen))
    elif accident == 3:
        del chosen[i:]
    else:
        chosen.reverse()
    return scene


def flatten(random, scene):
    """Puts all vertices in one plane, on one line or in one point, or makes the shape long and thin."""
    for shape in [at(scene, path) for path in of_kind(scene, dict)]:
        vertices = shape.get("vertices")
        if not isinstance(vertices, list) or random.random() < 0.3:
            continue
        factors = random.choice([(1, 1, 0), (1, 0, 0), (0, 0, 0), (1, 1, 5e-324), (1e154, 1, 1e-154), (1, 1, 1e-9)])
        for vertex in vertices:
            if isinstance(vertex, list) and len(vertex) == 3 and all(isinstance(x, (int, float)) for x in vertex):
                vertex[:] = [x * factor for x, factor in zip(vertex, factors)]
    return scene


def change_faces(random, scene):
    """Reverses faces, gives them wrong corners, or one too few or too many; or adds faces where there were none."""
    for shape in [at(scene, path) for path in of_kind(scene, dict)]:
        if not isinstance(shape.get("vertices"), list):
            continue
        count = len(shape["vertices"])
        faces = shape.get("faces")
        if not isinstance(faces, list) or not all(isinstance(face, list) for face in faces) or random.random() < 0.1:
            shape["faces"] = [[random.randrange(count + 1) for _ in range(3)] for _ in range(4)] if count else [[]]
        elif random.random() < 0.3:
            shape["faces"] = [face[::-1] for face in faces]
        elif faces and random.random() < 0.5:
            renamed = list(range(count))
            random.shuffle(renamed)
            shape["faces"] = [[renamed[v] if isinstance(v, int) and v < count else v for v in face] for face in faces]
        elif faces:
            faces[random.randrange(len(faces))] = [random.choice([-1, 0, 1, 2, 3, count, 2 ** 31]) for _ in range(random.randrange(6))]
    return scene


def zero_quaternion(random, scene):
    turns = [path for path in paths(scene) if path and path[-1] == "q"]
    tiny = random.choice([0, 5e-324, 1e-200, 1e200])
    return put(scene, random.choice(turns), {"w": tiny, "x": 0, "y": 0, "z": random.choice([0, tiny])}) if turns else scene


def many_frames(random, scene):
    if isinstance(scene, dict) and isinstance(scene.get("frames"), list):
        scene["frames"] = scene["frames"] * random.choice([2, 50])
    return scene


def wide_raster(random, scene):
    """Makes the raster so large that it is refused, or long and thin."""
    if isinstance(scene, dict) and isinstance(scene.get("raster"), dict):
        columns, rows = random.choice([(2 ** 24 + 1, 1), (2 ** 31 - 1, 2 ** 31 - 1), (1, 2000), (2000, 1), (2 ** 13, 2 ** 12), (0, 0)])
        scene["raster"].update(columns=columns, rows=rows)
    return scene


def another_shape(random, scene, shapes):
    places = [path for path in paths(scene) if path and path[-1] == "shape"]
    return put(scene, random.choice(places), copy.deepcopy(random.choice(shapes))) if places else scene


def text_of(scene):
    text = json.dumps(scene)
    for name, bare in BARE.items():
        text = text.replace(json.dumps(name), bare)
    return text


ACCIDENTS = [replace_number, replace_number, replace_number, negate_number, copy_number, replace_anything, drop_key, unknown_key,
             swap_places, change_list, change_list, flatten, change_faces, zero_quaternion, many_frames, wide_raster]


def mutated(random, scene, shapes):
    """Applies one to three mutations."""
    scene = copy.deepcopy(scene)
    for _ in range(random.choice([1, 1, 2, 3])):
        if random.random() < 0.1:
            scene = another_shape(random, scene, shapes)
        else:
            scene = random.choice(ACCIDENTS)(random, scene)
    return scene
