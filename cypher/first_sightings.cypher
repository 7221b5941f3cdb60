// Where operators were first seen done to matters, and first seen to change them: most places each, by video and position.
// It is found out anew from all units that attest an operator: of each of its places the name and position are read, and
// the rest only of those that are told.
// param: pairs LIST<MAP>
// param: most INTEGER
// column: operator
// column: matter
// column: seen
// column: changes
// mode: read
UNWIND $pairs AS pair
MATCH (o:Operator {key: pair.operator})-[a:ATTESTED_BY]->(m:Motion)
WITH o, m, a, [matter IN a.done_to WHERE matter IN pair.matters] AS matters
WHERE size(matters) > 0
WITH o, m, matters, a.changes AS changed
MATCH (m)-[s:SEEN_IN]->(v:Video)
WITH o, matters, changed, s, v, v.name AS video, s.position AS position
ORDER BY video, position
UNWIND matters AS matter
WITH o, matter, collect([video, position, v, s])[..$most] AS seen,
  [one IN collect([matter IN changed, video, position, v, s]) WHERE one[0] | one[1..]][..$most] AS changes
RETURN o.key AS operator, matter,
  [one IN seen | [one[0], one[1], one[2].sources[0], one[3].start, one[3].end]] AS seen,
  [one IN changes | [one[0], one[1], one[2].sources[0], one[3].start, one[3].end]] AS changes
