"""Usage: engine.py TRICK [NAME [LOG]]. A subject that answers "1 m apart"; from its fifth query on it plays its trick,
"always_hangs" from its first. LOG gets a line for each trick that is played."""

import json
import os
import sys

trick, name = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "trickster"
asked = 0
for line in sys.stdin:
    message = json.loads(line)
    answer = {"seq": message["seq"], "result": {"verdict": "separated", "distance": 1.0}}
    if message["op"] == "stop":
        break
    if message["op"] == "start":
        answer = {"seq": message["seq"], "protocol": 1,
                  "card": {"name": name, "version": "0", "precision": "binary64", "answers": ["distance"]}}
    else:
        asked += 1
        if asked >= (1 if trick == "always_hangs" else 5):
            if len(sys.argv) > 3:
                with open(sys.argv[3], "a") as log:
                    print(trick, file=log)
            if trick == "dies":
                os._exit(3)
            while trick in ("hangs", "always_hangs"):
                pass
            if trick == "garbles":
                print("\x1b[31m<not json> & \"more\"", flush=True)
                continue
            if trick == "nan":
                answer["result"]["distance"] = float("nan")
    print(json.dumps(answer), flush=True)
