// Makes the functional units that are not there yet, with their edges and the weights of their motions (load_costs), and
// names them, all in one row. Each object comes with how many sightings show it moving, null for none; of units that are
// there load_movements adds these. Each key may be named once.
// param: units LIST<MAP>
// column: keys
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
UNWIND $units AS row
MERGE (m:Motion {key: row.key})
  ON CREATE SET m.verb = row.verb, m.accepts_any = row.accepts_any,
    m.cost = [i IN range(0, size(coalesce(f.costs, [])) - 1) WHERE f.cost_motions[i] = row.verb | f.costs[i]][0]
WITH m, row
WHERE NOT EXISTS { (m)-[:OUTPUTS]->() }
CALL (m, row) {
  UNWIND row.inputs AS one
  MATCH (o:Object {key: one[0]})
  CREATE (o)-[:INPUT_OF {moving: one[1]}]->(m)
}
CALL (m, row) {
  UNWIND row.outputs AS one
  MATCH (o:Object {key: one[0]})
  CREATE (m)-[:OUTPUTS {moving: one[1]}]->(o)
}
RETURN collect(row.key) AS keys
