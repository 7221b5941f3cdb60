// The tasks that videos share: units that two or more videos show one right after the other, the longest runs first.
// param: least INTEGER
// param: most INTEGER
// default: least=3
// default: most=10
// column: steps
// column: motions
// column: foods
// column: videos
// mode: read
// scans: which videos share anything is known only from all of them
MATCH (a:Video)<-[one:SEEN_IN]-(m:Motion)-[two:SEEN_IN]->(b:Video)
WHERE a.name < b.name
WITH a.name AS first, b.name AS second, one.position - two.position AS apart, one.position AS step, m
ORDER BY first, second, apart, step
WITH first, second, apart, collect({step: step, unit: m}) AS shared
UNWIND range(0, size(shared) - 1) AS place
WITH first, second, apart, shared[place] AS it, shared[place].step - place AS run, place ORDER BY place
WITH first, second, apart, run, collect(it.unit) AS units
WHERE size(units) >= $least
UNWIND [first, second] AS video
WITH units, video ORDER BY video
WITH units, collect(DISTINCT video) AS videos
RETURN size(units) AS steps, [m IN units | m.verb] AS motions, COLLECT {
  UNWIND units AS m
  MATCH (o:Object)-[:INPUT_OF]->(m)
  WHERE EXISTS { MATCH (:Ingredient {name: o.label})-[:SEEN_AS]->() }
  RETURN DISTINCT o.label ORDER BY o.label
} AS foods, videos
ORDER BY steps DESC, size(videos) DESC, videos, motions
LIMIT $most
