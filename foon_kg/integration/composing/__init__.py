"""What a dish is composed of beside its frame: parts made apart, coats, layers, what its name and title promise.

``called`` is the way through this room: by a technique of the tables (``techniques``, with ``assigning`` for which food
is for which part), else step by step as the name of the dish changes what its video does. Each other module is one such
step, and returns line and joins as they are where it has nothing to change. Before all that ``apart`` takes out of a
recipe what is made beside its dish (``components``, ``parts``); ``attaching`` puts that where it belongs.
"""
