"""Where each asked food joins a dish: the stages of a frame as spots, and the phases of an open pot or pan.

``spots`` has what all others speak of: a stage of a frame, and the join of one food at it. ``layouts`` are frames as
places, read once; ``places`` finds for each food of a recipe (``joiners``) the likeliest one, by how often foods of its
kind join where (``joining_counts``), and ``rearranging`` what one food changes for others. ``course`` is the plan that
results, ``phases`` its order over the heat, of the ``additions`` to each vessel. ``batters`` come together in their own
way; ``patterns`` are stages that no video has to show. Begin with ``spots`` and ``places``.
"""
