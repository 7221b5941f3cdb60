"""Videos of six dishes as an annotator writes them, each with something that is easily derived wrong."""

from __future__ import annotations

MIXED_SALAD = """
name: mixed_salad
dish: salad
goal: salad (mixed; {cucumber, lemon, olive oil, salt, tomato}; in bowl)
tomato (whole) + cutting board (empty) + knife → DICE → tomato (diced; on cutting board) + cutting board ({tomato})
tomato (diced; on cutting board) + cutting board ({tomato}) + bowl (empty) → POUR
  → tomato (diced; in bowl) + bowl ({tomato}) + cutting board (empty)
cucumber (whole) + peeler → PEEL → cucumber (peeled)
cucumber (peeled) + cutting board (empty) + knife → SLICE
  → cucumber (sliced; on cutting board) + cutting board ({cucumber})
cucumber (sliced; on cutting board) + cutting board ({cucumber}) + bowl ({tomato}) → POUR
  → cucumber (sliced; in bowl) + bowl ({cucumber, tomato}) + cutting board (empty)
lemon (whole) + knife → CUT → lemon (halved)
lemon (halved) + cup (empty) + squeezer → SQUEEZE → lemon (juice; in cup) + cup ({lemon})
olive oil (liquid; in bottle) + cup ({lemon}) → POUR → olive oil (liquid; in cup) + cup ({lemon, olive oil})
salt (granulated; in shaker) + cup ({lemon, olive oil}) → SPRINKLE
  → salt (granulated; in cup) + cup ({lemon, olive oil, salt})
lemon (juice; in cup) + olive oil (liquid; in cup) + salt (granulated; in cup) + cup ({lemon, olive oil, salt}) + whisk
  → WHISK → dressing (mixed; {lemon, olive oil, salt}; in cup) + cup ({dressing})
dressing (mixed; {lemon, olive oil, salt}; in cup) + cup ({dressing}) + bowl ({cucumber, tomato}) → POUR
  → dressing (mixed; {lemon, olive oil, salt}; in bowl) + bowl ({cucumber, dressing, tomato}) + cup (empty)
tomato (diced; in bowl) + cucumber (sliced; in bowl) + dressing (mixed; {lemon, olive oil, salt}; in bowl)
  + bowl ({cucumber, dressing, tomato}) + spoon → MIX
  → salad (mixed; {cucumber, lemon, olive oil, salt, tomato}; in bowl) + bowl ({salad})
"""

BAKED_BATTER = """
name: plain_cake
dish: cake
goal: cake (baked; {butter, egg, flour, sugar}; in baking tray)
butter (stick; in packet) + baking tray (empty) + brush → BRUSH
  → butter (in baking tray) + baking tray ({butter})
flour (powder; in bag) + bowl (empty) → POUR → flour (powder; in bowl) + bowl ({flour})
sugar (granulated; in bag) + bowl ({flour}) → POUR → sugar (granulated; in bowl) + bowl ({flour, sugar})
egg (whole) + bowl ({flour, sugar}) → CRACK → egg (cracked; in bowl) + bowl ({egg, flour, sugar})
flour (powder; in bowl) + sugar (granulated; in bowl) + egg (cracked; in bowl) + bowl ({egg, flour, sugar}) + whisk
  → WHISK → batter (mixed; {egg, flour, sugar}; in bowl) + bowl ({batter})
batter (mixed; {egg, flour, sugar}; in bowl) + bowl ({batter}) + baking tray ({butter}) → POUR
  → batter (mixed; {egg, flour, sugar}; in baking tray) + baking tray ({batter, butter}) + bowl (empty)
oven (off) → TURN ON → oven (on)
baking tray ({batter, butter}) + oven (on) → PUT INSIDE
  → baking tray ({batter, butter}; in oven) + oven (on; {baking tray})
batter (mixed; {egg, flour, sugar}; in baking tray) + butter (in baking tray)
  + baking tray ({batter, butter}; in oven) + oven (on; {baking tray}) → BAKE
  → cake (baked; {butter, egg, flour, sugar}; in baking tray) + baking tray (hot; {cake}; in oven)
"""

