"""The places of the suite ``open-190``: layout rules, and scenes written with them over the kits of the catalog."""
