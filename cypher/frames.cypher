// Of every frame the outline, which tells whether it is worth a closer look: its dish type and label, the foods and kinds that
// join it, and its ends. It is one text: to read six properties of each frame takes three times the db hits.
// column: frames
// mode: read
// scans: all frames are asked for
MATCH (f:Frame)
RETURN collect(f.outline) AS frames
