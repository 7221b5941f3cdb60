// Takes the named videos' sightings away, and which step follows which there, and names the units that were seen there.
// param: names LIST<STRING>
// column: key
// mode: write
UNWIND $names AS name
MATCH (:Video {name: name})<-[s:SEEN_IN]-(m:Motion)
CALL (m, name) {
  MATCH (m)-[follows:NEXT {video: name}]->()
  DELETE follows
}
DELETE s
RETURN DISTINCT m.key AS key
