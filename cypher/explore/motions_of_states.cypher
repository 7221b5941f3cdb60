// How foods get into each state: the motion that most often makes it, in how many of the units that make it.
// column: state
// column: motion
// column: units
// column: of
// mode: read
// scans: all states are asked for
MATCH (s:State)-[made:MADE_BY]->(v:Verb)
WITH s.name AS state, v.name AS motion, made.count AS units
ORDER BY units DESC, motion
WITH state, collect(motion)[0] AS motion, max(units) AS units, sum(units) AS of
RETURN state, motion, units, of
ORDER BY units DESC, state
