"""Prints "ok" or "bad" for each line on stdin, by docs/protocol.schema.json. Its argument is the folder docs/."""
import json
import pathlib
import sys

import jsonschema

docs = pathlib.Path(sys.argv[1])
schema = json.loads((docs / "protocol.schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
resolver = jsonschema.RefResolver((docs / "protocol.schema.json").as_uri(), schema)
validator = jsonschema.Draft202012Validator(schema, resolver=resolver)
for line in sys.stdin:
    print("ok" if validator.is_valid(json.loads(line)) else "bad")
