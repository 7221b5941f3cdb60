// Takes away the frames of the named videos, and answers them.
// param: names LIST<STRING>
// column: text
// mode: write
UNWIND $names AS name
MATCH (:Video {name: name})<-[:DERIVED_FROM]-(f:Frame)
WITH f, f.text AS text
CALL (f) {
  OPTIONAL MATCH (f)-[:HAS_STAGE|HAS_SLOT|JOINED_BY*1..]->(part)
  WITH f, collect(part) AS parts
  DETACH DELETE f
  WITH parts
  UNWIND parts AS part
  DETACH DELETE part
}
RETURN text
