// Makes the videos, or gives those that are there their new content hash and sources.
// param: videos LIST<MAP>
// mode: write
UNWIND $videos AS row
MERGE (v:Video {name: row.name})
SET v.content = row.content, v.sources = row.sources
