// Takes the named videos' sightings away and names the units that were seen there.
// param: names LIST<STRING>
// column: key
// mode: write
UNWIND $names AS name
MATCH (:Video {name: name})<-[s:SEEN_IN]-(m:Motion)
DELETE s
RETURN DISTINCT m.key AS key
