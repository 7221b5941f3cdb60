// All frames: of each what tells whether it is worth a closer look, its goal and video, and the text from which it is read.
// Of foods and kinds those that join it; its ends are how the dish is heated last, and in what.
// column: frames
// mode: read
// scans: all frames are asked for
MATCH (o:Object)<-[:OF]-(f:Frame)-[:DERIVED_FROM]->(v:Video)
RETURN collect([f.key, f.dish_type, f.label, f.foods, f.kinds, f.ends, o.key, v.name, f.text]) AS frames
