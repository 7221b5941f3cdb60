// Of every frame what tells whether it is worth a closer look: its dish type and label, the foods and kinds that join it, and
// its ends, which are how the dish is heated last, and in what.
// column: frames
// mode: read
// scans: all frames are asked for
MATCH (f:Frame)
RETURN collect([f.key, f.dish_type, f.label, f.foods, f.kinds, f.ends]) AS frames
