// The evidence that is kept for operators and matters: in how many units it is done, in how many it changes something, and
// where either was first seen.
// param: pairs LIST<MAP>
// column: kept
// mode: read
UNWIND $pairs AS pair
MATCH (o:Operator {key: pair.operator})
UNWIND pair.matters AS name
MATCH (m:Matter {name: name})
MATCH (o)-[d:DONE_TO]->(m)
RETURN collect([o.key, name, d.units, d.changed, d.seen, d.changes]) AS kept
