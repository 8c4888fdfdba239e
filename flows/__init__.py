"""Flows of Prefect, and where they run.

Prefect loads jsonschema. Loaded first without its grammar of IRIs, which no flow names, it saves each process of a flow
over a second.
"""

from c4s.toolbox import schemas as schemas
