"""``python -m c4s.cli``: the command line."""

from c4s.cli.main import main

main()
