// The keys of every unit that may take part in making the asked nodes, or any node of the asked foods in the asked
// states: their producers, the producers of what those take in, and so on. Where the kitchen has a node, nobody needs to
// make it.
// One search goes from the record of the FOON through the labels of what was asked, so that the work is linear in the
// answer however many nodes are asked for: a search from each of them walks shared parts again and again. The hints keep
// the plan what it is on a graph whose counts are young or odd: an index read whole would be no search any more.
// param: nodes LIST<STRING>
// param: foods LIST<MAP>
// column: keys
// mode: read
CALL () {
  UNWIND $nodes AS key
  MATCH (o:Object {key: key})
  USING INDEX SEEK o:Object(key)
  RETURN o
  UNION
  UNWIND $foods AS food
  MATCH (o:Object {label: food.label})
  USING INDEX SEEK o:Object(label)
  WHERE food.state IN o.states OR (food.state = '' AND size(o.states) = 0)
  RETURN o
}
WITH collect(o.key) AS asked, collect(DISTINCT o.label) AS labels
MATCH path = (record:Foon {name: 'foon-kg'})<-[:LABEL_OF|CALLED|OUTPUTS|INPUT_OF*1..]-(m)
USING INDEX SEEK record:Foon(name)
WHERE all(r IN relationships(path) WHERE
  CASE type(r)
    WHEN 'LABEL_OF' THEN startNode(r).name IN labels
    WHEN 'CALLED' THEN startNode(r).key IN asked
    WHEN 'INPUT_OF' THEN startNode(r).start IS NULL
    ELSE true
  END)
WITH DISTINCT m
WHERE m:Motion
RETURN collect(m.key) AS keys
