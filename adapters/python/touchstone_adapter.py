"""Speaks Touchstone's protocol (docs/protocol.md) for an adapter, which supplies a card and one function a query.

    serve({"name": "my_engine", "version": "1.0", "precision": "binary64"}, {"distance": distance})

A function gets a scene (docs/scene.schema.json) and returns the result (docs/protocol.schema.json). It raises Abstain if
it does not answer this scene, and Refused if the engine itself says that it does not take this scene; any other
exception is reported as a failure of the engine, and the next question follows.
"""
import json
import math
import os
import sys


class Abstain(Exception):
    """This scene is not answered; the message says why."""


class Refused(Exception):
    """The engine says that it does not take this scene; the message is its reason."""


class NotFinite(Exception):
    """The engine computed NaN or an infinity, which JSON cannot hold; the message says where."""


def unit_quaternion(q):
    """(w, x, y, z) of length 1 with the rotation of q, a dictionary of any length but 0, however large or small."""
    largest = max(map(abs, q.values()))
    w, x, y, z = (q[k] / largest for k in "wxyz")
    norm = math.hypot(w, x, y, z)
    return w / norm, x / norm, y / norm, z / norm


def rotated(q, v):
    """R(q) v: a vector of the body's frame B, in the world's frame W."""
    w, *u = unit_quaternion(q)
    t = [2 * (u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) for i in range(3)]
    return [v[i] + w * t[i] + u[i - 2] * t[i - 1] - u[i - 1] * t[i - 2] for i in range(3)]


def in_world(pose, p_BQ):
    """The point of the body's frame B, in the world's frame W: R(q) p_BQ + p."""
    return [x + y for x, y in zip(rotated(pose["q"], p_BQ), pose["p"])]


def in_body(pose, p_WQ):
    """The point of the world's frame W, in the body's frame B: the inverse of in_world."""
    back = {**pose["q"], "w": -pose["q"]["w"]}
    return rotated(back, [x - y for x, y in zip(p_WQ, pose["p"])])


def _plain(value, place):
    """The value in types that JSON has. Arrays and numbers of NumPy become lists and numbers."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        raise NotFinite(f"{place} is {'NaN' if math.isnan(value) else 'infinity' if value > 0 else '-infinity'}")
    if isinstance(value, dict):
        return {key: _plain(part, f"{place}.{key}") for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(part, f"{place}[{i}]") for i, part in enumerate(value)]
    return value


def _breaks(error):
    kind = "garbage" if isinstance(error, NotFinite) else "refused" if isinstance(error, Refused) else "threw"
    return {"breaks": {"kind": kind, "how": f"{type(error).__name__}: {error}" if kind == "threw" else str(error)}}


def _answer(message, card, queries, snippets):
    if message["op"] == "start":
        return {"protocol": 1, "card": card}
    if message["op"] == "reproduce":
        if message["query"] not in snippets:
            return {"abstains": f"no snippets of {message['query']}"}
        return {"snippet": snippets[message["query"]](message["scene"])}
    if message["query"] not in queries:
        return {"abstains": f"no {message['query']} query"}
    return {"result": _plain(queries[message["query"]](message["scene"]), "result")}


def serve(card, queries, snippets={}):
    """Answers until `stop` or the end of stdin. `queries`: name -> function of a scene. `snippets`: name of a query ->
    function of a scene that returns a program in the engine's own API, as text, which asks the engine the same."""
    card = {**card, "answers": list(queries), "reproduces": list(snippets)}
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what the engine or a library prints to stdout goes to stderr, and spoils no answer
    for line in sys.stdin:
        seq = 0
        try:
            message = json.loads(line)
            seq = message["seq"]
            if message["op"] == "stop":
                break
            answer = _answer(message, card, queries, snippets)
        except Abstain as why:
            answer = {"abstains": str(why)}
        except Exception as error:  # the engine failed: say so, and answer the next question
            answer = _breaks(error)
        print(json.dumps({"seq": seq, **answer}), file=answers, flush=True)
