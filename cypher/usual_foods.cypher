// Finds out anew which food operators are most often done to, and which they most often change: among those that they were
// before, and the first of those that have more now. Only where one that it was before has less now are all foods looked at.
// param: rows LIST<MAP>
// mode: write
UNWIND $rows AS row
MATCH (o:Operator {key: row.operator})
WITH o, row, [name IN [o.most_done, o.most_changed] WHERE name IS NOT NULL] AS before
WITH o, row, before, any(name IN before WHERE name IN row.less) AS again
WITH o, COLLECT {
  WITH o, again
  WHERE again
  MATCH (o)-[d:DONE_TO]->(m:Food)
  RETURN [m.name, d.units, d.changed]
} + COLLECT {
  WITH o, row, before, again
  WHERE NOT again
  UNWIND row.more + before AS name
  MATCH (m:Food&Matter {name: name})
  USING INDEX m:Matter(name)
  MATCH (m)<-[d:DONE_TO]-(o)
  RETURN DISTINCT [m.name, d.units, d.changed]
} AS foods
WITH o, COLLECT {
  UNWIND foods AS food
  RETURN food[0]
  ORDER BY food[1] DESC, food[0]
  LIMIT 1
} AS done, COLLECT {
  UNWIND foods AS food
  WITH food
  WHERE food[2] > 0
  RETURN food[0]
  ORDER BY food[2] DESC, food[0]
  LIMIT 1
} AS changed
SET o.most_done = done[0], o.most_changed = changed[0]
