"""The documents of foon-kg. What the program itself reads of them is installed with it, as ``foon_kg.docs``."""
