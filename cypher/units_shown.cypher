// Which videos show each of the asked units; no row for a unit that the graph does not have.
// param: keys LIST<STRING>
// column: key
// column: videos
// mode: read
UNWIND $keys AS key
MATCH (m:Motion {key: key})
RETURN m.key AS key, COLLECT { MATCH (m)-[:SEEN_IN]->(v:Video) RETURN DISTINCT v.name ORDER BY v.name } AS videos
