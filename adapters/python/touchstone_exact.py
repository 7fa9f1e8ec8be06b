"""Exact answers about collisions, in one line of a Python test (docs/how_to/ask_from_python.md):

    from touchstone_exact import box, exact, sphere
    assert exact.distance(sphere(1), box(1, 1, 1, p=(5, 0, 0))).distance == 3

An answer has the keys of `touchstone ask QUERY SCENE --json` as attributes, and exact rational numbers as Fractions.
The program is `touchstone`, or the command that the environment variable TOUCHSTONE names."""

import functools, json, os, shlex, subprocess, threading, types
from fractions import Fraction
from subprocess import PIPE


class Refused(ValueError):
    """Not a question; the text names the place in the scene, where bodies[0] is the first body given."""


def body(shape, p=(0, 0, 0), q=(1, 0, 0, 0), **rest):
    """A body at p, turned by q/|q| with q = (w, x, y, z); `rest`: fixed, mass, velocity and material, as in a scene."""
    return {"shape": shape, "X_WB": {"p": p, "q": dict(zip("wxyz", q, strict=True))}, **rest}


def sphere(radius, **where): return body({"type": "sphere", "radius": radius}, **where)
def box(hx, hy, hz, **where): return body({"type": "box", "half_extents": [hx, hy, hz]}, **where)
def polytope(vertices, **where): return body({"type": "polytope", "vertices": vertices}, **where)


def compound(*parts, **where):
    """The union of convex bodies, each posed in the compound's frame."""
    return body({"type": "compound", "parts": [{"X_BP": b["X_WB"], "shape": b["shape"]} for b in parts]}, **where)


def read(pairs):
    keys = dict(pairs)
    if set(keys) != {"exact", "nearest"}:
        return types.SimpleNamespace(**keys)
    return Fraction(keys["exact"]) if isinstance(keys["exact"], str) else tuple(map(Fraction, keys["exact"]))


class Exact:
    """One process of `touchstone serve`, started by the first question. Threads take turns."""

    def __init__(self, command=None):
        self.command, self.process, self.seq, self.turn = command, None, 0, threading.Lock()

    def ask(self, query, *about):
        """About bodies, or about one scene as a dict (docs/scene.schema.json)."""
        scene = about[0] if len(about) == 1 and "bodies" in about[0] else {"touchstone": "scene/1", "bodies": about}
        with self.turn:
            if not self.process or self.process.poll() is not None:
                command = self.command or shlex.split(os.environ.get("TOUCHSTONE", "touchstone"))
                self.process = subprocess.Popen([*command, "serve"], stdin=PIPE, stdout=PIPE, text=True)
            self.seq += 1
            question = {"op": "ask", "seq": self.seq, "query": query, "scene": scene}
            try:
                self.process.stdin.write(json.dumps(question, default=lambda array: array.tolist()) + "\n")
                self.process.stdin.flush()
            except BrokenPipeError:
                pass  # it has ended: there is no answer to read either
            for line in self.process.stdout:
                said = json.loads(line, object_pairs_hook=read)
                if said.seq in (self.seq, 0):  # any other is the answer to a question that was interrupted
                    break
            else:
                raise RuntimeError(f"{shlex.join(self.process.args)} ended with exit code {self.process.wait()}")
        if not hasattr(said, "result"):
            raise Refused(f"{query}: {said.abstains}" if hasattr(said, "abstains") else said.breaks.how)
        return said.result


for name in "mass bounds broad_phase distance penetration impulse pixel time_of_impact constraint".split():
    setattr(Exact, name, functools.partialmethod(Exact.ask, name))
exact = Exact()
