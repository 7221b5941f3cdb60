// How much the FOON holds: counts of videos, units, object nodes, their labels and their states; how many units each
// verb has, how many goal nodes each dish type has, and which verb makes which state how often. States are counted by each
// load (count_states); where none has counted them, all object nodes are looked at.
// column: videos
// column: units
// column: object_nodes
// column: labels
// column: states
// column: verbs
// column: goals
// column: motions
// mode: read
// scans: all words are counted
MATCH (f:Foon {name: 'foon-kg'})
RETURN
  COUNT { (:Video) } AS videos,
  COUNT { (:Motion) } AS units,
  COUNT { (:Object) } AS object_nodes,
  COUNT { (:Label) } AS labels,
  coalesce(size(f.states), 0) + COUNT {
    UNWIND CASE WHEN f.states IS NULL THEN [f] ELSE [] END AS uncounted
    MATCH (o:Object)
    UNWIND o.states AS state
    RETURN DISTINCT state
  } AS states,
  COLLECT { MATCH (v:Verb) WHERE v.units > 0 RETURN [v.name, v.units] } AS verbs,
  COLLECT { MATCH (d:DishType)<-[:IS_A]-(o:Object) WITH d, count(DISTINCT o) AS goals RETURN [d.name, goals] } AS goals,
  COLLECT { MATCH (s:State)-[r:MADE_BY]->(v:Verb) RETURN [s.name, v.name, r.count] } AS motions
