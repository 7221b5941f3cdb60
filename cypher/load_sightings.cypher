// Writes down each place where the units of videos were seen, in their order, with all that a video says about it: the time,
// and for either side the ranks of its object nodes in the order of annotation, which of them move, and their dish classes.
// Ties each unit of a video to the one that follows it there; the first one's place in its file stands on the edge.
// param: videos LIST<MAP>
// mode: write
UNWIND $videos AS row
MATCH (v:Video {name: row.name})
CALL (v, row) {
  UNWIND range(0, size(row.sightings) - 1) AS place
  WITH v, place, row.sightings[place] AS one
  MATCH (m:Motion {key: one.unit})
  CREATE (m)-[s:SEEN_IN]->(v)
  SET s = one.properties
  WITH m, place
  ORDER BY place
  RETURN collect(m) AS motions
}
UNWIND range(0, size(motions) - 2) AS place
WITH row.name AS video, place, motions[place] AS one, motions[place + 1] AS other
CREATE (one)-[:NEXT {video: video, position: place}]->(other)
