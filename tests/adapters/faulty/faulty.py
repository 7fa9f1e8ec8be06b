"""An adapter whose queries go wrong, each in its own way."""
import math

from touchstone_adapter import Abstain, Refused, in_body, in_world, serve


def bounds(scene):
    print("an engine that prints")
    pose = scene["bodies"][0]["X_WB"]
    p = in_world(pose, [1.0, 2.0, 3.0])
    return [{"lo": p, "hi": in_body(pose, p)}]


def distance(scene):
    raise Abstain("not today")


def mass(scene):
    return [{"mass": 1.0, "p_BBcm": [0.0, math.nan, 0.0]}]


def penetration(scene):
    raise ValueError("the engine failed")


def pixel(scene):
    raise Refused("no compounds")


serve({"name": "faulty", "version": "1", "precision": "binary32"},
      {"mass": mass, "bounds": bounds, "distance": distance, "penetration": penetration, "pixel": pixel},
      {"mass": lambda scene: f'ask about "{len(scene["bodies"])}"'})
