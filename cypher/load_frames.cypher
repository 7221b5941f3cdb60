// Makes frames: of each its stages, the lines that they are in, and the slots at which foods join them. Each frame may be
// named once. Stages are named by their place in the list; stages of one line follow one another.
// param: frames LIST<MAP>
// mode: write
UNWIND $frames AS row
MATCH (o:Object {key: row.goal}), (v:Video {name: row.video})
CREATE (f:Frame {key: row.key})-[:OF]->(o), (f)-[:DERIVED_FROM]->(v)
SET f += row.properties
WITH f, row
CALL (row) {
  UNWIND row.stages AS properties
  CREATE (s:Stage)
  SET s = properties
  RETURN collect(s) AS stages
}
CALL (f, row, stages) {
  UNWIND range(0, size(row.main) - 1) AS place
  WITH f, place, stages[row.main[place]] AS s
  CREATE (f)-[:HAS_STAGE {place: place}]->(s)
}
CALL (row, stages) {
  UNWIND row.lines AS line
  WITH line, stages, stages[line.stage] AS joined
  CREATE (joined)-[:JOINED_BY {place: line.place}]->(l:Line)
  WITH l, line, stages
  UNWIND range(0, size(line.stages) - 1) AS place
  WITH l, place, stages[line.stages[place]] AS s
  CREATE (l)-[:HAS_STAGE {place: place}]->(s)
}
CALL (row, stages) {
  UNWIND row.slots AS slot
  WITH slot, stages[slot.stage] AS joined
  MATCH (m:Matter {name: slot.properties.food})
  CREATE (joined)-[:HAS_SLOT {place: slot.place}]->(s:Slot)-[:TAKES]->(m)
  SET s = slot.properties
}
