// The evidence that is kept for operators and matters: where it was first seen done, and first seen to change something.
// param: pairs LIST<MAP>
// column: kept
// mode: read
UNWIND $pairs AS pair
MATCH (o:Operator {key: pair.operator})
UNWIND pair.matters AS name
MATCH (m:Matter {name: name})
MATCH (o)-[d:DONE_TO]->(m)
RETURN collect([o.key, name, d.seen, d.changes]) AS kept
