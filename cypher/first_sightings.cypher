// Where operators were first seen done to matters, and first seen to change them: most places each, by video and position.
// It is found out anew from all units that attest an operator.
// param: pairs LIST<MAP>
// param: most INTEGER
// column: operator
// column: matter
// column: seen
// column: changes
// mode: read
UNWIND $pairs AS pair
MATCH (o:Operator {key: pair.operator})-[a:ATTESTED_BY]->(m:Motion)
WITH o, pair.matters AS asked, a, m
UNWIND a.done_to AS matter
WITH o, matter, matter IN a.changes AS is_changed, m, asked
WHERE matter IN asked
MATCH (m)-[s:SEEN_IN]->(v:Video)
WITH o, matter, is_changed, [v.name, s.position, v.sources[0], s.start, s.end] AS sighting
ORDER BY sighting[0], sighting[1]
WITH o, matter, collect(sighting)[..$most] AS seen, [one IN collect([is_changed, sighting]) WHERE one[0] | one[1]][..$most] AS changes
RETURN o.key AS operator, matter, seen, changes
