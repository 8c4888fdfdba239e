"""Turns folders of mesh files made by others into packs."""
