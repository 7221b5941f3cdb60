"""What videos teach of making dishes: operators with their evidence, and frames derived from goals.

``frames`` says what a frame is: lines of stages with slots. ``derivation`` finds it in a video that is ``played`` in
the world, of ``lines`` that grow of what meets. ``operators`` are the ways in which things are done, with what attests
them; ``drafted_operators`` fills them up with what drafts of recipes say. ``forms`` says how a food is handled.
"""
