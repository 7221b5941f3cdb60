// How often each of the named foods is made and used in each state: each state once, with its foods and their counts
// side by side.
// param: names LIST<STRING>
// column: foods
// mode: read
RETURN COLLECT {
  UNWIND $names AS name
  MATCH (i:Ingredient {name: name})-[r:SEEN_AS]->(s:State)
  WITH s, collect(i.name) AS labels, collect(r.made) AS made, collect(r.used) AS used
  RETURN [s.name, labels, made, used]
} AS foods
