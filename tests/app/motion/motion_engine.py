"""Usage: motion_engine.py TRICK. A subject that computes one ball above a table at z = 0, e = 1, g = 10, in closed
form. It plays its trick on queries that go beyond 1 s."""

import json
import math
import os
import sys

G = 10


def answer(scene):
    ball = scene["bodies"][0]
    low, start = ball["shape"]["radius"], ball["X_WB"]["p"]
    top = start[2] - low
    fall = math.sqrt(2 * top / G)
    speed = G * fall

    def state(body, p, v):
        return {"X_WB": {"p": p, "q": body["X_WB"]["q"]}, "velocity": {"v_WBcm": v, "w_WB": [0, 0, 0]}}

    def at(t):
        since = (t + fall) % (2 * fall)  # time since the last bounce; a bounce is at the start of each period
        height, up = since * (speed - G * since / 2), speed - G * since
        return state(ball, [start[0], start[1], low + height], [0, 0, up])

    rest = [state(body, body["X_WB"]["p"], [0, 0, 0]) for body in scene["bodies"][1:]]
    times = scene["motion"]["sample_times"]
    events = []
    while (2 * len(events) + 1) * fall <= times[-1]:
        events.append({"kind": "impact", "time": (2 * len(events) + 1) * fall, "a": 0, "b": 1,
                       "p_WC": [start[0], start[1], 0], "nhat_BA_W": [0, 0, 1], "P_A_W": [0, 0, 1],
                       "after_a": state(ball, [start[0], start[1], low], [0, 0, speed]), "after_b": rest[0]})
    return {"states": [[at(t), *rest] for t in times], "events": events}


trick = sys.argv[1]
for line in sys.stdin:
    message = json.loads(line)
    if message["op"] == "stop":
        break
    if message["op"] == "start":
        said = {"protocol": 1, "card": {"name": trick, "version": "0", "precision": "binary64", "answers": ["simulation"]}}
    elif trick == "abstains":
        said = {"abstains": "not on Sundays"}
    else:
        result = answer(message["scene"])
        if trick == "higher":
            for row in result["states"]:
                row[0]["X_WB"]["p"][2] += 0.25
        if message["scene"]["motion"]["sample_times"][-1] > 1:
            if trick == "dies":
                os._exit(3)
            while trick == "hangs":
                pass
            if trick == "short":
                result["states"].pop()
            if trick in ("gives_up", "silent_gives_up"):
                result["states"] = [row for t, row in zip(message["scene"]["motion"]["sample_times"], result["states"]) if t <= 1]
                result["complete_until"] = 1
            if trick.startswith("silent"):
                del result["events"]
        said = {"result": result}
    print(json.dumps({"seq": message["seq"], **said}), flush=True)