BOILED_PASTA = """
name: pasta_with_sauce
dish: pasta
goal: pasta (cooked; {garlic, olive oil, pasta, tomato}; in bowl)
water (liquid; from faucet) + pot (empty) → FILL → water (liquid; in pot) + pot ({water})
pot ({water}) + stove (off) → PICK-AND-PLACE → pot ({water}; on stove) + stove (off; under pot)
stove (off; under pot) → TURN ON → stove (on; under pot)
pasta (dried; in box) + pot ({water}; on stove) → POUR → pasta (dried; in pot) + pot ({pasta, water}; on stove)
pasta (dried; in pot) + water (liquid; in pot) + pot ({pasta, water}; on stove) + stove (on; under pot) → BOIL
  → pasta (boiled; in pot) + water (hot; in pot) + pot (hot; {pasta, water}; on stove)
pasta (boiled; in pot) + pot (hot; {pasta, water}; on stove) + strainer (empty) → DRAIN
  → pasta (boiled; in strainer) + strainer ({pasta}) + pot (empty; on stove)
stove (on; under pot) → TURN OFF → stove (off; under pot)
tomato (whole) + cutting board (empty) + knife → DICE → tomato (diced; on cutting board) + cutting board ({tomato})
olive oil (liquid; in bottle) + pan (empty) → POUR → olive oil (liquid; in pan) + pan ({olive oil})
pan ({olive oil}) + stove (off) → PICK-AND-PLACE → pan ({olive oil}; on stove) + stove (off; under pan)
stove (off; under pan) → TURN ON → stove (on; under pan)
tomato (diced; on cutting board) + cutting board ({tomato}) + pan ({olive oil}; on stove) → POUR
  → tomato (diced; in pan) + pan ({olive oil, tomato}; on stove) + cutting board (empty)
garlic (minced; in jar) + pan ({olive oil, tomato}; on stove) → POUR
  → garlic (minced; in pan) + pan ({garlic, olive oil, tomato}; on stove)
tomato (diced; in pan) + garlic (minced; in pan) + olive oil (liquid; in pan)
  + pan ({garlic, olive oil, tomato}; on stove) + stove (on; under pan) + spoon → COOK
  → sauce (cooked; {garlic, olive oil, tomato}; in pan) + pan (hot; {sauce}; on stove)
stove (on; under pan) → TURN OFF → stove (off; under pan)
pasta (boiled; in strainer) + strainer ({pasta}) + bowl (empty) → POUR
  → pasta (boiled; in bowl) + bowl ({pasta}) + strainer (empty)
sauce (cooked; {garlic, olive oil, tomato}; in pan) + pan (hot; {sauce}; on stove) + bowl ({pasta}) → POUR
  → sauce (cooked; {garlic, olive oil, tomato}; in bowl) + bowl ({pasta, sauce}) + pan (empty; on stove)
pasta (boiled; in bowl) + sauce (cooked; {garlic, olive oil, tomato}; in bowl) + bowl ({pasta, sauce}) + spoon → MIX
  → pasta (cooked; {garlic, olive oil, pasta, tomato}; in bowl) + bowl ({pasta})
"""

SANDWICH = """
name: tomato_sandwich
dish: sandwich
goal: sandwich ({bread, butter, cheese, tomato}; on plate)
bread (sliced; in bag) + plate (empty) → PICK-AND-PLACE → bread (sliced; on plate) + plate ({bread})
butter (creamy; in jar) + bread (sliced; on plate) + plate ({bread}) + knife → SPREAD
  → butter (creamy; on bread) + bread (sliced; {butter}; on plate) + plate ({bread, butter})
cheese (block) + cutting board (empty) + knife → SLICE → cheese (sliced; on cutting board) + cutting board ({cheese})
cheese (sliced; on cutting board) + bread (sliced; {butter}; on plate) + plate ({bread, butter}) → PICK-AND-PLACE
  → cheese (sliced; on bread) + bread (sliced; {butter, cheese}; on plate) + plate ({bread, butter, cheese})
tomato (whole) + cutting board (empty) + knife → SLICE → tomato (sliced; on cutting board) + cutting board ({tomato})
tomato (sliced; on cutting board) + bread (sliced; {butter, cheese}; on plate) + plate ({bread, butter, cheese})
  → PICK-AND-PLACE
  → sandwich ({bread, butter, cheese, tomato}; on plate) + plate ({sandwich})
"""

