"""The starter packs, made by parametric shapes: pack id to the module whose ``pack()`` specifies it."""

STARTER: dict[str, str] = {
    "c4s-office": "catalog.starter.office",
    "c4s-home": "catalog.starter.home",
    "c4s-harbour": "catalog.starter.harbour",
    "c4s-farm": "catalog.starter.farm",
}
