"""Families of parametric things in styles: what the places of a large suite are furnished with."""
