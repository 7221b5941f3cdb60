// The reference tree that was retrieved for a question before, and what it was found on.
// param: question STRING
// column: question
// column: grounds
// column: goal
// column: units
// column: gaps
// mode: read
MATCH (p:Plan {key: $question})-[:ANSWERS]->(o:Object)
RETURN p.key AS question, p.grounds AS grounds, o.key AS goal, p.units AS units, p.gaps AS gaps
