"""Brings scenes that people made elsewhere in as source scenes: a pack of their meshes and a level."""
