"""Algorithm 1: which recorded dish a recipe is made like.

``asked`` is a recipe and ``recorded`` a dish of a video, each as the other is compared with it. ``choice`` is the way
through this room: it takes a shortlist of frames, has every food placed in each, and orders them by ``vetoes`` (what a
cook would never do) and then by ``score`` (what speaks for it and against). ``names`` says what the names of dishes
tell. Begin with ``choice``.
"""
