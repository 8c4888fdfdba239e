"""``python -m bench.sbom [--run] [--out FILE]``: the bill of materials of c4s as CycloneDX 1.6 JSON, from the locks.

Each locked package stands with its version, the digests of its files and its licence, as the package that is installed
here tells it: ``required`` where ``requirements-run.lock`` holds it, else ``optional`` (extras, development), which
``--run`` leaves out. The same locks give the same bytes. Without ``--out`` it goes to standard output.
"""

from __future__ import annotations

import argparse
import json
import tomllib
import uuid
from importlib.metadata import Distribution, distributions
from pathlib import Path
from typing import Any, Final

from bench.locks import ROOT, RUN, WHOLE, Locked, locked, normal
from c4s.files import digest

_CLASSIFIER: Final = "License :: "


def bill(*, run_only: bool) -> dict[str, Any]:
    """The bill of materials."""
    here = {normal(one.name): one for one in distributions()}
    needed = {row.name for row in locked(RUN)}
    rows = locked(RUN if run_only else WHOLE)
    components = [_component(row, here.get(row.name), row.name in needed) for row in rows]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    own = {
        "type": "application",
        "bom-ref": "c4s",
        "name": project["name"],
        "version": project["version"],
        "description": project["description"],
        "licenses": [{"expression": project["license"]}],
    }
    return {
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, digest([own, components]))}",
        "version": 1,
        "metadata": {"component": own},
        "components": components,
    }


def _component(row: Locked, there: Distribution | None, needed: bool) -> dict[str, Any]:
    place = f"pkg:pypi/{row.name}@{row.version}"
    made = {
        "type": "library",
        "bom-ref": place,
        "name": row.name,
        "version": row.version,
        "scope": "required" if needed else "optional",
        "hashes": [{"alg": "SHA-256", "content": one} for one in row.hashes],
        "purl": place,
    }
    if licences := [] if there is None else licences_of(there):
        made["licenses"] = licences
    if row.marker:
        made["properties"] = [{"name": "c4s:installed-where", "value": row.marker}]
    return made


def licences_of(one: Distribution) -> list[dict[str, Any]]:
    """What a package says of its licence: an SPDX expression, else names, else the texts that it carries."""
    told = one.metadata.get_all("License-Expression") or []
    if told:
        return [{"expression": told[0]}]
    classified = [
        line.rpartition(" :: ")[2] for line in one.metadata.get_all("Classifier") or [] if _CLASSIFIER in line
    ]
    named = [line for line in one.metadata.get_all("License") or [] if "\n" not in line.strip() and line.strip()]
    names = [name for name in classified if name != "OSI Approved"] or named
    if names:
        return [{"license": {"name": name.strip()}} for name in dict.fromkeys(names)]
    files = one.metadata.get_all("License-File") or []
    texts = {name: one.read_text(f"licenses/{name}") or one.read_text(name) for name in files}
    return [{"license": {"name": name, "text": {"content": text}}} for name, text in texts.items() if text]


def main() -> int:
    """Write it."""
    parser = argparse.ArgumentParser(prog="python -m bench.sbom", description=__doc__)
    parser.add_argument("--run", action="store_true", help="only what runs c4s")
    parser.add_argument("--out", type=Path, help="file to write")
    given = parser.parse_args()
    text = json.dumps(bill(run_only=given.run), indent=1) + "\n"
    if given.out is None:
        print(text, end="")
    else:
        given.out.write_text(text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
