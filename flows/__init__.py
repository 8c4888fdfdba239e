"""Flows of Prefect, and where they run.

No flow names an IRI; the grammar of IRIs, which jsonschema and so Prefect load where it is installed, would take each
process of a flow over a second to make.
"""

import sys

sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
