// Makes the functional units that are not there yet, with their edges and the weights of their motions (load_costs), and
// names them. Each key may be named once.
// param: units LIST<MAP>
// column: key
// mode: write
MATCH (f:Foon {name: 'foon-kg'})
UNWIND $units AS row
MERGE (m:Motion {key: row.key})
  ON CREATE SET m.verb = row.verb, m.accepts_any = row.accepts_any,
    m.cost = [i IN range(0, size(coalesce(f.costs, [])) - 1) WHERE f.cost_motions[i] = row.verb | f.costs[i]][0]
WITH m, row
WHERE NOT EXISTS { (m)-[:OUTPUTS]->() }
CALL (m, row) {
  UNWIND row.inputs AS key
  MATCH (o:Object {key: key})
  CREATE (o)-[:INPUT_OF]->(m)
}
CALL (m, row) {
  UNWIND row.outputs AS key
  MATCH (o:Object {key: key})
  CREATE (m)-[:OUTPUTS]->(o)
}
RETURN row.key AS key
