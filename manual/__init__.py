"""The documentation as a site: ``python -m manual`` turns ``docs`` and the code into pages that open offline."""
