// Writes down each place where a unit was seen, with all that its video says about it: the time, and for either side
// the ranks of its object nodes in the order of annotation, which of them move, and their dish classes.
// param: sightings LIST<MAP>
// mode: write
UNWIND $sightings AS row
MATCH (m:Motion {key: row.unit}), (v:Video {name: row.video})
CREATE (m)-[s:SEEN_IN]->(v)
SET s = row.properties
