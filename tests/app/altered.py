"""Usage: altered.py FACTOR. It answers as fast does, but each distance times FACTOR; with the word silent it abstains."""

import json
import os
import pathlib
import subprocess
import sys

FAST = pathlib.Path(os.environ["TOUCHSTONE_PROGRAM"]).parent.parent / "subjects/touchstone-subject-fast"

with subprocess.Popen([FAST], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as fast:
    for line in sys.stdin:
        fast.stdin.write(line)
        fast.stdin.flush()
        if json.loads(line)["op"] == "stop":
            break
        answer = json.loads(fast.stdout.readline())
        if "card" in answer:
            answer["card"].update(name="mine", answers=["distance"], knows_touching=False, work_limits=[])
        elif sys.argv[1] == "silent":
            answer = {"seq": answer["seq"], "abstains": "not today"}
        else:
            answer["result"] = {"distance": answer["result"]["distance"] * float(sys.argv[1])}
        print(json.dumps(answer), flush=True)
