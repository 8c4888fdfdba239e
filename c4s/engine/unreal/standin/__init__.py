"""A stand-in for Epic's editor: its command line, its log, its crashes, around c4s's own ``unreal`` module.

It makes all that c4s does around an editor testable where there is none, and lets an operator rehearse a fleet of
workers before the first real one. ``python -m c4s.engine.unreal.standin`` installs it and makes content for it. It says
of itself that it is a stand-in, in its version and so in every file that it makes.
"""

__all__ = ["content", "install"]
