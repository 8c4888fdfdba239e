"""Importing the benchmark's published task layout."""
