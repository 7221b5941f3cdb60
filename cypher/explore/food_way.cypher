// The shortest way of food from one thing to another: the motions on it, and the things that it passes. It follows what is
// eaten, and vessels with food in them; knives and empty bowls, which nearly everything meets, are no shortcut.
// param: before STRING
// param: after STRING
// example: before=potato
// example: after=potato salad
// column: motions
// column: things
// mode: read
MATCH (start:Object {label: $before})
WHERE start.start IS NOT NULL
MATCH (end:Object {label: $after})
WHERE start <> end
MATCH way = shortestPath((start)-[:INPUT_OF|OUTPUTS*1..60]->(end))
WHERE all(n IN nodes(way) WHERE n:Motion OR n.utensil IS NULL OR size(n.ingredients) > 0)
WITH nodes(way) AS passed, length(way) AS steps, start, end
ORDER BY steps, start.key, end.key
LIMIT 1
RETURN [n IN passed WHERE n:Motion | n.verb] AS motions, [n IN passed WHERE n:Object | n.label] AS things
