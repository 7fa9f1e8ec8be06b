"""Usage: larger_distances.py FAST DECLARED [FACTOR]. A subject that answers as FAST, the program of fast, does, but makes
distances larger by FACTOR, and by 2 where a hull has more than 6 vertices. DECLARED is added to its card, as JSON."""

import json
import subprocess
import sys

program, declared, factor = sys.argv[1], json.loads(sys.argv[2]), float((sys.argv + ["1"])[3])


def is_large(scene):
    return any(len(body["shape"].get("vertices", [])) > 6 for body in scene["bodies"])


with subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as fast:
    for line in sys.stdin:
        message = json.loads(line)
        if message["op"] == "reproduce":
            snippet = "ask <me> about %d bodies" % len(message["scene"]["bodies"])
            print(json.dumps({"seq": message["seq"], "snippet": snippet}), flush=True)
            continue
        fast.stdin.write(line)
        fast.stdin.flush()
        if message["op"] == "stop":
            break
        answer = json.loads(fast.stdout.readline())
        if "card" in answer:
            answer["card"].update(name="mine", answers=["distance"], knows_touching=False, reproduces=["distance"],
                                  work_limits=[])
            answer["card"].update(declared)
        elif "distance" in answer.get("result", ()):
            answer["result"] = {"distance": answer["result"]["distance"] * (2 if is_large(message["scene"]) else factor)}
        print(json.dumps(answer), flush=True)
