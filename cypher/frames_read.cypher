// Frames that are worth a closer look: of each the text from which it is read, and the videos that show a way to its goal.
// param: keys LIST<STRING>
// column: frames
// mode: read
UNWIND $keys AS key
MATCH (f:Frame {key: key})-[:OF]->(o:Object)
RETURN collect([f.key, f.text, COLLECT {
  MATCH (o)<-[:OF]-(other:Frame)-[:DERIVED_FROM]->(v:Video)
  WHERE other.dish_type = f.dish_type
  RETURN v.name
}]) AS frames
