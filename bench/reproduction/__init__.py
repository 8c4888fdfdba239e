"""The paper's printed numbers recomputed from each other through this project's own code.

    python -m bench.reproduction FOLDER [--all] [--json]

``FOLDER`` holds the restated values: ``tables/*.csv``, ``checks.csv`` with what is published, ``constants.yaml``. They
are loaded into a warehouse as trials are: where the paper prints a mean, every case of that group has it. The studies
then answer from that warehouse. Nothing of the folder is part of this project.
"""
