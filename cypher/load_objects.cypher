// Makes the object nodes that are not there yet. Each key may be named once.
// param: objects LIST<MAP>
// mode: write
UNWIND $objects AS row
MERGE (o:Object {key: row.key})
  ON CREATE SET o.label = row.label, o.states = row.states, o.ingredients = row.ingredients,
    o.relation = row.relation, o.container = row.container, o.start = row.start
