"""Usage: schema_test.py SCHEMA PRINT_SCENES. The published schema accepts what we write and refuses what we refuse."""

import copy
import json
import pathlib
import subprocess
import sys

import jsonschema

HERE = pathlib.Path(__file__).parent


def patched(document, patch):
    """The operations add, replace and remove of RFC 6902."""
    root = {"": copy.deepcopy(document)}
    holder, key = root, ""
    for word in patch["path"].split("/")[1:]:
        holder = holder[key]
        key = int(word) if isinstance(holder, list) else word
    if patch["op"] == "remove":
        del holder[key]
    else:
        holder[key] = patch["value"]
    return root[""]


def main(schema_path, print_scenes):
    schema = json.loads(pathlib.Path(schema_path).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    good = json.loads((HERE / "good_scene.json").read_text())
    validator.validate(good)

    lines = subprocess.run([print_scenes], check=True, capture_output=True, text=True).stdout.splitlines()
    assert len(lines) >= 500, len(lines)
    for line in lines:
        validator.validate(json.loads(line))

    wrong = []
    for row in json.loads((HERE / "bad_scenes.json").read_text()):
        accepts = validator.is_valid(patched(good, row["patch"]))
        if accepts != row.get("beyond_schema", False):
            wrong.append(("accepts: " if accepts else "refuses: ") + row["message"])
    assert not wrong, "the schema\n" + "\n".join(wrong)


main(*sys.argv[1:])