ROLL = """
name: rolling
tortilla (plain; on plate) + ham (sliced; on plate) + plate ({ham, tortilla}) → ROLL
  → ham roll (rolled; {ham, tortilla}; on plate) + plate ({ham roll})
"""

DRINK = """
name: banana_drink
dish: drinks
goal: smoothie (blended; {banana, honey, milk}; in glass)
banana (whole) → PEEL → banana (peeled)
banana (peeled) + cutting board (empty) + knife → SLICE → banana (sliced; on cutting board) + cutting board ({banana})
banana (sliced; on cutting board) + blender jar (empty) → POUR
  → banana (sliced; in blender jar) + blender jar ({banana})
milk (liquid; in carton) + blender jar ({banana}) → POUR → milk (liquid; in blender jar) + blender jar ({banana, milk})
honey (liquid; in bottle) + blender jar ({banana, milk}) → POUR
  → honey (liquid; in blender jar) + blender jar ({banana, honey, milk})
blender jar ({banana, honey, milk}) + blender (off) → ATTACH
  → blender jar ({banana, honey, milk}; attached to blender) + blender (off; with blender jar)
blender (off; with blender jar) → TURN ON → blender (on; with blender jar)
banana (sliced; in blender jar) + milk (liquid; in blender jar) + honey (liquid; in blender jar)
  + blender jar ({banana, honey, milk}; attached to blender) + blender (on; with blender jar) → BLEND
  → smoothie (blended; {banana, honey, milk}; in blender jar) + blender jar ({smoothie}; attached to blender)
blender (on; with blender jar) → TURN OFF → blender (off; with blender jar)
blender jar ({smoothie}; attached to blender) + blender (off; with blender jar) → DETACH
  → blender jar ({smoothie}) + blender (off)
smoothie (blended; {banana, honey, milk}; in blender jar) + blender jar ({smoothie}) + glass (empty) → POUR
  → smoothie (blended; {banana, honey, milk}; in glass) + glass ({smoothie}) + blender jar (empty)
"""

SOUP_WITHOUT_HEAT = """
name: forgetful_soup
dish: soup
goal: soup (cooked; {onion, potato, salt, water}; in pot)
pot (empty) + stove (on) → PICK-AND-PLACE → pot (empty; on stove) + stove (on; under pot)
water (liquid; from faucet) + pot (empty; on stove) → POUR → water (liquid; in pot) + pot ({water}; on stove)
potato (whole) + peeler → PEEL → potato (peeled)
potato (peeled) + cutting board (empty) + knife → DICE → potato (diced; on cutting board) + cutting board ({potato})
potato (diced; on cutting board) + cutting board ({potato}) + pot ({water}; on stove) → POUR
  → potato (diced; in pot) + pot ({potato, water}; on stove) + cutting board (empty)
onion (whole) + cutting board (empty) + knife → CHOP → onion (chopped; on cutting board) + cutting board ({onion})
onion (chopped; on cutting board) + cutting board ({onion}) + pot ({potato, water}; on stove) → POUR
  → onion (chopped; in pot) + pot ({onion, potato, water}; on stove) + cutting board (empty)
salt (granulated; in shaker) + pot ({onion, potato, water}; on stove) → SPRINKLE
  → salt (granulated; in pot) + pot ({onion, potato, salt, water}; on stove)
water (liquid; in pot) + potato (diced; in pot) + onion (chopped; in pot) + salt (granulated; in pot)
  + pot ({onion, potato, salt, water}; on stove) + spoon → STIR
  → soup (cooked; {onion, potato, salt, water}; in pot) + pot ({soup}; on stove)
"""

ALL = (MIXED_SALAD, BAKED_BATTER, BOILED_PASTA, SANDWICH, DRINK, SOUP_WITHOUT_HEAT)
