"""Mathematics: every function of a file here is one of ``unreal.MathLibrary``."""
