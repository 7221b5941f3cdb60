"""Making a dish on a bench: foods are made ready, brought together stage by stage, worked on and served.

``cooking`` carries out the lines of a frame, one ``turns.Turn`` after the other. It asks the others:

* before the lines ``readying`` (cut and opened), ``precooking`` (what is cooked by itself, and how) and ``alone``,
  which does that;
* at a stage ``stages`` (what it would change), ``placing`` (in which vessel, on which appliance; by ``utensils`` and
  ``bakeware``), ``adding`` (what joins comes) and ``doing`` (what the stage does), or ``dipping``, ``steaming`` and
  ``stacking``;
* at the end ``serving``. Several of these are ``hands``: they share what they carry and work with.

What hands do is in few places: ``carrying`` brings foods from place to place (``bringing`` decides in which way, by
what ``consistency`` says of their form), ``water`` is for water, ``working`` works on what is in a vessel (``ways``
says how, ``outcome`` what comes of it), and ``rising``, ``cooling``, ``smoothing`` and ``taking_out`` do what they are
called.
"""
