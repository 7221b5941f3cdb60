// Ties each unit of a video to the one that follows it there; the first one's place in its file stands on the edge.
// param: videos LIST<MAP>
// mode: write
UNWIND $videos AS row
UNWIND range(0, size(row.units) - 2) AS place
MATCH (one:Motion {key: row.units[place]}), (other:Motion {key: row.units[place + 1]})
CREATE (one)-[:NEXT {video: row.name, position: place}]->(other)
