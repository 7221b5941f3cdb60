"""How small trees of a kitchen begin: what comes to the stove, what is filled and turned on."""

from __future__ import annotations

POT = "pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)\n"
PAN = "pan (empty) + stove (off) → PUT → pan (empty; on stove) + stove (off; under pan)\n"
MILK = "milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)\n"
OIL = "oil (liquid; in bottle) + pan (empty; on stove) → POUR → oil (liquid; in pan) + pan ({oil}; on stove)\n"
ON = "stove (off; under pot) → TURN ON → stove (on; under pot)\n"
OFF = "stove (on; under pot) → TURN OFF → stove (off; under pot)\n"
BOIL = "milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → BOIL → milk (boiling; in pot)\n"
JAR = "blender jar (empty) + blender (off) → ATTACH → blender jar (empty; attached to blender) + blender (off)\n"
FILL = "milk (liquid; in carton) + blender jar (empty) → POUR → milk (liquid; in blender jar) + blender jar ({milk})\n"
BLEND = "milk (liquid; in blender jar) + blender jar ({milk}) + blender (on) → BLEND → milk (blended; in blender jar)\n"
HEATED = "\n" + POT + ON
