// Keeps reference trees that were retrieved, each as the answer to its question and tied to its goal.
// param: trees LIST<MAP>
// mode: write
UNWIND $trees AS row
MATCH (o:Object {key: row.goal})
MERGE (p:Plan {key: row.question})
SET p.grounds = row.grounds, p.units = row.units, p.gaps = row.gaps
MERGE (p)-[:ANSWERS]->(o)
