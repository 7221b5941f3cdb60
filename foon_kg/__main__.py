"""``python -m foon_kg``: the command line without its script."""

from foon_kg.cli import main

if __name__ == "__main__":
    main()
