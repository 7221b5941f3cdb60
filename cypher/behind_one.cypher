// What “behind” answers, for one node: the search begins at it, and so looks at no label; that of “behind”, which walks what
// several nodes share only once, looks at all labels of the FOON.
// param: node STRING
// column: keys
// mode: read
MATCH (o:Object {key: $node})
USING INDEX SEEK o:Object(key)
MATCH path = (o)<-[:OUTPUTS|INPUT_OF*1..]-(m)
WHERE all(r IN relationships(path) WHERE type(r) = 'OUTPUTS' OR startNode(r).start IS NULL)
WITH DISTINCT m
WHERE m:Motion
RETURN collect(m.key) AS keys
