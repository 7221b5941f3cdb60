"""One food on its own, before it joins: how it is sold, what is asked of it, and what a cook owes it.

``preparation`` has what is asked of a food (``Want``); ``understanding`` reads it off the words of a recipe,
``entitled`` off title and type of the dish. ``preparer`` carries it out on a bench, by ``treating`` and ``cutting``.
"""
