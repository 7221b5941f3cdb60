// The shortest way of a food from one state to another, from raw to mashed potato: its motions, and what it is after
// each. Only nodes that are the food, or mix it with others, are on the way: a knife that was used twice is no shortcut.
// It begins with as few states as may be; with no state to begin with as it is at hand in a kitchen.
// param: food STRING
// param: after STRING
// param: before STRING
// example: food=potato
// example: after=boiled
// default: before=
// column: motions
// column: becomes
// mode: read
MATCH (one:Object {label: $food})
WHERE $before IN one.states OR ($before = '' AND one.start IS NOT NULL)
WITH collect(one) AS begun, min(size(one.states)) AS fewest
UNWIND [one IN begun WHERE size(one.states) = fewest] AS start
MATCH (end:Object {label: $food})
WHERE $after IN end.states AND start <> end AND NOT $after IN start.states
MATCH way = shortestPath((start)-[:INPUT_OF|OUTPUTS*1..60]->(end))
WHERE all(n IN nodes(way) WHERE n:Motion OR n.label = $food OR $food IN n.ingredients AND size(n.ingredients) > 1)
WITH way, nodes(way) AS passed, start, end
ORDER BY length(way), start.key, end.key
LIMIT 1
RETURN [n IN passed WHERE n:Motion | n.verb] AS motions,
  [n IN passed[1..] WHERE n:Object | n.label + CASE WHEN size(n.states) > 0 THEN ' (' + reduce(
    words = n.states[0], state IN n.states[1..] | words + ', ' + state) + ')' ELSE '' END] AS becomes
