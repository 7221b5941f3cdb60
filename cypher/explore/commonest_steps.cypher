// The units that the most videos show: the steps that cooking has in common.
// param: most INTEGER
// default: most=10
// column: motion
// column: inputs
// column: videos
// mode: read
// scans: the most of all cannot be known without a look at all
MATCH (m:Motion)-[:SEEN_IN]->(v:Video)
WITH m, count(DISTINCT v) AS videos
ORDER BY videos DESC, m.verb, m.key
LIMIT $most
RETURN m.verb AS motion,
  COLLECT { MATCH (o)-[:INPUT_OF]->(m) RETURN DISTINCT o.label ORDER BY o.label } AS inputs, videos
ORDER BY videos DESC, motion, m.key
