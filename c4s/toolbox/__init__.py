"""The 25 tools, the gateway that serves them, budgets."""

__all__ = [
    "catalog",
    "client",
    "gateway",
    "gateway_run",
    "pictures",
    "refusal",
    "registry",
    "skill",
    "stdio",
    "workbench",
]
