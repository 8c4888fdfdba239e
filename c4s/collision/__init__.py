"""Contacts, penetration depths and gaps from the collision bodies that a snapshot carries."""

from c4s.collision.contacts import Contact, ContactRule, contacts, scene_contacts
from c4s.collision.depth import NOISE_CM
from c4s.collision.gaps import gaps_below
from c4s.collision.scene import SceneBodies, scene_bodies

__all__ = [
    "NOISE_CM",
    "Contact",
    "ContactRule",
    "SceneBodies",
    "contacts",
    "depth",
    "gaps_below",
    "libraries",
    "lines",
    "mesh_body",
    "scene",
    "scene_bodies",
    "scene_contacts",
    "shape_cache",
    "shapes",
]
